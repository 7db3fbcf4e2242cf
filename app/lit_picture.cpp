#include "app/lit_picture.h"

#include "ui/view/band_light.h"
#include "ui/view/tone.h"

#include <map>

namespace hanei {

LitPicture lit_picture(const Solution& solution, const ViewOptions& look) {
    LitPicture picture;
    picture.colours = name_of(look.scale);
    if (look.scale == Scale::false_colour) {
        picture.low = look.range.low;
        picture.high = look.range.high;
    }
    const Tone tone(solution, look);
    const DisplayMesh& display = *solution.display;
    std::map<ObjectId, std::size_t> number_of;
    for (const DisplayCell& cell : display.cells) {
        const ObjectId object = solution.mesh->faces[cell.face].face.ref.object;
        const auto [known, is_new] = number_of.try_emplace(object, picture.surfaces.size());
        if (is_new) picture.surfaces.push_back({object, {}, {}, {}});
        LitSurface& surface = picture.surfaces[known->second];
        const auto lux = corner_values(display, cell, look.part);
        const auto bands = bands_at_corners(display, cell, lux);
        const auto first = static_cast<std::uint32_t>(surface.places.size());
        const bool triangle = cell.corner[3] == cell.corner[2];
        for (std::size_t k = 0; k < (triangle ? 3U : 4U); ++k) {
            const glm::vec3 colour = tone.colour(lux[k], {bands[0][k], bands[1][k], bands[2][k]}, cell.patch);
            surface.places.push_back(display.vertices[cell.corner[k]].position);
            surface.colours.push_back({colour.x, colour.y, colour.z});
        }
        surface.triangles.push_back({first, first + 1, first + 2});
        if (!triangle) surface.triangles.push_back({first, first + 2, first + 3});
    }
    return picture;
}

}  // namespace hanei
