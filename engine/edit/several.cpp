#include "engine/edit/several.h"

#include "engine/edit/arrangements.h"
#include "engine/edit/excerpt.h"
#include "engine/edit/sub_areas.h"
#include "engine/edit/with_object.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

Vec3 centroid(const Polygon& outline) {
    Vec3 sum{0.0};
    for (const Vec3& corner : outline) sum += corner;
    return outline.empty() ? sum : sum / static_cast<double>(outline.size());
}

Vec3 place(const Furniture& object) { return object.position; }
Vec3 place(const Luminaire& object) { return object.position; }
Vec3 place(const FreeSurface& object) { return centroid(object.region.outline); }
Vec3 place(const CalculationGrid& object) { return object.corner + 0.5 * (object.along + object.across); }
Vec3 place(const CalculationPoint& object) { return object.position; }

/// A turn about a vertical, then a movement.
struct Motion {
    Vec3 pivot{0.0};
    double angle = 0.0;
    Vec3 by{0.0};

    /// Quarter turns leave no dust behind.
    static double exact(double share) { return std::abs(share) < 1e-15 ? 0.0 : share; }

    Vec3 direction(const Vec3& from) const {
        if (angle == 0.0) return from;  // exactly as it was
        const double c = exact(std::cos(angle)), s = exact(std::sin(angle));
        return {c * from.x - s * from.y, s * from.x + c * from.y, from.z};
    }
    Vec3 place(const Vec3& from) const { return angle == 0.0 ? from + by : pivot + direction(from - pivot) + by; }
    double turned(double from) const {
        return angle == 0.0 ? from : std::remainder(from + angle, 2.0 * std::numbers::pi);
    }
};

void move(Furniture& object, const Motion& motion) {
    object.position = motion.place(object.position);
    object.rotation = motion.turned(object.rotation);
}
void move(Luminaire& object, const Motion& motion) {
    object.position = motion.place(object.position);
    object.yaw = motion.turned(object.yaw);
}
void move(CalculationGrid& object, const Motion& motion) {
    object.corner = motion.place(object.corner);
    object.along = motion.direction(object.along);
    object.across = motion.direction(object.across);
}
void move(CalculationPoint& object, const Motion& motion) {
    object.position = motion.place(object.position);
    object.normal = motion.direction(object.normal);
}
void move(FreeSurface& object, const Motion& motion) {
    for (Vec3& corner : object.region.outline) corner = motion.place(corner);
    for (Polygon& hole : object.region.holes) {
        for (Vec3& corner : hole) corner = motion.place(corner);
    }
}

void move(Arrangement& arrangement, const Motion& motion) {
    struct Moved {
        const Motion& motion;
        void operator()(LineLayout& line) const {
            line.from = motion.place(line.from);
            line.to = motion.place(line.to);
        }
        void operator()(FieldLayout& field) const {
            field.corner = motion.place(field.corner);
            field.along = motion.direction(field.along);
            field.across = motion.direction(field.across);
        }
        void operator()(CircleLayout& circle) const {
            circle.middle = motion.place(circle.middle);
            circle.first_angle = motion.turned(circle.first_angle);
        }
    };
    std::visit(Moved{motion}, arrangement.layout);
    arrangement.yaw = motion.turned(arrangement.yaw);
}

bool holds(std::span<const ObjectId> ids, ObjectId id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); }

Scene with_motion(Scene scene, std::span<const ObjectId> chosen, const Motion& motion) {
    const ObjectIds objects = objects_of(scene, chosen);
    for (const ObjectId id : objects) {
        with_object(scene, id, [&](auto& object, ObjectKind) {
            if constexpr (requires { place(object); }) move(object, motion);
        });
    }
    for (const ObjectId id : objects)
        if (find_sub_area(scene, id) != nullptr) scene = with_sub_area_moved(std::move(scene), id, motion.by);
    for (Arrangement& arrangement : scene.arrangements) {
        const auto goes = [&](ObjectId id) { return !id || holds(objects, id); };  // empty places go along
        if (std::all_of(arrangement.luminaires.begin(), arrangement.luminaires.end(), goes)) move(arrangement, motion);
    }
    return with_arrangements_kept(std::move(scene));
}

}  // namespace

ObjectIds objects_of(const Scene& scene, std::span<const ObjectId> chosen) {
    ObjectIds objects;
    const auto take = [&](ObjectId id) {
        if (!holds(objects, id) && kind_of(scene, id) != ObjectKind::none) objects.push_back(id);
    };
    for (const ObjectId id : chosen) {
        with_object(scene, id, [&](const auto& object, ObjectKind) {
            if constexpr (requires { object.members; })
                std::for_each(object.members.begin(), object.members.end(), take);
            else if constexpr (requires { object.luminaires; })
                std::for_each(object.luminaires.begin(), object.luminaires.end(), take);
            else
                take(object.id);
        });
    }
    return objects;
}

