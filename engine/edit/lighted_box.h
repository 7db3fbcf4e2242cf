/// The light of one luminaire in an empty box of a room: what the lumen method reckons with.
#pragma once

#include "engine/edit/box_balance.h"
#include "engine/edit/intensity_of.h"
#include "engine/edit/lumen_method.h"
#include "engine/scene/placement.h"

#include <vector>

namespace hanei {

class LightedBox {
public:
    /// Needs     a room with a plan; the luminaire as it is mounted. Both outlive the box.
    LightedBox(const Scene& scene, const Luminaire& luminaire, const LumenWish& wish);

    double height() const { return lamp_ - plane_; }  ///< m, from the working plane to the luminaire
    double flux() const { return candela_.flux(); }
    Vec2 sides() const { return sides_; }  ///< of the rectangle of the plan's area and circumference
    double area() const { return sides_.x * sides_.y; }

    struct Light {
        double to_plane = 0.0;    ///< lm straight through the whole working plane, of one luminaire
        double reflected = 0.0;   ///< lm that reach it by way of surfaces
        double direct_lux = 0.0;  ///< mean over the plane within its border, of one luminaire
    };
    /// Of luminaires at these places (x and y from a corner of the box), on the mean.
    Light from(const std::vector<Vec2>& places) const;

private:
    struct Beam {
        Vec3 direction{0.0};
        double flux = 0.0;
    };
    void shoot();
    void land(const Beam& beam, const Vec2& place, double share, BoxBalance::Direct& direct, Light& light) const;
    double direct_within_border(const std::vector<Vec2>& places) const;
    double lux(const Vec3& way) const;

    IntensityOf candela_;
    Placement turned_;
    double border_;
    Vec2 sides_{1.0};
    double top_ = 0.0, plane_ = 0.0, lamp_ = 0.0;  ///< m above the floor
    BoxBalance::Reflectances reflectances_;
    std::vector<double> borders_;
    std::vector<Beam> beams_;
};

}  // namespace hanei
