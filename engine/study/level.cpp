#include "engine/study/level.h"

#include "engine/base/check.h"
#include "engine/study/stage_keys.h"

#include <algorithm>

namespace hanei {

namespace {

std::vector<double> own_exitances(const Mesh& mesh, Method method) {
    std::vector<double> own;
    if (method == Method::paper) {
        own.reserve(mesh.vertices.size());
        for (const Vertex& vertex : mesh.vertices) own.push_back(vertex.own_exitance.value);
    } else {
        own.reserve(mesh.patches.size());
        for (const Patch& patch : mesh.patches) own.push_back(patch.own_exitance.value);
    }
    return own;
}

std::vector<double> reflectances_of_unknowns(const Mesh& mesh, const Scene& scene, Method method) {
    if (method == Method::paper) return vertex_reflectances(mesh, scene);
    const PerPatch<double> per_patch = reflectances(mesh, scene);
    return {per_patch.all().begin(), per_patch.all().end()};
}

/// Equal but for materials and what surfaces emit.
bool same_shapes(const Mesh& a, const Mesh& b) {
    if (&a == &b) return true;
    const auto same_patch = [](const Patch& x, const Patch& y) {
        return x.face == y.face && x.corners == y.corners && x.outline == y.outline;
    };
    const auto same_vertex = [](const Vertex& x, const Vertex& y) {
        return x.face == y.face && x.receiver == y.receiver && x.area == y.area;
    };
    return a.faces.size() == b.faces.size() &&
           std::equal(a.patches.begin(), a.patches.end(), b.patches.begin(), b.patches.end(), same_patch) &&
           std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(), same_vertex);
}

std::vector<Receiver> centres_of(const Mesh& mesh) {
    std::vector<Receiver> centres;
    centres.reserve(mesh.patches.size());
    for (const Patch& patch : mesh.patches) centres.push_back(mesh.centre_of(patch));
    return centres;
}

/// Light that the surfaces send out on their own and by direct light only: what is known before
/// any interreflection.
LevelAnswer direct_answer(const Mesh& mesh, std::vector<double> direct) {
    LevelAnswer answer;
    answer.interreflected.assign(mesh.patches.size(), 0.0);
    answer.exitance.assign(mesh.patches.size(), 0.0);
    answer.exitance_half_width.assign(mesh.patches.size(), 0.0);
    answer.direct = std::move(direct);
    return answer;
}

}  // namespace

std::shared_ptr<const Mesh> Level::mesh(const Scene& scene, double max_patch) {
    const MeshKey key{surfaces_of(scene), max_patch};
    const auto* mesh = mesh_.get(key, [&] { return std::optional(make_mesh(scene, max_patch)); });
    if (!geometry_ || !same_shapes(*geometry_, **mesh)) geometry_ = *mesh;
    return *mesh;
}

std::optional<std::vector<double>> Level::patch_direct(const LevelInput& input, const Work& work, StageClock& clock) {
    const auto mesh = this->mesh(*input.scene, input.max_patch);
    std::vector<ReceivingPolygon> polygons;
    polygons.reserve(mesh->patches.size());
    for (const Patch& patch : mesh->patches) polygons.push_back({patch.outline, mesh->faces[patch.face].face.normal});
    auto direct =
        patch_direct_.sum(*input.scene, polygons.size(), geometry_, input.occluders, [&](const Emitter& emitter) {
            return mean_direct_illuminance(emitter, polygons, input.occluders.get(), work);
        });
    clock.mark_reused(patch_direct_.reused());
    return direct;
}

std::optional<std::vector<double>> Level::vertex_direct(const LevelInput& input, const Work& work, StageClock& clock) {
    const auto mesh = this->mesh(*input.scene, input.max_patch);
    std::vector<Receiver> receivers;
    receivers.reserve(mesh->vertices.size());
    for (const Vertex& vertex : mesh->vertices) receivers.push_back(vertex.receiver);
    auto direct = vertex_direct_.sum(
        *input.scene, receivers.size(), geometry_, input.occluders,
        [&](const Emitter& emitter) { return direct_illuminance(emitter, receivers, input.occluders.get(), work); });
    clock.mark_reused(vertex_direct_.reused());
    return direct;
}

