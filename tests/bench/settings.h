/// Settings whose shadows are timed: two ceiling panels over receivers among many convex bodies.
#pragma once

#include "engine/direct/direct.h"

#include <string>
#include <vector>

namespace hanei::bench {

/// A panel's middle; it is `panel_width` along x, `panel_depth` along y, and faces down.
inline constexpr double panel_width = 1.2;
inline constexpr double panel_depth = 0.6;

/// What a point sees of an emitter, and what it gets.
struct Light {
    double unobstructed = 0.0;  ///< lx
    double arriving = 0.0;      ///< lx
};

/// Receivers lie on the floor and the desk plane, outside every body, two thousand or fewer. Pairs of
/// a receiver and an emitter are numbered: pair k is receiver k / 2 and emitter k % 2.
struct Setting {
    std::vector<Vec3> panels;
    std::vector<Emitter> emitters;
    OccluderSet occluders;
    std::vector<Receiver> receivers;
    std::vector<Light> lights;  ///< one a pair, exact
    double brightest = 0.0;     ///< lx, the greatest unobstructed value: what errors are relative to
    double umbra = 0.0, penumbra = 0.0, lit = 0.0;  ///< shares of the pairs

    std::size_t pairs() const { return 2 * receivers.size(); }
    const Receiver& receiver(std::size_t pair) const { return receivers[pair / 2]; }
    const Emitter& emitter(std::size_t pair) const { return emitters[pair % 2]; }
};

/// A room of 6 x 4 x 2.8 m with `count` boxes of 0.1 to 0.7 m, turned at random. Above 600 boxes the
/// room is a hall that grows with their number, so that as many stand on a square metre as in a room
/// of 150, and the receivers stay within 3 m of the panels. Made once, the same on every machine.
const Setting& among_boxes(int count);

/// The same room with `count` sticks of 1 m x 2 cm x 2 cm floating in it.
const Setting& among_sticks(int count);

}  // namespace hanei::bench
