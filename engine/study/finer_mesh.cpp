#include "engine/study/finer_mesh.h"

#include "engine/base/tiles.h"
#include "engine/geometry/polygon.h"
#include "engine/mesh/refine.h"
#include "engine/mesh/refinement_need.h"
#include "engine/transport/factor_rows.h"
#include "engine/transport/visible_shares.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hanei {

namespace {

constexpr int vertices_slot = 1;
constexpr std::size_t points_a_tile = 16;

std::size_t tiles_of(std::span<const Receiver> places) { return (places.size() + points_a_tile - 1) / points_a_tile; }

/// All that arrives at every vertex, lx.
std::optional<std::vector<double>> light_at_vertices(Level& level, const LevelAnswer& answer, const LevelInput& input,
                                                     const Work& work, StageClock& clock) {
    std::vector<Receiver> receivers;
    for (const Vertex& vertex : level.now().mesh->vertices) receivers.push_back(vertex.receiver);
    const auto shared = std::make_shared<const std::vector<Receiver>>(std::move(receivers));
    auto gathered = level.gather(vertices_slot, answer.parts, shared, input, work, clock);
    if (!gathered) return std::nullopt;
    for (const Luminaire& luminaire : input.scene->luminaires) {
        const double share = output_share(*input.scene, luminaire);
        if (share <= 0.0) continue;
        const auto direct = direct_estimates(Emitter(*input.scene, luminaire), *shared, input.occluders.get(),
                                             input.direct_accuracy, work);
        if (!direct) return std::nullopt;
        for (std::size_t k = 0; k < shared->size(); ++k) gathered->interreflected[k] += share * (*direct)[k];
    }
    return std::move(gathered->interreflected);
}

/// What the elements say at every corner of every patch (linear), or of the patch's mean (constant), lx.
std::vector<double> light_of_elements(const Level& level, const std::vector<double>& at_nodes) {
    const Mesh& mesh = *level.now().mesh;
    if (level.now().nodes->elements == Elements::constant) return level.patch_values(at_nodes);
    std::vector<double> values;
    for (std::uint32_t p = 0; p < mesh.patches.size(); ++p)
        for (const Vec3& corner : mesh.patches[p].outline)
            values.push_back(exitance_at(mesh, *level.now().nodes, PatchId{p}, corner, at_nodes));
    return values;
}

/// What a solution says: all that arrives, lx.
struct CornerLight {
    std::vector<double> at_nodes, at_vertices;
    std::vector<double> of_elements;  ///< at every corner of every patch, or of the patch's mean
};

std::optional<CornerLight> corner_light(Level& level, const LevelAnswer& answer, const LevelInput& input,
                                        const Work& work, StageClock& clock) {
    auto at_vertices = light_at_vertices(level, answer, input, work, clock);
    if (!at_vertices) return std::nullopt;
    CornerLight light{mixed(answer.parts, &SideLight::direct), std::move(*at_vertices), {}};
    const std::vector<double> interreflected = mixed(answer.parts, &SideLight::interreflected);
    for (std::size_t k = 0; k < light.at_nodes.size(); ++k) light.at_nodes[k] += interreflected[k];
    light.of_elements = light_of_elements(level, light.at_nodes);
    return light;
}

/// Calculation points, and a place on every face, whose mean is told as well.
struct Wishes {
    std::vector<Receiver> places;
    std::vector<double> illuminance;  ///< lx
};

Wishes wishes_of(const Level& level, const WishedValues& wished, const std::vector<double>& arriving) {
    constexpr std::size_t most_faces = 200;  // more take from the points what they ask for
    Wishes wishes{{wished.points.begin(), wished.points.end()}, {wished.illuminance.begin(), wished.illuminance.end()}};
    const Mesh& mesh = *level.now().mesh;
    if (mesh.faces.size() > most_faces) return wishes;
    for (const MeshFace& face : mesh.faces) {
        if (face.patch_count == 0) continue;
        const std::size_t node = (face.first_patch + face.patch_count / 2) * level.now().nodes->per_patch;
        wishes.places.push_back(level.now().nodes->receivers[node]);
        wishes.illuminance.push_back(arriving[node]);
    }
    return wishes;
}

/// Calls visit(tile, place, what it sees of every patch: form factor x visible share) for all places, those of a
/// tile in their order. False when stopped.
template <class Visit>
bool for_each_sight(const Level& level, std::span<const Receiver> places, const LevelInput& input, const Work& work,
                    Visit&& visit) {
    const Mesh& mesh = *level.now().mesh;
    const Nodes& nodes = *level.now().nodes;
    return for_each_tile(tiles_of(places), 1, work, [&](std::size_t tile, std::size_t) {
        FactorRows factors(mesh, nodes);
        std::optional<VisibleShares> visible;
        if (input.patch_occluders) visible.emplace(mesh, *input.patch_occluders);
        const std::size_t first = tile * points_a_tile;
        const auto points = places.subspan(first, std::min(points_a_tile, places.size() - first));
        std::vector<float> rows(points.size() * nodes.size(), 0.0F), shares(points.size() * mesh.patches.size(), 1.0F);
        factors.write(points, rows.data());
        if (visible) visible->write(points, shares.data());
        std::vector<double> seen(mesh.patches.size());
        for (std::size_t k = 0; k < points.size(); ++k) {
            std::ranges::fill(seen, 0.0);
            for (std::size_t j = 0; j < nodes.size(); ++j)
                seen[j / nodes.per_patch] += static_cast<double>(rows[k * nodes.size() + j]);
            for (std::size_t p = 0; p < seen.size(); ++p)
                seen[p] *= static_cast<double>(shares[k * mesh.patches.size() + p]);
            visit(tile, first + k, std::span<const double>(seen));
        }
    });
}

std::optional<std::vector<double>> importance(const Level& level, const Wishes& wished, const LevelInput& input,
                                              const Work& work) {
    const Mesh& mesh = *level.now().mesh;
    // of each tile, so that their order is fixed
    std::vector<std::vector<double>> sums(tiles_of(wished.places), std::vector<double>(mesh.patches.size(), 0.0));
    const auto add = [&](std::size_t tile, std::size_t place, std::span<const double> seen) {
        if (!(wished.illuminance[place] > 0.0)) return;
        for (std::size_t p = 0; p < seen.size(); ++p) sums[tile][p] += seen[p] / wished.illuminance[place];
    };
    if (!for_each_sight(level, wished.places, input, work, add)) return std::nullopt;

    double area = 0.0;
    for (const Patch& patch : mesh.patches) area += patch.area;
    const double points = static_cast<double>(wished.places.size());
    const double mean = std::accumulate(wished.illuminance.begin(), wished.illuminance.end(), 0.0) / points;
    std::vector<double> importance(mesh.patches.size(), 0.0);
    for (std::size_t p = 0; p < importance.size(); ++p) {
        for (const std::vector<double>& sum : sums) importance[p] += sum[p] / points;
        if (mean > 0.0) importance[p] += mesh.patches[p].area / area / mean;
    }
    return importance;
}

}  // namespace

