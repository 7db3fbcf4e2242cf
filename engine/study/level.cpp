#include "engine/study/level.h"

#include "engine/mesh/refine.h"
#include "engine/scene/colour.h"
#include "engine/study/stage_keys.h"
#include "engine/transport/ambient.h"
#include "engine/transport/closed_part.h"
#include "engine/transport/series.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace hanei {

namespace {

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

std::vector<Receiver> vertex_receivers(const Mesh& mesh) {
    std::vector<Receiver> receivers;
    receivers.reserve(mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices) receivers.push_back(vertex.receiver);
    return receivers;
}

/// The mesh whose patches are the quarters that the nodes stand for. A patch half in shadow and half
/// hidden from a receiver shows mostly its lit part: each node needs a share of its own.
std::shared_ptr<const Mesh> quartered(const Mesh& mesh, const Nodes& nodes) {
    return in_parts(mesh,
                    [&](PatchId patch) {
                        const auto quarters = quarters_of(mesh, nodes, patch);
                        return std::vector<Polygon>(quarters.begin(), quarters.end());
                    })
        .mesh;
}

/// As floats while they are small against the memory they may take, else in fewer bits.
RowStorage storage(const Settings& settings, std::size_t coefficients) {
    const std::size_t memory = static_cast<std::size_t>(settings.memory_mb) * 1024 * 1024;
    const bool small = coefficients * 2 * sizeof(float) <= memory / 4;
    return {small || is_of_the_paper(settings.method) ? RowFormat::exact : RowFormat::compact, memory};
}

/// A figure of every patch, once for each of its nodes.
template <class Value>
std::vector<double> spread(const Mesh& mesh, const Nodes& nodes, Value&& value) {
    std::vector<double> spread;
    spread.reserve(nodes.size());
    for (std::size_t p = 0; p < mesh.patches.size(); ++p) spread.insert(spread.end(), nodes.per_patch, value(p));
    return spread;
}

}  // namespace

Level::Cut Level::cut(const Scene& scene, double max_patch, Method method, std::span<const ObjectId> black) {
    const MeshKey key{surfaces_of(scene), max_patch, method, {black.begin(), black.end()}};
    const auto* mesh = meshes_.get(key, [&] {
        return std::optional(
            make_mesh(scene, max_patch, method == Method::linear ? Grading::crowded : Grading::uniform, black));
    });
    return cut(*mesh, method);
}

Level::Cut Level::cut(std::shared_ptr<const Mesh> mesh, Method method) {
    const Elements elements = method == Method::linear ? Elements::linear : Elements::constant;
    const bool same = cut_.mesh && of_the_paper_ == is_of_the_paper(method) && elements == cut_.nodes->elements &&
                      same_shapes(*cut_.mesh, *mesh);
    cut_.mesh = std::move(mesh);
    of_the_paper_ = is_of_the_paper(method);
    if (!same) {
        cut_.nodes = std::make_shared<const Nodes>(nodes_of(*cut_.mesh, elements));
        seen_ = elements == Elements::linear ? quartered(*cut_.mesh, *cut_.nodes) : cut_.mesh;
        geometry_ = std::make_shared<const int>();
    }
    unknowns_ = of_the_paper_ ? vertex_receivers(*cut_.mesh) : cut_.nodes->receivers;
    return cut_;
}

std::vector<double> Level::patch_values(std::span<const double> at_unknowns) const {
    if (at_unknowns.empty()) return std::vector<double>(cut_.mesh->patches.size(), 0.0);
    return of_the_paper_ ? patch_exitance(*cut_.mesh, at_unknowns) : patch_means(*cut_.nodes, at_unknowns);
}

std::vector<double> Level::node_values(std::span<const double> at_unknowns) const {
    if (at_unknowns.empty()) return std::vector<double>(cut_.nodes->size(), 0.0);
    return of_the_paper_ ? patch_exitance(*cut_.mesh, at_unknowns)
                         : std::vector<double>(at_unknowns.begin(), at_unknowns.end());
}

std::vector<double> Level::vertex_values(std::span<const double> at_unknowns) const {
    if (at_unknowns.empty()) return std::vector<double>(cut_.mesh->vertices.size(), 0.0);
    return of_the_paper_ ? std::vector<double>(at_unknowns.begin(), at_unknowns.end())
                         : hanei::vertex_values(*cut_.mesh, *cut_.nodes, at_unknowns);
}

