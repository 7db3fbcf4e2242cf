#include "engine/project/gltf_own_objects.h"

#include "engine/edit/edit.h"
#include "engine/project/gltf_agreement.h"
#include "engine/project/text_file.h"
#include "engine/project/tidy.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

template <class Object>
Object* with_id(std::vector<Object>& list, ObjectId id) {
    const auto found = std::find_if(list.begin(), list.end(), [id](const Object& object) { return object.id == id; });
    return found == list.end() ? nullptr : &*found;
}

TriangleSoup soup_of(const Furniture& furniture) {
    TriangleSoup soup;
    const std::vector<TriangleList> lists = furniture_pieces(furniture);
    for (std::size_t k = 0; k < lists.size(); ++k)
        append(soup, lists[k], placement(furniture), furniture.parts[k].material);
    return soup;
}

TriangleSoup soup_of(const FreeSurface& surface) {
    TriangleList list;
    list.add(surface.region);
    TriangleSoup soup;
    append(soup, list, {}, surface.material);
    return soup;
}

/// Where its node puts a surface that was written where it stands.
Region moved_region(Region region, const GltfObject& object) {
    const auto move = [&](Polygon& loop) {
        for (Vec3& corner : loop) {
            const glm::dvec4 there = object.to_world * glm::dvec4{corner.x, corner.z, -corner.y, 1.0};
            corner = tidy_place({there.x, -there.z, there.y});
        }
    };
    move(region.outline);
    for (Polygon& hole : region.holes) move(hole);
    return region;
}

/// "desk.001" of "desk": how other programs tell objects of one name apart.
bool is_numbered(std::string_view name, std::string_view written) {
    if (!name.starts_with(written) || name.size() < written.size() + 2 || name[written.size()] != '.') return false;
    const std::string_view number = name.substr(written.size() + 1);
    return std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The object in the place that the node shows it in; none when it shows another shape.
std::optional<Furniture> as_shown(const Furniture& written, const GltfObject& object, const TriangleSoup& shown) {
    if (show_the_same(soup_of(written), shown)) return written;
    Furniture moved = written;
    moved.position = tidy_place(object.origin);
    moved.rotation = tidy_angle(object.rotation);
    return show_the_same(soup_of(moved), shown) ? std::optional(std::move(moved)) : std::nullopt;
}

std::optional<FreeSurface> as_shown(const FreeSurface& written, const GltfObject& object, const TriangleSoup& shown) {
    if (show_the_same(soup_of(written), shown)) return written;
    FreeSurface moved = written;
    moved.region = moved_region(std::move(moved.region), object);
    return show_the_same(soup_of(moved), shown) ? std::optional(std::move(moved)) : std::nullopt;
}

/// Surfaces shine as their material in the file does; furniture of such a material is none.
bool shines_as_shown(FreeSurface& surface, LuminousExitance shown) {
    constexpr double rounding = 1e-6;
    const double written = surface.own_exitance.value;
    if (std::abs(shown.value - written) > rounding * written) surface.own_exitance = shown;
    return true;
}
bool shines_as_shown(const Furniture&, LuminousExitance shown) { return shown.value == 0.0; }

std::string lost_with(const Furniture& furniture) {
    if (furniture.model.kind.empty()) return {};
    return fmt::format("; it is no \"{}\" of the furniture library any more", furniture.model.kind);
}
std::string lost_with(const FreeSurface&) { return {}; }

template <class Object>
void take_name(Object& object, const GltfObject& shown) {
    const bool renamed = shown.named && shown.name != object.name && !is_numbered(shown.name, object.name);
    if (renamed) object.name = shown.name;
}

}  // namespace

GltfOwnObjects::GltfOwnObjects(GltfDocument& document, Scene& scene,
                               std::function<const GltfMaterial&(int)> material_of)
    : document_(document), scene_(scene), material_of_(std::move(material_of)) {
    if (scene_.room) written_.emplace_back(scene_.room->id, scene_.room->name);
    for (const Furniture& furniture : scene_.furniture) written_.emplace_back(furniture.id, furniture.name);
    for (const FreeSurface& surface : scene_.surfaces) written_.emplace_back(surface.id, surface.name);
}

TriangleSoup GltfOwnObjects::shown_by(const GltfObject& object) const {
    TriangleSoup soup = object.shown;
    for (Triangle& triangle : soup.triangles)
        triangle.label = static_cast<int>(material_of_(triangle.label).material.id.value);
    return soup;
}

