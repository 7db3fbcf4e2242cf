/// Copies of objects in rows and circles, and mirror images.
#pragma once

#include "engine/edit/excerpt.h"

namespace hanei {

/// Rows and columns of copies; the objects themselves are the first of the first row.
struct ArrayWish {
    int columns = 3, rows = 1;           ///< 1 or more; no more than most_copies together
    Vec3 column_step{1.5, 0.0, 0.0};     ///< m, from one column to the next
    Vec3 row_step{0.0, 1.5, 0.0};        ///< m, from one row to the next
    bool operator==(const ArrayWish&) const = default;
};
inline constexpr int most_copies = 1000;

AddedSeveral arrayed(const Scene& scene, std::span<const ObjectId> chosen, const ArrayWish& wish);

/// Copies around a vertical axis; the objects themselves are the first.
struct CircleWish {
    int count = 6;
    Vec2 middle{0.0};
    double angle = 6.283185307179586;  ///< rad, from the first to beyond the last: a whole turn closes the circle
    bool turns = true;                 ///< each is turned with its place
    bool operator==(const CircleWish&) const = default;
};
AddedSeveral circled(const Scene& scene, std::span<const ObjectId> chosen, const CircleWish& wish);

enum class MirrorAxis { x, y };  ///< which coordinate changes its sign

/// The objects' mirror image about the plane at `at` m. Sizes and windings stay sound. Library furniture
/// that looks the same from left and right keeps its model; other furniture is mirrored part by part.
///
/// Weak when a measured luminaire's light is not symmetric about its plane C0 or C90: its housing is
///           mirrored and its light turned, as the luminaire itself would have to be.
Scene mirrored(Scene scene, std::span<const ObjectId> chosen, MirrorAxis axis, double at);

/// The same as copies.
AddedSeveral with_mirror_image(const Scene& scene, std::span<const ObjectId> chosen, MirrorAxis axis, double at);

}  // namespace hanei
