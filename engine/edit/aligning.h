/// Objects brought in line with each other, and groups.
#pragma once

#include "engine/edit/several.h"

namespace hanei {

/// Which sides come in line, seen in the plan.
enum class Alignment { left, right, bottom, top, middle_x, middle_y };

/// All others move to the one chosen last, which stays; groups move as one.
Scene aligned(Scene scene, std::span<const ObjectId> chosen, Alignment alignment);

enum class Spread { x, y };
/// Gaps between neighbours become equal; the outermost stay. Fewer than three stay as they are.
Scene distributed(Scene scene, std::span<const ObjectId> chosen, Spread spread);

/// One group of these objects, which leave the groups they were in. Fewer than two are no group.
Added grouped(Scene scene, std::span<const ObjectId> chosen);
bool can_group(const Scene& scene, std::span<const ObjectId> chosen);

struct Ungrouped {
    Scene scene;
    ObjectIds members;
};
/// Without the groups among these and those that they are members of.
Ungrouped ungrouped(Scene scene, std::span<const ObjectId> chosen);
bool can_ungroup(const Scene& scene, std::span<const ObjectId> chosen);

}  // namespace hanei
