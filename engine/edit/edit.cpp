#include "engine/edit/edit.h"

#include "engine/edit/with_object.h"

#include <algorithm>

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

void move(Furniture& object, const Vec3& by) { object.position += by; }
void move(Luminaire& object, const Vec3& by) { object.position += by; }
void move(CalculationGrid& object, const Vec3& by) { object.corner += by; }
void move(CalculationPoint& object, const Vec3& by) { object.position += by; }
void move(FreeSurface& object, const Vec3& by) {
    for (Vec3& corner : object.region.outline) corner += by;
    for (Polygon& hole : object.region.holes) {
        for (Vec3& corner : hole) corner += by;
    }
}

template <class Object>
concept Movable = requires(Object& object) {
    move(object, Vec3{});
};

template <class Object>
bool erase(std::vector<Object>& list, ObjectId id) {
    return std::erase_if(list, [&](const Object& object) { return object.id == id; }) > 0;
}

template <class Object>
ObjectId copy_in(Scene& scene, std::vector<Object>& list, ObjectId id, const Vec3& by) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const Object& object) { return object.id == id; });
    if (found == list.end()) return {};
    Object copy = *found;
    copy.id = scene.new_id();
    if (!copy.name.empty()) copy.name += " copy";
    if constexpr (Movable<Object>) move(copy, by);
    list.insert(found + 1, copy);
    return copy.id;
}

}  // namespace

ObjectKind kind_of(const Scene& scene, ObjectId id) {
    ObjectKind found = ObjectKind::none;
    with_object(scene, id, [&](const auto&, ObjectKind kind) { found = kind; });
    return found;
}

std::string_view name_of(ObjectKind kind) {
    switch (kind) {
        case ObjectKind::none:
            return "nothing";
        case ObjectKind::room:
            return "room";
        case ObjectKind::furniture:
            return "furniture";
        case ObjectKind::surface:
            return "surface";
        case ObjectKind::luminaire:
            return "luminaire";
        case ObjectKind::grid:
            return "calculation grid";
        case ObjectKind::point:
            return "calculation point";
        case ObjectKind::view:
            return "view";
        case ObjectKind::material:
            return "material";
        case ObjectKind::control_group:
            return "control group";
        case ObjectKind::light_scene:
            return "light scene";
        case ObjectKind::arrangement:
            return "arrangement";
        case ObjectKind::object_group:
            return "group";
    }
    return {};
}

std::string display_name(const Scene& scene, ObjectId id) {
    std::string name;
    with_object(scene, id, [&](const auto& object, ObjectKind kind) {
        name = object.name;
        if (!name.empty()) return;
        name = std::string(name_of(kind)) + " " + std::to_string(id.value);
        name[0] = static_cast<char>(name[0] - 'a' + 'A');
    });
    return name;
}

ObjectId object_named(const Scene& scene, const std::string& name) {
    const auto search = [&](const auto& list) {
        for (const auto& object : list) {
            if (display_name(scene, object.id) == name) return object.id;
        }
        return ObjectId{};
    };
    ObjectId found = search(scene.luminaires);
    if (!found) found = search(scene.furniture);
    if (!found) found = search(scene.grids);
    if (!found) found = search(scene.points);
    if (!found) found = search(scene.surfaces);
    if (!found) found = search(scene.views);
    if (!found) found = search(scene.materials);
    if (!found && scene.room && display_name(scene, scene.room->id) == name) found = scene.room->id;
    return found;
}

std::optional<Vec3> place_of(const Scene& scene, ObjectId id) {
    std::optional<Vec3> found;
    with_object(scene, id, [&](const auto& object, ObjectKind) {
        if constexpr (requires { place(object); }) found = place(object);
    });
    return found;
}

Scene moved(Scene scene, ObjectId id, const Vec3& by) {
    with_object(scene, id, [&](auto& object, ObjectKind) {
        if constexpr (Movable<decltype(object)>) move(object, by);
    });
    return scene;
}

bool can_remove(ObjectKind kind) {
    return kind != ObjectKind::none && kind != ObjectKind::room && kind != ObjectKind::material;
}

namespace {

/// Nothing names the object any longer; arrangements and groups that are left empty go with it.
void forget(Scene& scene, ObjectId id) {
    for (Luminaire& luminaire : scene.luminaires)
        if (luminaire.group == id) luminaire.group = {};
    for (LightScene& light_scene : scene.light_scenes)
        std::erase_if(light_scene.levels, [&](const LightScene::Level& level) { return level.group == id; });
    for (Arrangement& arrangement : scene.arrangements)
        std::replace(arrangement.luminaires.begin(), arrangement.luminaires.end(), id, ObjectId{});
    for (ObjectGroup& group : scene.object_groups) std::erase(group.members, id);
    std::erase_if(scene.arrangements, [](const Arrangement& arrangement) {
        return std::none_of(arrangement.luminaires.begin(), arrangement.luminaires.end(),
                            [](ObjectId kept) { return bool(kept); });
    });
    std::erase_if(scene.object_groups, [](const ObjectGroup& group) { return group.members.empty(); });
}

}  // namespace

Scene removed(Scene scene, ObjectId id) {
    erase(scene.furniture, id);
    erase(scene.surfaces, id);
    erase(scene.luminaires, id);
    erase(scene.grids, id);
    erase(scene.points, id);
    erase(scene.views, id);
    erase(scene.control_groups, id);
    erase(scene.light_scenes, id);
    erase(scene.arrangements, id);
    erase(scene.object_groups, id);
    forget(scene, id);
    return scene;
}

Added duplicated(Scene scene, ObjectId id) {
    double width = 1.0;
    for (const Furniture& furniture : scene.furniture) {
        if (furniture.id != id) continue;
        for (const Part& part : furniture.parts) {
            if (const auto* box = std::get_if<BoxShape>(&part.shape)) {
                width = std::max(width, 2.0 * std::abs(part.position.x) + box->size.x);
            }
        }
    }
    const Vec3 beside{width, 0.0, 0.0};
    ObjectId copy = copy_in(scene, scene.luminaires, id, beside);
    if (!copy) copy = copy_in(scene, scene.furniture, id, beside);
    if (!copy) copy = copy_in(scene, scene.surfaces, id, beside);
    if (!copy) copy = copy_in(scene, scene.grids, id, beside);
    if (!copy) copy = copy_in(scene, scene.points, id, beside);
    if (!copy) copy = copy_in(scene, scene.views, id, beside);
    if (!copy) copy = copy_in(scene, scene.materials, id, beside);
    return {std::move(scene), copy};
}

}  // namespace hanei