/// Means over patches, at the nodes of linear elements by means over their quarters.
LightReceivers Level::receivers_at_nodes(const LevelInput& input, const Work& work) const {
    LightReceivers receivers;
    receivers.identity = geometry_;
    receivers.count = cut_.mesh->patches.size();
    receivers.figures = cut_.nodes->per_patch;
    receivers.accuracy = input.direct_accuracy;
    receivers.finer_will_do = input.warm;
    receivers.places = [mesh = cut_.mesh](std::size_t p) { return std::span<const Vec3>(mesh->patches[p].outline); };
    const bool linear = cut_.nodes->elements == Elements::linear;
    receivers.compute = [this, linear, &input, &work](const Emitter& emitter, std::span<const std::uint32_t> which) {
        return linear ? means_of_quarters(emitter, which, input, work) : means_of_patches(emitter, which, input, work);
    };
    return receivers;
}

std::optional<std::vector<double>> Level::means_of_patches(const Emitter& emitter, std::span<const std::uint32_t> which,
                                                           const LevelInput& input, const Work& work) const {
    std::vector<ReceivingPolygon> polygons;
    polygons.reserve(which.size());
    for (const std::uint32_t p : which) {
        const Patch& patch = cut_.mesh->patches[p];
        polygons.push_back({patch.outline, cut_.mesh->faces[patch.face].face.normal});
    }
    auto means = mean_direct_estimates(emitter, polygons, input.occluders.get(), input.direct_accuracy, work);
    if (means) means->resize(which.size());  // their errors come after them
    return means;
}

std::optional<std::vector<double>> Level::means_of_quarters(const Emitter& emitter,
                                                            std::span<const std::uint32_t> which,
                                                            const LevelInput& input, const Work& work) const {
    const Mesh& mesh = *cut_.mesh;
    std::vector<std::array<Polygon, 4>> quarters;
    std::vector<ReceivingPolygon> polygons;
    quarters.reserve(which.size());
    for (const std::uint32_t p : which) {
        const Patch& patch = mesh.patches[p];
        const auto& parts = quarters.emplace_back(quarters_of(mesh, *cut_.nodes, PatchId{p}));
        for (const Polygon& part : parts) polygons.push_back({part, mesh.faces[patch.face].face.normal});
    }
    const auto means = mean_direct_estimates(emitter, polygons, input.occluders.get(), input.direct_accuracy, work);
    if (!means) return std::nullopt;
    std::vector<double> values;
    values.reserve(4 * which.size());
    for (std::size_t k = 0; k < which.size(); ++k) {
        std::array<double, 4> of_quarters{};
        std::copy_n(means->begin() + static_cast<std::ptrdiff_t>(4 * k), 4, of_quarters.begin());
        const auto at_nodes = node_values_of_quarters(mesh, *cut_.nodes, PatchId{which[k]}, of_quarters);
        values.insert(values.end(), at_nodes.begin(), at_nodes.end());
    }
    return values;
}

/// The paper's unknowns: light at the grid points themselves.
LightReceivers Level::receivers_at_vertices(const LevelInput& input, const Work& work) const {
    LightReceivers receivers;
    receivers.identity = geometry_;
    receivers.count = unknowns_.size();
    receivers.places = [mesh = cut_.mesh](std::size_t k) { return std::span(&mesh->vertices[k].receiver.position, 1); };
    receivers.compute = [this, &input, &work](const Emitter& emitter, std::span<const std::uint32_t> which) {
        std::vector<Receiver> some;
        some.reserve(which.size());
        for (const std::uint32_t k : which) some.push_back(unknowns_[k]);
        return direct_illuminance(emitter, some, input.occluders.get(), work);
    };
    return receivers;
}

std::vector<double> Level::reflectances(const Scene& scene, const EffectsPlan& plan, int band) const {
    const bool one_band = !plan.simulates(Effect::three_bands);
    std::map<ObjectId, double> by_material;
    for (const Material& material : scene.materials) {
        const auto [red, green, blue] = band_reflectances(material);
        const Vec3 bands{red, green, blue};
        // one band stands for a coloured material by its luminance; of a neutral one all three are equal to the bit
        by_material.emplace(material.id, one_band && bands != Vec3{red} ? luminance(bands) : bands[band]);
    }
    std::vector<bool> black;
    for (const MeshFace& face : cut_.mesh->faces)
        black.push_back(std::find(plan.black.begin(), plan.black.end(), face.face.ref.object) != plan.black.end());
    const auto of = [&](const auto& element) {
        if (black[element.face]) return 0.0;
        const auto found = by_material.find(element.material);
        return found == by_material.end() ? 0.0 : found->second;
    };
    if (!of_the_paper_)
        return spread(*cut_.mesh, *cut_.nodes, [&](std::size_t p) { return of(cut_.mesh->patches[p]); });
    std::vector<double> values;
    for (const Vertex& vertex : cut_.mesh->vertices) values.push_back(of(vertex));
    return values;
}