const Visibility* Level::visibility(const LevelInput& input, const VisibilityKey& key, const Mesh& mesh,
                                    const Work& work, StageClock& clock) {
    if (input.settings->method == Method::paper) {
        const Visibility* visibility = paper_visibility_.get(key, [&]() -> std::optional<Visibility> {
            return input.patch_occluders ? paper_visibility(mesh, *input.patch_occluders, work) : Visibility{};
        });
        clock.mark_reused(paper_visibility_.reused());
        return visibility;
    }
    const Visibility* visibility =
        patch_visibility_.get({geometry_, geometry_}, mesh, centres_of(mesh), input.patch_occluders, work);
    clock.mark_reused(patch_visibility_.reused());
    return visibility;
}

const Balance* Level::solve_balance(const LevelInput& input, const std::vector<double>& direct, const Work& work,
                                    StageClock& clock) {
    const auto mesh = this->mesh(*input.scene, input.max_patch);
    const Method method = input.settings->method;
    const bool paper = method == Method::paper;

    clock.enter(Stage::factors);
    const FactorKey factor_key{geometry_, method};
    const DenseRows* factors = factors_.get(
        factor_key, [&] { return paper ? paper_factors(*mesh, work) : patch_factors(*mesh, centres_of(*mesh), work); });
    clock.mark_reused(factors_.reused());
    if (!factors) return nullptr;

    const VisibilityKey visibility_key{factor_key, input.patch_occluders};
    const Visibility* visibility = this->visibility(input, visibility_key, *mesh, work, clock);
    if (!visibility) return nullptr;

    clock.enter(Stage::balance);
    const BalanceKey key{visibility_key,
                         reflectances_of_unknowns(*mesh, *input.scene, method),
                         direct,
                         own_exitances(*mesh, method),
                         input.settings->bounces,
                         input.settings->accuracy};
    const Balance* balance = balance_.get(key, [&] {
        return hanei::balance({factors, visibility, key.reflectance, key.direct, key.own_exitance},
                              {key.bounces, key.accuracy}, work);
    });
    clock.mark_reused(balance_.reused());
    return balance;
}

std::optional<LevelAnswer> Level::solve(const LevelInput& input, const Work& work, StageClock& clock,
                                        const std::function<void(const LevelAnswer&)>& on_direct) {
    const auto mesh = this->mesh(*input.scene, input.max_patch);
    clock.enter(Stage::direct);
    auto direct = patch_direct(input, work, clock);
    if (!direct) return std::nullopt;
    LevelAnswer answer = direct_answer(*mesh, std::move(*direct));
    if (on_direct) on_direct(answer);
    if (!input.plan->simulates(Effect::interreflection)) return answer;

    const bool paper = input.settings->method == Method::paper;
    if (paper) {
        auto at_vertices = vertex_direct(input, work, clock);
        if (!at_vertices) return std::nullopt;
        answer.vertex_direct = std::move(*at_vertices);
    }
    const Balance* balance = solve_balance(input, paper ? answer.vertex_direct : answer.direct, work, clock);
    if (!balance) return std::nullopt;
    answer.bounces = balance->bounces;
    answer.converged = balance->converged;
    answer.greatest_row_sum = balance->greatest_row_sum;
    if (paper) {
        answer.vertex_interreflected = balance->interreflected;
        answer.interreflected = patch_exitance(*mesh, balance->interreflected);
        answer.exitance = patch_exitance(*mesh, balance->exitance);
        answer.exitance_half_width = patch_exitance(*mesh, balance->exitance_half_width);
    } else {
        answer.interreflected = balance->interreflected;
        answer.exitance = balance->exitance;
        answer.exitance_half_width = balance->exitance_half_width;
    }
    return answer;
}

Level::GatherRows Level::rows_to(int slot, const std::shared_ptr<const std::vector<Receiver>>& receivers,
                                 const std::shared_ptr<const OccluderSet>& occluders, const Work& work,
                                 StageClock& clock) {
    HANEI_CHECK(geometry_ && mesh_.now());
    const Mesh& mesh = **mesh_.now();
    Gathering& gathering = gathering_[slot];
    const GatherKey key{geometry_, receivers};
    const DenseRows* factors = gathering.factors.get(key, [&] { return patch_factors(mesh, *receivers, work); });
    clock.mark_reused(gathering.factors.reused());
    if (!factors) return {};
    const Visibility* visibility = gathering.visibility.get({geometry_, receivers}, mesh, *receivers, occluders, work);
    clock.mark_reused(gathering.visibility.reused());
    if (!visibility) return {};
    return {factors, visibility};
}

}  // namespace hanei
