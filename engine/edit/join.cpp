#include "engine/edit/join.h"

#include "engine/edit/edit.h"
#include "engine/scene/faces.h"

#include <algorithm>
#include <map>
#include <utility>

namespace hanei {
namespace {

/// New ids for old ones; an id that names nothing names nothing afterwards.
class Renumbering {
public:
    explicit Renumbering(Scene& into) : into_(into) {}

    template <class Object>
    void add(std::vector<Object>& to, std::vector<Object> objects) {
        for (Object& object : objects) {
            object.id = fresh(object.id);
            to.push_back(std::move(object));
        }
    }

    /// Equal ones are used again.
    template <class Object>
    void share(std::vector<Object>& to, std::vector<Object> objects) {
        for (Object& object : objects) {
            const ObjectId old = object.id;
            const auto same = std::find_if(to.begin(), to.end(), [&](const Object& known) {
                object.id = known.id;
                return known == object;
            });
            if (same != to.end()) {
                known_[old] = same->id;
                continue;
            }
            object.id = fresh(old);
            to.push_back(std::move(object));
        }
    }

    ObjectId fresh(ObjectId old) { return known_[old] = into_.new_id(); }
    void renew(ObjectId& id) const {
        const auto found = known_.find(id);
        id = found == known_.end() ? ObjectId{} : found->second;
    }

private:
    Scene& into_;
    std::map<ObjectId, ObjectId> known_;
};

void add_room(Scene& into, Renumbering& ids, Room room) {
    room.id = ids.fresh(room.id);
    ids.renew(room.floor_material);
    ids.renew(room.ceiling_material);
    for (ObjectId& material : room.wall_materials) ids.renew(material);
    for (SubArea& area : room.sub_areas) {
        area.id = ids.fresh(area.id);
        ids.renew(area.material);
    }
    into.room = std::move(room);
}

}  // namespace

Scene joined(Scene into, const Scene& from) {
    Renumbering ids(into);
    ids.share(into.materials, from.materials);
    ids.share(into.photometries, from.photometries);
    ids.share(into.control_groups, from.control_groups);
    if (from.room) add_room(into, ids, *from.room);
    std::vector<Furniture> furniture = from.furniture;
    for (Furniture& each : furniture)
        for (Part& part : each.parts) ids.renew(part.material);
    ids.add(into.furniture, std::move(furniture));
    std::vector<FreeSurface> surfaces = from.surfaces;
    for (FreeSurface& surface : surfaces) ids.renew(surface.material);
    ids.add(into.surfaces, std::move(surfaces));
    std::vector<Luminaire> luminaires = from.luminaires;
    for (Luminaire& luminaire : luminaires) {
        ids.renew(luminaire.group);
        if (auto* const measured = std::get_if<Measured>(&luminaire.distribution)) ids.renew(measured->photometry);
    }
    ids.add(into.luminaires, std::move(luminaires));
    ids.add(into.grids, from.grids);
    ids.add(into.points, from.points);
    ids.add(into.views, from.views);
    std::vector<LightScene> light_scenes = from.light_scenes;
    for (LightScene& each : light_scenes)
        for (LightScene::Level& level : each.levels) ids.renew(level.group);
    ids.add(into.light_scenes, std::move(light_scenes));
    std::vector<Arrangement> arrangements = from.arrangements;
    for (Arrangement& each : arrangements)
        for (ObjectId& luminaire : each.luminaires) ids.renew(luminaire);
    ids.add(into.arrangements, std::move(arrangements));
    std::vector<ObjectGroup> groups = from.object_groups;
    for (ObjectGroup& each : groups)
        for (ObjectId& member : each.members) ids.renew(member);
    ids.add(into.object_groups, std::move(groups));
    return into;
}

Scene emptied(Scene scene) {
    Scene empty;
    empty.title = std::move(scene.title);
    empty.maintenance_factor = scene.maintenance_factor;
    empty.last_id = scene.last_id;
    empty.unknown = std::move(scene.unknown);
    empty.colour_scale = scene.colour_scale;
    return empty;
}

Scene stood_at(Scene scene, Vec2 place, double floor) {
    const bool empty = scene.furniture.empty() && scene.surfaces.empty() && scene.luminaires.empty();
    if (scene.room || empty) return scene;
    const Bounds bounds = bounds_of(scene);
    const Vec2 middle = 0.5 * (Vec2{bounds.low} + Vec2{bounds.high});
    const Vec3 by{place - middle, floor - bounds.low.z};
    std::vector<ObjectId> all;
    for (const Furniture& object : scene.furniture) all.push_back(object.id);
    for (const FreeSurface& object : scene.surfaces) all.push_back(object.id);
    for (const Luminaire& object : scene.luminaires) all.push_back(object.id);
    for (const CalculationGrid& object : scene.grids) all.push_back(object.id);
    for (const CalculationPoint& object : scene.points) all.push_back(object.id);
    for (const ObjectId id : all) scene = moved(std::move(scene), id, by);
    return scene;
}

}  // namespace hanei
