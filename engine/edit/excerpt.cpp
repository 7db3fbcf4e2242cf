#include "engine/edit/excerpt.h"

#include "engine/edit/control_groups.h"
#include "engine/edit/luminaire_edits.h"
#include "engine/edit/sub_areas.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

namespace hanei {
namespace {

bool holds(std::span<const ObjectId> ids, ObjectId id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); }

template <class Object>
void copy_chosen(const std::vector<Object>& from, std::vector<Object>& to, std::span<const ObjectId> ids) {
    std::copy_if(from.begin(), from.end(), std::back_inserter(to),
                 [&](const Object& object) { return holds(ids, object.id); });
}

ObjectIds materials_of(const Scene& scene) {
    ObjectIds used;
    for (const Furniture& furniture : scene.furniture)
        for (const Part& part : furniture.parts) used.push_back(part.material);
    for (const FreeSurface& surface : scene.surfaces) used.push_back(surface.material);
    if (scene.room)
        for (const SubArea& area : scene.room->sub_areas) used.push_back(area.material);
    return used;
}

template <class Object, class IdsOf>
void copy_whole(const std::vector<Object>& from, std::vector<Object>& to, std::span<const ObjectId> objects,
                const IdsOf& ids_of) {
    std::copy_if(from.begin(), from.end(), std::back_inserter(to), [&](const Object& each) {
        const ObjectIds& ids = ids_of(each);
        return !ids.empty() && std::all_of(ids.begin(), ids.end(), [&](ObjectId id) { return holds(objects, id); });
    });
}

bool is_taken(const Scene& scene, const std::string& name) {
    const auto named = [&](const auto& list) {
        return std::any_of(list.begin(), list.end(), [&](const auto& object) { return object.name == name; });
    };
    return named(scene.furniture) || named(scene.surfaces) || named(scene.luminaires) || named(scene.grids) ||
           named(scene.points) || named(scene.views) || named(scene.materials) || named(scene.arrangements) ||
           named(scene.object_groups);
}

ObjectId material_in(Scene& scene, Material material) {
    for (const Material& present : scene.materials) {
        material.id = present.id;
        if (present == material) return present.id;
    }
    material.id = scene.new_id();
    material.name = free_name(scene, material.name);
    scene.materials.push_back(std::move(material));
    return scene.materials.back().id;
}

/// Joins objects to a scene under new ids.
class Joining {
public:
    explicit Joining(Scene scene) : scene_(std::move(scene)) {}

    void needs(const Scene& from) {
        const ObjectIds used = materials_of(from);
        for (const Material& material : from.materials)
            if (holds(used, material.id)) ids_[material.id] = material_in(scene_, material);
        for (const Photometry& photometry : from.photometries)
            if (users_of(from, photometry.id) > 0) ids_[photometry.id] = photometry_in(scene_, photometry);
        for (const ControlGroup& group : from.control_groups) {
            const bool is_used = std::any_of(from.luminaires.begin(), from.luminaires.end(),
                                             [&](const Luminaire& luminaire) { return luminaire.group == group.id; });
            if (is_used) ids_[group.id] = control_group_in(group);
        }
    }

    void objects(const Scene& from) {
        join(from.furniture, scene_.furniture, [this](Furniture& piece) {
            for (Part& part : piece.parts) part.material = ids_[part.material];
        });
        join(from.surfaces, scene_.surfaces,
             [this](FreeSurface& surface) { surface.material = ids_[surface.material]; });
        join(from.luminaires, scene_.luminaires, [this](Luminaire& luminaire) {
            luminaire.group = ids_[luminaire.group];
            if (auto* measured = std::get_if<Measured>(&luminaire.distribution))
                measured->photometry = ids_[measured->photometry];
        });
        join(from.grids, scene_.grids, [](CalculationGrid&) {});
        join(from.points, scene_.points, [](CalculationPoint&) {});
        join(from.views, scene_.views, [](View&) {});
        join(from.arrangements, scene_.arrangements, [this](Arrangement& each) { rename(each.luminaires); });
        join(from.object_groups, scene_.object_groups, [this](ObjectGroup& each) {
            rename(each.members);
            grouped_.insert(grouped_.end(), each.members.begin(), each.members.end());
        });
    }

    void sub_areas(const Scene& from, const Vec3& by, const std::optional<FacePlace>& at) {
        if (!from.room) return;
        for (SubArea area : from.room->sub_areas) {
            area.material = ids_[area.material];
            Added added = with_sub_area_pasted(std::move(scene_), std::move(area), by, at);
            scene_ = std::move(added.scene);
            if (added.object) sub_areas_.push_back(added.object);
        }
    }

