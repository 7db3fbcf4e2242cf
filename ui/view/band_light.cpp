#include "ui/view/band_light.h"

#include "engine/scene/colour.h"

#include <map>

namespace hanei {
namespace {

Vec3 of_unit_luminance(const Vec3& bands) {
    const double sum = luminance(bands);
    return sum > 0.0 ? bands / sum : Vec3(1.0);
}

Vec3 bands_of(const DisplayMesh& display, std::uint32_t vertex) {
    const std::array<float, 3>& bands = display.tinted[vertex];
    return {static_cast<double>(bands[0]), static_cast<double>(bands[1]), static_cast<double>(bands[2])};
}

}  // namespace

std::vector<Vec3> patch_colours(const Solution& solution) {
    std::map<ObjectId, Vec3> of_material;
    for (const Material& material : solution.scene->materials) {
        const auto [red, green, blue] = band_reflectances(material);
        of_material.emplace(material.id, Vec3(red, green, blue));
    }
    std::vector<Vec3> colours;
    colours.reserve(solution.mesh->patches.size());
    for (const Patch& patch : solution.mesh->patches) {
        const auto found = of_material.find(patch.material);
        colours.push_back(found == of_material.end() ? Vec3(0.0) : found->second);
    }
    return colours;
}

std::array<std::array<double, 4>, 3> bands_at_corners(const DisplayMesh& display, const DisplayCell& cell,
                                                      const std::array<double, 4>& lux) {
    std::array<std::array<double, 4>, 3> bands{lux, lux, lux};
    if (display.tinted.empty()) return bands;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const Vec3 colour = of_unit_luminance(bands_of(display, cell.corner[corner]));
        for (int b = 0; b < colour_bands; ++b) bands[b][corner] = colour[b] * lux[corner];
    }
    if (cell.corner[3] == cell.corner[2])
        for (auto& band : bands) band[3] = band[0] + band[2] - band[1];
    return bands;
}

Vec3 bands_at(const DisplayMesh& display, const DisplayCell& cell, const Vec2& at, double lux) {
    if (display.tinted.empty()) return Vec3(lux);
    std::array<std::array<double, 4>, 3> corners{};
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const Vec3 bands = bands_of(display, cell.corner[corner]);
        for (int b = 0; b < colour_bands; ++b) corners[b][corner] = bands[b];
    }
    Vec3 bands(0.0);
    for (int b = 0; b < colour_bands; ++b) {
        if (cell.corner[3] == cell.corner[2]) corners[b][3] = corners[b][0] + corners[b][2] - corners[b][1];
        bands[b] = std::max(0.0, bilinear(corners[b], at));
    }
    return lux * of_unit_luminance(bands);
}

}  // namespace hanei