std::shared_ptr<const Mesh> finer_mesh(Level& level, const LevelAnswer& answer, const WishedValues& wished,
                                       double growth, const LevelInput& input, const Work& work, StageClock& clock) {
    const auto corners = corner_light(level, answer, input, work, clock);
    if (!corners) return nullptr;
    const Mesh& mesh = *level.now().mesh;
    const PerPatch<double> reflectance = reflectances(mesh, *input.scene);
    MeshLight light{corners->at_vertices, corners->of_elements, reflectance.all(), {}};
    std::vector<double> important;
    const Wishes wishes = wishes_of(level, wished, corners->at_nodes);
    if (!wishes.places.empty()) {
        auto asked = importance(level, wishes, input, work);
        if (!asked) return nullptr;
        important = std::move(*asked);
        light.importance = important;
    }
    const auto more = static_cast<std::size_t>(growth * static_cast<double>(mesh.patches.size()));
    return refined(mesh, patches_to_split(mesh, refinement_need(mesh, light), more)).mesh;
}

std::optional<std::vector<double>> misplaced_light(Level& level, const LevelAnswer& answer,
                                                   std::span<const Receiver> places, const LevelInput& input,
                                                   const Work& work, StageClock& clock) {
    const auto corners = corner_light(level, answer, input, work, clock);
    if (!corners) return std::nullopt;
    const Mesh& mesh = *level.now().mesh;
    const PerPatch<double> reflectance = reflectances(mesh, *input.scene);
    const std::vector<double> alike(mesh.patches.size(), 1.0);
    const std::vector<double> missed =
        refinement_need(mesh, {corners->at_vertices, corners->of_elements, reflectance.all(), alike});
    std::vector<double> lux(places.size(), 0.0);
    const auto gather = [&](std::size_t, std::size_t place, std::span<const double> seen) {
        double squares = 0.0;
        for (std::size_t p = 0; p < seen.size(); ++p) {
            if (!(seen[p] > 0.0) || !(missed[p] > 0.0)) continue;
            const Patch& patch = mesh.patches[p];
            const double radius = 0.5 * diameter(patch.outline);
            const double near = std::max(0.0, glm::distance(patch.centre, places[place].position) - radius);
            const double share = seen[p] * missed[p] * radius / (radius + near);
            squares += share * share;
        }
        lux[place] = std::sqrt(squares);
    };
    if (!for_each_sight(level, places, input, work, gather)) return std::nullopt;
    return lux;
}

}  // namespace hanei