std::vector<double> Level::unknown_areas() const {
    if (!of_the_paper_) return cut_.nodes->areas;
    std::vector<double> areas;
    for (const Vertex& vertex : cut_.mesh->vertices) areas.push_back(vertex.area);
    return areas;
}

std::vector<double> Level::own_exitances() const {
    if (!of_the_paper_)
        return spread(*cut_.mesh, *cut_.nodes, [&](std::size_t p) { return cut_.mesh->patches[p].own_exitance.value; });
    std::vector<double> values;
    for (const Vertex& vertex : cut_.mesh->vertices) values.push_back(vertex.own_exitance.value);
    return values;
}

namespace {

/// How the output of a group's luminaires divides over the bands.
struct MemberColours {
    std::vector<Vec3> of;  ///< one a member
    bool one = true;       ///< all alike

    MemberColours(const LightGroup& group, const Scene& scene, bool one_band) {
        for (const LightGroup::Member& member : group.members)
            of.push_back(one_band ? Vec3{1.0} : band_output(*member.luminaire, scene));
        one = !of.empty() && std::all_of(of.begin(), of.end(), [&](const Vec3& each) { return each == of.front(); });
    }
};

}  // namespace

/// Light of every group that is not dark on the unknowns, one list a member; empty when stopped.
std::optional<std::vector<SideInput>> Level::side_inputs(const LevelInput& input, const Work& work) {
    const LightReceivers receivers =
        of_the_paper_ ? receivers_at_vertices(input, work) : receivers_at_nodes(input, work);
    const int bands = input.plan->simulates(Effect::three_bands) ? colour_bands : 1;
    const std::vector<double> own = own_exitances();
    const bool shines = std::any_of(own.begin(), own.end(), [](double exitance) { return exitance > 0.0; });
    std::vector<std::vector<double>> reflecting;
    for (int band = 0; band < bands; ++band) reflecting.push_back(reflectances(*input.scene, *input.plan, band));

    direct_.start();
    std::vector<SideInput> inputs;
    levels_.clear();
    for (const LightGroup& group : light_groups(*input.scene)) {
        const bool surfaces = group.members.empty();
        if (surfaces ? !shines : group.level <= 0.0) continue;
        SideInput side;
        for (const LightGroup::Member& member : group.members) {
            side.direct.push_back(direct_.of(*input.scene, *member.luminaire, receivers, input.occluders));
            if (!side.direct.back()) return std::nullopt;
        }
        const MemberColours colours(group, *input.scene, bands == 1);
        for (int band = 0; band < bands; ++band) {
            SideInput& made = inputs.emplace_back(side);
            made.name = {surfaces ? ObjectId{} : group.members.front().luminaire->id, band};
            made.reflectance = reflecting[static_cast<std::size_t>(band)];
            // a colour that all its luminaires share is mixed, like its level
            const double tinted = colours.one ? colours.of.front()[band] : 1.0;
            for (std::size_t m = 0; m < group.members.size(); ++m)
                made.shares.push_back(group.members[m].share * (colours.one ? 1.0 : colours.of[m][band]));
            if (surfaces) made.own_exitance = own;
            // what stays is brought closer than asked: the room's flux is told to a thousandth
            constexpr double closer = 0.1;
            made.limits = {input.settings->bounces, input.settings->accuracy * (input.warm ? 1.0 : closer)};
            const double weight = bands == 1 ? 1.0 : luminance_weights[band];
            levels_.push_back({group.level * tinted, weight, band, surfaces, nullptr});
        }
    }
    direct_.forget_others(*input.scene);
    return inputs;
}

