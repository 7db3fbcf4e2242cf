#include "engine/direct/light_on_luminaires.h"

#include "engine/geometry/polygon.h"

#include <algorithm>

namespace hanei {

namespace {

/// The faces of a body; both sides of a flat one.
std::vector<Polygon> sides_of(const ConvexBody& body) {
    std::vector<Polygon> sides;
    for (const auto& loop : body.faces) {
        Polygon side;
        for (const int vertex : loop) side.push_back(body.vertices[static_cast<std::size_t>(vertex)]);
        sides.push_back(std::move(side));
    }
    if (sides.size() == 1) sides.emplace_back(sides[0].rbegin(), sides[0].rend());
    return sides;
}

}  // namespace

std::optional<Estimate> flux_on_luminaires(const Emitter& emitter, const Scene& scene, const OccluderSet& occluders,
                                           const Accuracy& accuracy, const Work& work) {
    std::vector<Polygon> sides;
    for (const ConvexBody& body : occluders.bodies()) {
        if (body.owner == emitter.luminaire().value) continue;
        const auto owns = [&](const Luminaire& luminaire) { return luminaire.id.value == body.owner; };
        if (std::ranges::none_of(scene.luminaires, owns)) continue;
        std::ranges::move(sides_of(body), std::back_inserter(sides));
    }
    std::vector<ReceivingPolygon> polygons;
    for (const Polygon& side : sides) polygons.push_back({side, unit_normal(side)});
    const auto means = mean_direct_estimates(emitter, polygons, &occluders, accuracy, work);
    if (!means) return std::nullopt;
    Estimate flux;
    for (std::size_t k = 0; k < sides.size(); ++k) {
        const double area = glm::length(vector_area(sides[k]));
        flux.value += area * (*means)[k];
        flux.error += area * (*means)[sides.size() + k];
    }
    return flux;
}

}  // namespace hanei