    AddedSeveral done(const Vec3& by) {
        std::erase_if(added_, [&](ObjectId id) { return holds(grouped_, id) || arrangement_is(id); });
        AddedSeveral all{std::move(scene_), std::move(added_)};
        all.scene = moved(std::move(all.scene), all.objects, by);
        all.objects.insert(all.objects.end(), sub_areas_.begin(), sub_areas_.end());
        return all;
    }

private:
    template <class Object, class Mend>
    void join(const std::vector<Object>& from, std::vector<Object>& to, const Mend& mend) {
        for (Object object : from) {
            const ObjectId before = object.id;
            object.id = ids_[before] = scene_.new_id();
            if (!object.name.empty()) object.name = free_name(scene_, object.name);
            mend(object);
            added_.push_back(object.id);
            to.push_back(std::move(object));
        }
    }

    void rename(ObjectIds& ids) {
        for (ObjectId& id : ids) id = ids_[id];
    }

    bool arrangement_is(ObjectId id) const { return kind_of(scene_, id) == ObjectKind::arrangement; }

    ObjectId control_group_in(ControlGroup group) {
        for (const ControlGroup& present : scene_.control_groups)
            if (present.name == group.name) return present.id;
        group.id = scene_.new_id();
        scene_.control_groups.push_back(std::move(group));
        return scene_.control_groups.back().id;
    }

    Scene scene_;
    std::map<ObjectId, ObjectId> ids_{{ObjectId{}, ObjectId{}}};
    ObjectIds added_, grouped_, sub_areas_;
};

}  // namespace

std::string free_name(const Scene& scene, const std::string& name) {
    if (name.empty() || !is_taken(scene, name)) return name;
    std::size_t stem = name.size();
    while (stem > 0 && std::isdigit(static_cast<unsigned char>(name[stem - 1])) != 0) --stem;
    constexpr std::size_t longest_number = 6;  // digits; longer ones are order codes
    const bool numbered =
        stem > 0 && stem < name.size() && name[stem - 1] == ' ' && name.size() - stem < longest_number;
    const std::string before = numbered ? name.substr(0, stem) : name + ' ';
    for (int number = numbered ? std::stoi(name.substr(stem)) + 1 : 2;; ++number) {
        std::string wished = before + std::to_string(number);
        if (!is_taken(scene, wished)) return wished;
    }
}

Scene excerpt(const Scene& scene, std::span<const ObjectId> chosen) {
    const ObjectIds objects = objects_of(scene, chosen);
    Scene alone;
    alone.title = scene.title;
    alone.last_id = scene.last_id;
    copy_chosen(scene.furniture, alone.furniture, objects);
    copy_chosen(scene.surfaces, alone.surfaces, objects);
    copy_chosen(scene.luminaires, alone.luminaires, objects);
    copy_chosen(scene.grids, alone.grids, objects);
    copy_chosen(scene.points, alone.points, objects);
    copy_chosen(scene.views, alone.views, objects);
    ObjectIds materials = materials_of(alone);
    if (scene.room) {
        Room room = *scene.room;
        room.sub_areas.clear();
        copy_chosen(scene.room->sub_areas, room.sub_areas, objects);
        if (!room.sub_areas.empty()) {
            for (int face = 0; face < face_count(room); ++face) materials.push_back(material_of_face(room, face));
            for (const SubArea& area : room.sub_areas) materials.push_back(area.material);
            alone.room = std::move(room);
        }
    }
    copy_chosen(scene.materials, alone.materials, materials);
    for (const Photometry& photometry : scene.photometries)
        if (users_of(alone, photometry.id) > 0) alone.photometries.push_back(photometry);
    ObjectIds control_groups;
    for (const Luminaire& luminaire : alone.luminaires) control_groups.push_back(luminaire.group);
    copy_chosen(scene.control_groups, alone.control_groups, control_groups);
    copy_whole(scene.arrangements, alone.arrangements, objects,
               [](const Arrangement& each) -> const ObjectIds& { return each.luminaires; });
    copy_whole(scene.object_groups, alone.object_groups, objects,
               [](const ObjectGroup& each) -> const ObjectIds& { return each.members; });
    return alone;
}

AddedSeveral with_excerpt(Scene scene, const Scene& excerpt, const Vec3& by, const std::optional<FacePlace>& at) {
    Joining joining(std::move(scene));
    joining.needs(excerpt);
    joining.objects(excerpt);
    joining.sub_areas(excerpt, by, at);
    return joining.done(by);
}

AddedSeveral duplicated(Scene scene, std::span<const ObjectId> chosen) {
    const std::optional<Bounds> bounds = bounds_of_objects(scene, chosen);
    constexpr double narrowest = 0.1;  // m: a copy that lies on its original is taken for none
    const double width = bounds ? bounds->high.x - bounds->low.x : 0.0;
    Scene alone = excerpt(scene, chosen);
    alone.room.reset();  // parts of faces are copied beside themselves
    AddedSeveral copies = with_excerpt(std::move(scene), alone, {width > narrowest ? width : 1.0, 0.0, 0.0});
    for (const ObjectId id : chosen) {
        if (find_sub_area(copies.scene, id) == nullptr) continue;
        Added copy = with_sub_area_copied(std::move(copies.scene), id);
        copies.scene = std::move(copy.scene);
        copies.objects.push_back(copy.object);
    }
    return copies;
}

}  // namespace hanei