ObjectId group_of(const Scene& scene, ObjectId id) {
    for (const ObjectGroup& group : scene.object_groups)
        if (holds(group.members, id)) return group.id;
    return {};
}

ObjectIds same_kind(const Scene& scene, std::span<const ObjectId> chosen) {
    std::vector<ObjectKind> kinds;
    for (const ObjectId id : chosen) kinds.push_back(kind_of(scene, id));
    ObjectIds found;
    const auto search = [&](const auto& list) {
        for (const auto& object : list)
            if (std::find(kinds.begin(), kinds.end(), kind_of(scene, object.id)) != kinds.end())
                found.push_back(object.id);
    };
    search(scene.furniture);
    search(scene.surfaces);
    search(scene.luminaires);
    search(scene.grids);
    search(scene.points);
    search(scene.object_groups);
    search(scene.materials);
    search(scene.views);
    return found;
}

ObjectIds all_objects(const Scene& scene) {
    ObjectIds found;
    for (const ObjectGroup& group : scene.object_groups) found.push_back(group.id);
    const auto take = [&](const auto& list) {
        for (const auto& object : list)
            if (!group_of(scene, object.id)) found.push_back(object.id);
    };
    take(scene.furniture);
    take(scene.surfaces);
    take(scene.grids);
    take(scene.points);
    take(scene.luminaires);
    return found;
}

std::optional<Bounds> bounds_of_objects(const Scene& scene, std::span<const ObjectId> chosen) {
    Scene alone = excerpt(scene, chosen);
    alone.room.reset();
    std::optional<Bounds> bounds;
    if (!alone.furniture.empty() || !alone.surfaces.empty() || !alone.luminaires.empty()) bounds = bounds_of(alone);
    const auto add = [&](const Vec3& at) {
        bounds = bounds ? Bounds{glm::min(bounds->low, at), glm::max(bounds->high, at)} : Bounds{at, at};
    };
    for (const CalculationPoint& point : alone.points) add(point.position);
    for (const CalculationGrid& grid : alone.grids) {
        for (const double along : {0.0, 1.0})
            for (const double across : {0.0, 1.0}) add(grid.corner + along * grid.along + across * grid.across);
    }
    return bounds;
}

std::optional<Vec3> middle_of(const Scene& scene, std::span<const ObjectId> chosen) {
    const ObjectIds objects = objects_of(scene, chosen);
    if (objects.size() == 1) return place_of(scene, objects.front());
    const std::optional<Bounds> bounds = bounds_of_objects(scene, objects);
    if (!bounds) return std::nullopt;
    return 0.5 * (bounds->low + bounds->high);
}

std::optional<Vec3> place_of(const Scene& scene, ObjectId id) {
    std::optional<Vec3> found = place_of_sub_area(scene, id);
    with_object(scene, id, [&](const auto& object, ObjectKind) {
        if constexpr (requires { place(object); })
            found = place(object);
        else if constexpr (
            requires { object.members; } || requires { object.luminaires; })
            found = middle_of(scene, std::array{id});
    });
    return found;
}

Scene moved(Scene scene, std::span<const ObjectId> chosen, const Vec3& by) {
    return with_motion(std::move(scene), chosen, {Vec3{0.0}, 0.0, by});
}

Scene moved(Scene scene, ObjectId id, const Vec3& by) { return moved(std::move(scene), std::array{id}, by); }

Scene turned(Scene scene, std::span<const ObjectId> chosen, const Vec3& pivot, double angle) {
    return with_motion(std::move(scene), chosen, {pivot, angle, Vec3{0.0}});
}

bool can_remove(const Scene& scene, std::span<const ObjectId> chosen) {
    return std::any_of(chosen.begin(), chosen.end(), [&](ObjectId id) { return can_remove(kind_of(scene, id)); });
}

Scene removed(Scene scene, std::span<const ObjectId> chosen) {
    const ObjectIds objects = objects_of(scene, chosen);
    for (const ObjectId id : objects) scene = removed(std::move(scene), id);
    for (const ObjectId id : chosen) scene = removed(std::move(scene), id);
    return scene;
}

std::string words_for(const Scene& scene, std::span<const ObjectId> chosen) {
    if (chosen.empty()) return "nothing";
    const ObjectKind kind = kind_of(scene, chosen.front());
    if (chosen.size() == 1) return std::string(name_of(kind));
    const bool alike =
        std::all_of(chosen.begin(), chosen.end(), [&](ObjectId id) { return kind_of(scene, id) == kind; });
    std::string word = alike ? std::string(name_of(kind)) : std::string("object");
    if (word == "furniture")
        word = "pieces of furniture";
    else
        word += 's';
    return std::to_string(chosen.size()) + " " + word;
}

}  // namespace hanei