/// Means over patches: those of the unknowns, but for the paper's grid points.
std::optional<std::vector<double>> Level::patch_direct(const LevelInput& input, std::span<const SideInput> sides,
                                                       const Work& work) {
    if (of_the_paper_) return patch_direct_.sum(*input.scene, receivers_at_nodes(input, work), input.occluders);
    std::vector<double> total(unknowns_.size(), 0.0);
    for (std::size_t s = 0; s < sides.size(); ++s) {
        const std::vector<double> direct = sides[s].direct_sum();
        const double share = levels_[s].level * levels_[s].band_weight;
        for (std::size_t k = 0; k < total.size(); ++k) total[k] += share * direct[k];
    }
    return patch_values(total);
}

RowsInput Level::rows_between_surfaces(const LevelInput& input) const {
    RowsInput rows;
    rows.kind = input.settings->method == Method::paper          ? RowsInput::Kind::paper
                : input.settings->method == Method::paper_closed ? RowsInput::Kind::paper_closed
                                                                 : RowsInput::Kind::nodes;
    rows.mesh = cut_.mesh;
    rows.nodes = cut_.nodes;
    rows.seen = seen_;
    rows.geometry = rows.receivers_are = geometry_;
    rows.receivers = unknowns_;
    rows.occluders = input.patch_occluders;
    rows.storage = storage(*input.settings, unknowns_.size() * unknowns_.size());
    return rows;
}

/// Before any interreflection: direct light, and one ambient illuminance for all that is reflected; or
/// nothing of it, and no bound on what is left out.
LevelAnswer Level::first_guess(std::span<const SideInput> sides, std::vector<double> patch_direct,
                               bool with_ambient) const {
    LevelAnswer answer;
    answer.patch_direct = std::move(patch_direct);
    const std::vector<double> areas = unknown_areas();
    for (std::size_t s = 0; s < sides.size(); ++s) {
        auto light = std::make_shared<SideLight>();
        light->direct = sides[s].direct_sum();
        const std::vector<double> own =
            sides[s].own_exitance.empty() ? std::vector<double>(areas.size(), 0.0) : sides[s].own_exitance;
        const double ambient =
            with_ambient ? ambient_illuminance(areas, sides[s].reflectance, own, light->direct) : 0.0;
        light->interreflected.assign(areas.size(), ambient);
        light->exitance = own;
        for (std::size_t k = 0; k < areas.size(); ++k)
            light->exitance[k] += sides[s].reflectance[k] * (light->direct[k] + ambient);
        light->exitance_half_width.assign(areas.size(), with_ambient ? 0.0 : unbounded);
        MixPart part = levels_[s];
        part.light = std::move(light);
        answer.parts.push_back(std::move(part));
    }
    answer.converged = false;
    return answer;
}

/// The sentence that says which surfaces keep all their light; empty when none do. Nothing when stopped.
std::optional<std::string> Level::refusal(std::span<const SideInput> sides, const Exchange& exchange,
                                          const Scene& scene, const Work& work) const {
    constexpr double row_error = 2e-3;  // of rows in few bits
    for (const SideInput& side : sides) {
        std::vector<double> emitted = side.direct_sum();
        for (std::size_t k = 0; k < emitted.size(); ++k) {
            emitted[k] *= side.reflectance[k];
            if (!side.own_exitance.empty()) emitted[k] += side.own_exitance[k];
        }
        const auto closed = closed_unknowns(exchange, side.reflectance, emitted, work, row_error);
        if (!closed) return std::nullopt;
        if (closed->empty()) continue;
        std::set<std::string> names;
        for (const std::size_t k : *closed) {
            const ObjectId id = of_the_paper_ ? cut_.mesh->vertices[k].material
                                              : cut_.mesh->patches[k / cut_.nodes->per_patch].material;
            for (const Material& material : scene.materials)
                if (material.id == id) names.insert(material.name);
        }
        std::string list;
        for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
        return "Surfaces that reflect all light see only each other (" + list +
               "): interreflection grows without end. Give one of them a reflectance below 1, or open the room.";
    }
    return std::string();
}

