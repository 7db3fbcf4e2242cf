#include "engine/edit/copies.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

/// Joins one copy and what to choose of it.
void join(AddedSeveral& all, const Scene& original, const Vec3& by) {
    AddedSeveral next = with_excerpt(std::move(all.scene), original, by);
    all.scene = std::move(next.scene);
    all.objects.insert(all.objects.end(), next.objects.begin(), next.objects.end());
}

AddedSeveral begun(const Scene& scene, std::span<const ObjectId> chosen) {
    return {scene, ObjectIds(chosen.begin(), chosen.end())};
}

}  // namespace

AddedSeveral arrayed(const Scene& scene, std::span<const ObjectId> chosen, const ArrayWish& wish) {
    AddedSeveral all = begun(scene, chosen);
    const Scene original = excerpt(scene, chosen);
    const int columns = std::clamp(wish.columns, 1, most_copies);
    const int rows = std::clamp(wish.rows, 1, std::max(1, most_copies / columns));
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            if (row + column > 0)
                join(all, original,
                     static_cast<double>(column) * wish.column_step + static_cast<double>(row) * wish.row_step);
    return all;
}

AddedSeveral circled(const Scene& scene, std::span<const ObjectId> chosen, const CircleWish& wish) {
    AddedSeveral all = begun(scene, chosen);
    const std::optional<Vec3> middle = middle_of(scene, chosen);
    if (!middle) return all;
    const Scene original = excerpt(scene, chosen);
    const Vec3 pivot{wish.middle, 0.0};
    const int count = std::clamp(wish.count, 1, most_copies);
    for (int k = 1; k < count; ++k) {
        const double angle = wish.angle * k / count;
        const ObjectIds originals = all_objects(original);
        Scene copy = original;
        if (wish.turns) {
            copy = turned(std::move(copy), originals, pivot, angle);
        } else {
            const Vec3 arm = *middle - pivot;
            const Vec3 to{std::cos(angle) * arm.x - std::sin(angle) * arm.y,
                          std::sin(angle) * arm.x + std::cos(angle) * arm.y, arm.z};
            copy = moved(std::move(copy), originals, to - arm);
        }
        join(all, copy, Vec3{0.0});
    }
    return all;
}

AddedSeveral with_mirror_image(const Scene& scene, std::span<const ObjectId> chosen, MirrorAxis axis, double at) {
    const Scene original = excerpt(scene, chosen);
    AddedSeveral image{scene, {}};
    join(image, mirrored(original, all_objects(original), axis, at), Vec3{0.0});
    return image;
}

}  // namespace hanei
