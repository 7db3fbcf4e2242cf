/// Scenes that nobody would draw: valid, but with everything that breaks lighting programs, at random.
#pragma once

#include "engine/plan/settings.h"
#include "engine/scene/scene.h"

#include <cstdint>
#include <random>

namespace hanei::test {

/// The same throws on every machine (the standard's distributions are not).
class Dice {
public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    double in(double low, double high) { return low + (high - low) * share(); }
    double logarithmic(double low, double high);
    int below(int count) { return static_cast<int>(share() * count); }
    bool chance(double p) { return share() < p; }
    Vec3 in_box(const Vec3& low, const Vec3& high) {
        const double x = in(low.x, high.x), y = in(low.y, high.y);
        return {x, y, in(low.z, high.z)};
    }
    Vec3 direction();
    template <class T>
    T pick(std::initializer_list<T> list) {
        return *(list.begin() + below(static_cast<int>(list.size())));
    }

private:
    double share() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    std::mt19937_64 engine_;
};

/// A scene that check_scene finds no error in; warnings are usual. Now and then: no room, boxes that
/// touch, nest, overlap or leave a gap of a micrometre, sheets, slivers, duplicates, coplanar overlaps,
/// every kind of opening and distribution, flush with the ceiling, above it or inside furniture, points
/// on edges and in the planes of sources, a scene of millimetres or of kilometres, 1e5 m from the origin.
///
/// Holds     the same scene for the same seed. Some 5 objects and 10 places of calculation.
Scene random_scene(std::uint64_t seed);

/// The same kind of scene, whose luminaires hang clear of walls, ceiling and furniture, and rooms hold
/// no sheets: all of their light falls on surfaces that count it, or gets out.
Scene random_scene_of_free_luminaires(std::uint64_t seed);

/// Settings for it, of any method; patches a third to a twelfth of the scene wide.
Settings random_settings(std::uint64_t seed, const Scene& scene);

/// The greatest side of the box around all places of a scene.
double extent_of(const Scene& scene);

/// Every place stretched and then moved; fluxes stretched so that illuminances stay.
void move_and_stretch(Scene& scene, const Vec3& by, double scale);

// Its parts, each adding objects to a scene in metres near the origin.
void add_random_furniture(Scene& scene, Dice& dice, const Vec3& size);
void add_random_surfaces(Scene& scene, Dice& dice, const Vec3& size);
void add_random_luminaires(Scene& scene, Dice& dice, const Vec3& size);

}  // namespace hanei::test
