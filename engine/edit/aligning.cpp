#include "engine/edit/aligning.h"

#include "engine/edit/excerpt.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hanei {
namespace {

/// What moves as one, with its bounds.
struct Unit {
    ObjectId id;
    Bounds bounds;
};

std::vector<Unit> units_of(const Scene& scene, std::span<const ObjectId> chosen) {
    std::vector<Unit> units;
    for (const ObjectId id : chosen)
        if (const auto bounds = bounds_of_objects(scene, std::array{id})) units.push_back({id, *bounds});
    return units;
}

double middle(const Bounds& bounds, int axis) { return 0.5 * (bounds.low[axis] + bounds.high[axis]); }

/// Where the side of a bounds that is aligned lies.
double side(const Bounds& bounds, Alignment alignment) {
    switch (alignment) {
        case Alignment::left:
            return bounds.low.x;
        case Alignment::right:
            return bounds.high.x;
        case Alignment::bottom:
            return bounds.low.y;
        case Alignment::top:
            return bounds.high.y;
        case Alignment::middle_x:
            return middle(bounds, 0);
        case Alignment::middle_y:
            return middle(bounds, 1);
    }
    return 0.0;
}

bool is_along_x(Alignment alignment) {
    return alignment == Alignment::left || alignment == Alignment::right || alignment == Alignment::middle_x;
}

bool can_be_member(ObjectKind kind) {
    return kind == ObjectKind::furniture || kind == ObjectKind::surface || kind == ObjectKind::luminaire ||
           kind == ObjectKind::grid || kind == ObjectKind::point;
}

ObjectIds members_of(const Scene& scene, std::span<const ObjectId> chosen) {
    ObjectIds members = objects_of(scene, chosen);
    std::erase_if(members, [&](ObjectId id) { return !can_be_member(kind_of(scene, id)); });
    return members;
}

/// The groups that these are, or are members of.
ObjectIds groups_of(const Scene& scene, std::span<const ObjectId> chosen) {
    ObjectIds groups;
    for (const ObjectId id : chosen) {
        const ObjectId group = kind_of(scene, id) == ObjectKind::object_group ? id : group_of(scene, id);
        if (group && std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
    }
    return groups;
}

}  // namespace

Scene aligned(Scene scene, std::span<const ObjectId> chosen, Alignment alignment) {
    const std::vector<Unit> units = units_of(scene, chosen);
    if (units.size() < 2) return scene;
    const double line = side(units.back().bounds, alignment);
    for (const Unit& unit : units) {
        const double by = line - side(unit.bounds, alignment);
        if (by == 0.0) continue;
        scene = moved(std::move(scene), unit.id, is_along_x(alignment) ? Vec3{by, 0.0, 0.0} : Vec3{0.0, by, 0.0});
    }
    return scene;
}

Scene distributed(Scene scene, std::span<const ObjectId> chosen, Spread spread) {
    std::vector<Unit> units = units_of(scene, chosen);
    if (units.size() < 3) return scene;
    const int axis = spread == Spread::x ? 0 : 1;
    std::stable_sort(units.begin(), units.end(),
                     [&](const Unit& a, const Unit& b) { return middle(a.bounds, axis) < middle(b.bounds, axis); });
    double filled = 0.0;
    for (const Unit& unit : units) filled += unit.bounds.high[axis] - unit.bounds.low[axis];
    const double all = units.back().bounds.high[axis] - units.front().bounds.low[axis];
    const double gap = (all - filled) / static_cast<double>(units.size() - 1);
    double next = units.front().bounds.high[axis] + gap;
    for (std::size_t k = 1; k + 1 < units.size(); ++k) {
        Vec3 by{0.0};
        by[axis] = next - units[k].bounds.low[axis];
        scene = moved(std::move(scene), units[k].id, by);
        next += units[k].bounds.high[axis] - units[k].bounds.low[axis] + gap;
    }
    return scene;
}

bool can_group(const Scene& scene, std::span<const ObjectId> chosen) {
    const ObjectIds members = members_of(scene, chosen);
    if (members.size() < 2) return false;
    const ObjectId first = group_of(scene, members.front());
    const auto in_first = [&](ObjectId id) { return group_of(scene, id) == first; };
    if (!first || !std::all_of(members.begin(), members.end(), in_first)) return true;
    const auto group = std::find_if(scene.object_groups.begin(), scene.object_groups.end(),
                                    [&](const ObjectGroup& each) { return each.id == first; });
    return group->members.size() != members.size();  // a whole group by itself is grouped already
}

Added grouped(Scene scene, std::span<const ObjectId> chosen) {
    if (!can_group(scene, chosen)) return {std::move(scene), {}};
    ObjectGroup group;
    group.members = members_of(scene, chosen);
    for (ObjectGroup& other : scene.object_groups)
        std::erase_if(other.members, [&](ObjectId id) {
            return std::find(group.members.begin(), group.members.end(), id) != group.members.end();
        });
    std::erase_if(scene.object_groups, [](const ObjectGroup& other) { return other.members.empty(); });
    group.name = free_name(scene, "Group 1");
    group.id = scene.new_id();
    const ObjectId id = group.id;
    scene.object_groups.push_back(std::move(group));
    return {std::move(scene), id};
}

bool can_ungroup(const Scene& scene, std::span<const ObjectId> chosen) { return !groups_of(scene, chosen).empty(); }

Ungrouped ungrouped(Scene scene, std::span<const ObjectId> chosen) {
    const ObjectIds groups = groups_of(scene, chosen);
    const ObjectIds members = objects_of(scene, groups);
    std::erase_if(scene.object_groups, [&](const ObjectGroup& group) {
        return std::find(groups.begin(), groups.end(), group.id) != groups.end();
    });
    return {std::move(scene), members};
}

}  // namespace hanei