std::vector<const GltfObject*> GltfOwnObjects::rest_of(const std::vector<GltfObject>& objects) {
    std::set<const GltfObject*> settled;
    for (const bool as_written : {true, false})  // copies come after what was copied, wherever the file lists them
        for (const GltfObject& object : objects)
            if (object.own.id && settled.count(&object) == 0 && settles(object, as_written)) settled.insert(&object);
    std::vector<const GltfObject*> rest;
    for (const GltfObject& object : objects)
        if (settled.count(&object) == 0) rest.push_back(&object);
    return rest;
}

bool GltfOwnObjects::settles(const GltfObject& object, bool as_written) {
    if (object.own.kind == "furniture") return settles_one_of(scene_.furniture, object, as_written);
    if (object.own.kind == "surface") return settles_one_of(scene_.surfaces, object, as_written);
    return object.own.kind == "room" && settles_room(object, as_written);
}

template <class Object>
bool GltfOwnObjects::settles_one_of(std::vector<Object>& list, const GltfObject& object, bool as_written) {
    Object* const written = with_id(list, object.own.id);
    if (written == nullptr) return false;
    std::optional<Object> shown = as_shown(*written, object, shown_by(object));
    for (const Triangle& triangle : object.shown.triangles)
        if (shown && !shines_as_shown(*shown, material_of_(triangle.label).own_exitance)) shown.reset();
    if (as_written && (!shown || !(*shown == *written) || is_claimed(written->id))) return false;
    if (is_claimed(written->id)) {
        if (!shown) return false;
        shown->id = scene_.new_id();
        take_name(*shown, object);
        list.push_back(std::move(*shown));
        return true;
    }
    claimed_.insert(written->id);
    if (!shown) change(object, lost_with(*written));
    if (shown) *written = std::move(*shown);
    take_name(*written, object);
    return shown.has_value();
}

bool GltfOwnObjects::settles_room(const GltfObject& object, bool as_written) {
    if (!scene_.room || scene_.room->id != object.own.id || is_claimed(object.own.id)) return false;
    TriangleSoup written;
    for (const auto& [material, list] : room_pieces(scene_)) append(written, list, {}, material);
    const bool same = show_the_same(written, shown_by(object));
    if (as_written && !same) return false;
    claimed_.insert(object.own.id);
    take_name(*scene_.room, object);
    const std::size_t areas = scene_.room->sub_areas.size();
    if (!same)
        change(object, areas == 0 ? std::string()
                                  : fmt::format("; its {} on walls, floor and ceiling {} left out",
                                                areas == 1 ? "sub-area" : fmt::format("{} sub-areas", areas),
                                                areas == 1 ? "is" : "are"));
    return same;
}

void GltfOwnObjects::change(const GltfObject& object, const std::string& loses) {
    changed_.emplace(object.path, object.own.id);
    unread_.insert(object.own.id);
    document_.reading().findings.push_back(about_file(
        Severity::warning, document_.reading().file, object.line, object.path,
        fmt::format("\"{}\": its mesh was changed since it was exported; the mesh is taken{}", object.name, loses)));
}

ObjectId GltfOwnObjects::read_into(const GltfObject& object) {
    const auto found = changed_.find(object.path);
    if (found == changed_.end()) return {};
    const ObjectId id = found->second;
    return unread_.erase(id) > 0 ? id : ObjectId{};
}

Furniture* GltfOwnObjects::furniture_of(const GltfObject& object) {
    return object.own.kind == "furniture" ? with_id(scene_.furniture, read_into(object)) : nullptr;
}

FreeSurface* GltfOwnObjects::surface_of(const GltfObject& object) {
    return object.own.kind == "surface" ? with_id(scene_.surfaces, read_into(object)) : nullptr;
}

Room* GltfOwnObjects::room_of(const GltfObject& object) {
    return object.own.kind == "room" && read_into(object) ? &*scene_.room : nullptr;
}

void GltfOwnObjects::finish() {
    std::vector<std::string> gone;
    for (const auto& [id, name] : written_) {
        if (is_claimed(id) && unread_.count(id) == 0) continue;
        gone.push_back(name);
        if (scene_.room && scene_.room->id == id)
            scene_.room.reset();
        else
            scene_ = removed(std::move(scene_), id);
    }
    tell_gone(document_, gone);
}

}  // namespace hanei
