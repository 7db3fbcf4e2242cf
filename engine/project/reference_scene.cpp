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
}

}  // namespace hanei