std::optional<LevelAnswer> Level::solve(const LevelInput& input, const Work& work, StageClock& clock,
                                        const std::function<void(const LevelAnswer&)>& on_way) {
    clock.enter(Stage::direct);
    auto sides = side_inputs(input, work);
    if (!sides) return std::nullopt;
    auto patch_light = patch_direct(input, *sides, work);
    if (!patch_light) return std::nullopt;
    clock.mark_reused(direct_.reused());
    if (on_way) on_way(first_guess(*sides, *patch_light, true));

    LevelAnswer answer;
    answer.patch_direct = std::move(*patch_light);
    if (!input.plan->simulates(Effect::interreflection)) return answer;

    clock.enter(Stage::factors);
    const StoredRows* const rows = rows_.get(rows_between_surfaces(input), work);
    if (!rows) return std::nullopt;
    clock.mark_reused(rows_.reused());

    clock.enter(Stage::balance);
    for (SideInput& side : *sides) side.rows = rows_.version();
    const Exchange exchange = [&](std::span<const double> leaving, std::span<double> arriving, std::size_t count) {
        return rows->multiply(leaving, arriving, count, work);
    };
    auto reason = refusal(*sides, exchange, *input.scene, work);
    if (!reason) return std::nullopt;
    if (!reason->empty()) {
        LevelAnswer direct_only = first_guess(*sides, std::move(answer.patch_direct), false);
        direct_only.refusal = std::move(*reason);
        return direct_only;
    }
    const std::vector<double>* const sums = row_sums_.get(rows_.version(), [&] { return rows->row_sums(work); });
    if (!sums) return std::nullopt;
    const auto lights =
        sides_.get(std::move(*sides), {exchange, unknown_areas(), *sums, !of_the_paper_}, input.warm, work);
    if (!lights) return std::nullopt;
    clock.mark_reused(sides_.reused());
    for (std::size_t s = 0; s < lights->size(); ++s) {
        MixPart part = levels_[s];
        part.light = (*lights)[s];
        answer.bounces = std::max(answer.bounces, part.light->bounces);
        answer.converged = answer.converged && part.light->converged;
        answer.greatest_row_sum = std::max(answer.greatest_row_sum, part.light->greatest_row_sum);
        answer.greatest_gain = std::max(answer.greatest_gain, std::abs(part.light->gain - 1.0));
        answer.parts.push_back(std::move(part));
    }
    return answer;
}

/// Where interreflection is not followed: what surfaces would reflect is sent and arrives nowhere.
static FluxAccount account_of_direct(const Mesh& mesh, const Scene& scene, std::span<const double> direct) {
    FluxAccount account;
    const PerPatch<double> reflectance = reflectances(mesh, scene);
    for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
        const double arriving = mesh.patches[p].area * direct[p];
        account.direct += arriving;
        account.sent += reflectance.all()[p] * arriving;
    }
    account.absorbed = account.direct - account.sent;
    return account;
}

std::optional<FluxAccount> Level::flux(const LevelAnswer& answer, const Scene& scene, const EffectsPlan& plan,
                                       const Work& work) {
    if (answer.parts.empty()) return account_of_direct(*cut_.mesh, scene, answer.patch_direct);
    FluxAccount total;
    const std::vector<double>* const sums = row_sums_.get(rows_.version(), [&] { return rows_.now()->row_sums(work); });
    if (!sums) return std::nullopt;
    const std::vector<double> areas = unknown_areas(), own = own_exitances(), none(areas.size(), 0.0);
    for (const MixPart& part : answer.parts) {
        const std::vector<double> reflecting = reflectances(scene, plan, part.band);
        const FluxAccount account = account_of(
            {areas, reflecting, part.of_surfaces ? own : none, part.light->direct, part.light->interreflected, *sums});
        const double share = part.level * part.band_weight;
        total.own += share * account.own;
        total.direct += share * account.direct;
        total.absorbed += share * account.absorbed;
        total.escaped += share * account.escaped;
        total.sent += share * account.sent;
        total.received += share * account.received;
    }
    return total;
}

std::optional<GatheredLight> Level::gather(int slot, std::span<const MixPart> parts,
                                           const std::shared_ptr<const std::vector<Receiver>>& receivers,
                                           const LevelInput& input, const Work& work, StageClock& clock) {
    RowsInput rows = rows_between_surfaces(input);
    rows.kind = RowsInput::Kind::nodes;
    rows.receivers_are = receivers;
    rows.receivers = *receivers;
    rows.storage = storage(*input.settings, receivers->size() * cut_.nodes->size());
    const auto source_of = [this](const SideLight& light) {
        return GatherStage::Source{node_values(light.exitance), node_values(light.exitance_half_width)};
    };
    auto gathered = gathering_[slot].get(rows, parts, source_of, work);
    clock.mark_reused(gathering_[slot].reused());
    return gathered;
}

}  // namespace hanei
