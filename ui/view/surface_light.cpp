#include "ui/view/surface_light.h"

#include "engine/base/tiles.h"

#include <algorithm>

namespace hanei {
namespace {

/// The light on a border is that of the cell's own side.
Receiver receiver_at(const Vec3& place, const Vec3& normal, const Vec3& centre) {
    const Vec3 inward = centre - place;
    const double length = glm::length(inward);
    return {place, normal, length > 0.0 ? inward / length : Vec3(0.0)};
}

Vec3 centre_of(const DisplayMesh& display, const DisplayCell& cell) {
    Vec3 sum(0.0);
    for (const std::uint32_t corner : cell.corner) sum += display.vertices[corner].position;
    return 0.25 * sum;
}

}  // namespace

SurfaceLight::SurfaceLight(const Solution& solution, const DirectLight& direct, LightPart part)
    : solution_(solution), direct_(direct), part_(part) {}

bool SurfaceLight::prepare(const Work& work) {
    const std::vector<DisplayVertex>& vertices = solution_.display->vertices;
    laid_over_.assign(vertices.size(), 0.0);
    for (std::size_t k = 0; k < vertices.size() && part_ != LightPart::direct; ++k)
        laid_over_[k] =
            static_cast<double>(part_ == LightPart::unshadowed ? vertices[k].unshadowed : vertices[k].interreflected);
    return part_ != LightPart::unshadowed || take_direct_from_vertices(work);
}

/// The part without shadows is kept as a sum: its direct light is taken out again.
bool SurfaceLight::take_direct_from_vertices(const Work& work) {
    const DisplayMesh& display = *solution_.display;
    std::vector<Receiver> receivers(display.vertices.size());
    for (const DisplayCell& cell : display.cells) {
        for (const std::uint32_t corner : cell.corner)
            receivers[corner] = receiver_at(display.vertices[corner].position,
                                            solution_.mesh->faces[cell.face].face.normal, centre_of(display, cell));
    }
    return for_each_tile(receivers.size(), 64, work, [&](std::size_t begin, std::size_t end) {
        std::vector<double> lux(end - begin);
        direct_(std::span(receivers).subspan(begin, end - begin), lux);
        for (std::size_t k = begin; k < end; ++k) laid_over_[k] = std::max(0.0, laid_over_[k] - lux[k - begin]);
    });
}

std::vector<double> SurfaceLight::at(std::span<const Seen> places, const Sight& sight) const {
    const DisplayMesh& display = *solution_.display;
    std::vector<double> lux(places.size(), 0.0);
    if (part_ != LightPart::interreflected) {
        std::vector<Receiver> receivers;
        receivers.reserve(places.size());
        for (const Seen& seen : places)
            receivers.push_back(
                receiver_at(seen.place, sight.frame(seen.cell).normal, centre_of(display, display.cells[seen.cell])));
        direct_(receivers, lux);
    }
    if (part_ == LightPart::direct) return lux;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const DisplayCell& cell = display.cells[places[k].cell];
        std::array<double, 4> corner{};
        for (std::size_t c = 0; c < 4; ++c) corner[c] = laid_over_[cell.corner[c]];
        if (cell.corner[3] == cell.corner[2]) corner[3] = corner[0] + corner[2] - corner[1];
        lux[k] += std::max(0.0, bilinear(corner, places[k].at));
    }
    return lux;
}

}  // namespace hanei
