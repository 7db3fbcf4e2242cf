#include "engine/geometry/polygon.h"
#include "engine/project/json_text.h"
#include "engine/project/reference_reader.h"

#include <algorithm>

namespace hanei {

ObjectId ReferenceScene::material(double reflectance) {
    const auto [place, is_new] = materials.emplace(reflectance, ObjectId{});
    if (is_new) {
        place->second = scene.new_id();
        scene.materials.push_back(
            {place->second, "reflectance " + one_line(json_number(reflectance)), reflectance, {}});
    }
    return place->second;
}

Region take_reference_region(Fields& fields) {
    Region region;
    fields.require("vertices", region.outline, "points [x, y, z]");
    fields.optional("holes", region.holes);
    const Vec3 front = vector_area(region.outline);
    for (Polygon& hole : region.holes)
        if (glm::dot(vector_area(hole), front) > 0.0) std::reverse(hole.begin(), hole.end());
    return region;
}

FreeSurface* find_surface(Scene& scene, const std::string& name) {
    const auto found = std::find_if(scene.surfaces.begin(), scene.surfaces.end(),
                                    [&](const FreeSurface& surface) { return surface.name == name; });
    return found == scene.surfaces.end() ? nullptr : &*found;
}

namespace {

bool same_edge(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return (a == c && b == d) || (a == d && b == c);
}

bool share_an_edge(const Polygon& one, const Polygon& other) {
    for (std::size_t i = 0; i < one.size(); ++i)
        for (std::size_t k = 0; k < other.size(); ++k)
            if (same_edge(one[i], one[(i + 1) % one.size()], other[k], other[(k + 1) % other.size()])) return true;
    return false;
}

/// A sheet standing in the room by itself: joined to no other surface, with some of them behind it.
bool stands_alone(const FreeSurface& sheet, const std::vector<FreeSurface>& surfaces) {
    if (sheet.region.outline.empty()) return false;
    const Vec3 front = vector_area(sheet.region.outline);
    bool has_something_behind = false;
    for (const FreeSurface& other : surfaces) {
        if (other.id == sheet.id) continue;
        if (share_an_edge(sheet.region.outline, other.region.outline)) return false;
        for (const Vec3& corner : other.region.outline)
            has_something_behind = has_something_behind || glm::dot(corner - sheet.region.outline.front(), front) < 0.0;
    }
    return has_something_behind;
}

/// The expected values take a sheet that stands alone to reflect from both sides, though the file
/// names its front only.
void add_backs(ReferenceScene& target) {
    const std::vector<FreeSurface> surfaces = target.scene.surfaces;
    const ObjectId black = target.material(0.0);
    for (const FreeSurface& sheet : surfaces) {
        if (sheet.material == black || !stands_alone(sheet, surfaces)) continue;
        FreeSurface back = sheet;
        back.id = target.scene.new_id();
        back.name += ", back";
        back.own_exitance = {};
        std::reverse(back.region.outline.begin(), back.region.outline.end());
        for (Polygon& hole : back.region.holes) std::reverse(hole.begin(), hole.end());
        target.scene.surfaces.push_back(std::move(back));
    }
}

}  // namespace

void read_reference_surfaces(ReferenceScene& target, Fields& scene) {
    for_each_object(scene, "surfaces", [&](Fields& fields, std::size_t) {
        FreeSurface surface;
        double reflectance = 0.0;
        surface.id = target.scene.new_id();
        fields.require("id", surface.name, "a text");
        surface.region = take_reference_region(fields);
        fields.optional("reflectance", reflectance);
        fields.optional("exitance_lm_m2", surface.own_exitance.value);
        surface.material = target.material(fields.has("role") ? 0.0 : reflectance);  // occluders are black
        target.scene.surfaces.push_back(std::move(surface));
    });
    add_backs(target);
}

}  // namespace hanei
