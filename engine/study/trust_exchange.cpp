#include "engine/study/trust_exchange.h"

#include "engine/scene/faces.h"
#include "engine/study/outcome.h"
#include "engine/study/trust_rays.h"
#include "engine/study/value_stage.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace hanei {
namespace {

constexpr double twice = 2.0;             // as wide: what error bars are told from
constexpr double of_a_factor = 2e-4;      // factor_rows.h: how exact one is
constexpr int summed_one_by_one = 20;     // reflections (balance.h): then the last is on its way
constexpr std::size_t most_faces = 6;     // that pass light to each other
constexpr std::size_t most_patches = 64;  // compared one by one
constexpr std::size_t most_looks = 1024;  // rows compared with what is seen
constexpr std::size_t ray_places = 48, rays_a_place = 2048;

/// The same as of the study's own direct light on patches, so that both are one answer.
Accuracy direct_accuracy(const Settings& settings) { return {std::clamp(3.0 * settings.accuracy, 1e-3, 1e-2), 0.0}; }

/// Every so manieth, at most `most`.
std::vector<std::size_t> some_of(std::size_t count, std::size_t most) {
    const std::size_t wanted = std::min(count, most);
    std::vector<std::size_t> some;
    for (std::size_t k = 0; k < wanted; ++k) some.push_back(k * count / wanted);
    return some;
}

std::vector<SurfaceRef> largest_faces(const Mesh& mesh) {
    std::vector<std::pair<double, SurfaceRef>> faces;
    for (const MeshFace& face : mesh.faces) {
        double area = 0.0;
        for (std::size_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p)
            area += mesh.patches[p].area;
        if (area > 0.0) faces.emplace_back(-area, face.face.ref);
    }
    std::stable_sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<SurfaceRef> largest;
    for (const auto& [area, face] : faces)
        if (largest.size() < most_faces) largest.push_back(face);
    return largest;
}

/// The mesh with nothing that shines but this face, which emits 1 lm/m2.
std::shared_ptr<const Mesh> shining(Mesh mesh, const SurfaceRef& from) {
    const auto exitance = [&](std::uint32_t face) {
        return LuminousExitance{mesh.faces[face].face.ref == from ? 1.0 : 0.0};
    };
    for (Patch& patch : mesh.patches) patch.own_exitance = exitance(patch.face);
    for (Vertex& vertex : mesh.vertices) vertex.own_exitance = exitance(vertex.face);
    return std::make_shared<const Mesh>(std::move(mesh));
}

}  // namespace

ExchangeTrust::ExchangeTrust(const Solution& solution, const Work& work)
    : solution_(solution), work_(work), dark_(*solution.scene) {
    for (Luminaire& luminaire : dark_.luminaires) luminaire.dimming = 0.0;
}

LevelInput ExchangeTrust::input() const {
    const auto if_simulated = [&](Effect effect) {
        return solution_.plan.simulates(effect) ? solution_.occluders : nullptr;
    };
    LevelInput input;
    input.scene = solution_.scene.get();
    input.settings = &solution_.settings;
    input.plan = &solution_.plan;
    input.occluders = if_simulated(Effect::occlusion_direct);
    input.patch_occluders = if_simulated(Effect::occlusion_patches);
    input.direct_accuracy = direct_accuracy(solution_.settings);
    return input;
}

std::vector<double> ExchangeTrust::areas() const {
    const Level::Cut& cut = level_.now();
    if (!is_of_the_paper(solution_.settings.method)) return cut.nodes->areas;
    std::vector<double> areas;
    for (const Vertex& vertex : cut.mesh->vertices) areas.push_back(vertex.area);
    return areas;
}

std::vector<Receiver> ExchangeTrust::unknowns() const {
    const Level::Cut& cut = level_.now();
    if (!is_of_the_paper(solution_.settings.method)) return cut.nodes->receivers;
    std::vector<Receiver> receivers;
    for (const Vertex& vertex : cut.mesh->vertices) receivers.push_back(vertex.receiver);
    return receivers;
}

double ExchangeTrust::mean_reflectance() const {
    const PerPatch<double> reflectance = reflectances(*solution_.mesh, *solution_.scene);
    double area = 0.0, reflecting = 0.0;
    for (std::size_t p = 0; p < solution_.mesh->patches.size(); ++p) {
        area += solution_.mesh->patches[p].area;
        reflecting += solution_.mesh->patches[p].area * reflectance.all()[p];
    }
    return area > 0.0 ? reflecting / area : 0.0;
}

bool ExchangeTrust::solve() {
    StageClock clock(work_.progress);
    coarse_.cut(*solution_.scene, twice * solution_.patch_width, solution_.settings.method, solution_.plan.black);
    const auto coarse = coarse_.solve(input(), work_, clock);
    if (!coarse) return false;
    level_.cut(solution_.mesh, solution_.settings.method);
    answer_ = level_.solve(input(), work_, clock);
    if (!answer_) return false;
    look_at_bars(*coarse);
    return true;
}

double ExchangeTrust::mean_received(const Level& level, const LevelAnswer& answer) const {
    const std::vector<double> values = level.patch_values(mixed(answer.parts, &SideLight::interreflected));
    const Mesh& mesh = *level.now().mesh;
    double area = 0.0, flux = 0.0;
    for (std::size_t p = 0; p < values.size(); ++p) {
        area += mesh.patches[p].area;
        flux += mesh.patches[p].area * values[p];
    }
    return area > 0.0 ? flux / area : 0.0;
}

/// The mean interreflected light of all surfaces has an error bar like any value.
void ExchangeTrust::look_at_bars(const LevelAnswer& coarse) {
    const Mesh& mesh = *solution_.mesh;
    double half_widths = 0.0;
    for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
        area_ += mesh.patches[p].area;
        const auto nodes = static_cast<std::size_t>(solution_.nodes_a_patch);
        for (std::size_t n = 0; n < nodes; ++n)
            half_widths +=
                mesh.patches[p].area * solution_.exitance_half_width[p * nodes + n] / static_cast<double>(nodes);
    }
    ValueParts parts;
    parts.interreflected = mean_ = mean_received(level_, *answer_);
    parts.coarse = mean_received(coarse_, coarse);
    parts.iteration = solution_.converged && area_ > 0.0 ? half_widths / area_ : 0.0;
    parts.typical_mesh_error = solution_.typical_mesh_error;
    parts.reflected_error = solution_.reflected_error;
    parts.skipped = solution_.plan.skipped_anywhere_lux;
    error_ = value_from(parts).error.total();
}

std::optional<EnergyTrust> ExchangeTrust::energy(const DirectTrust& direct) {
    EnergyTrust trust;
    trust.energy = solution_.energy;
    trust.direct_missing = direct.open ? 0.0 : direct.missing();
    trust.direct_error = direct.error;
    trust.converged = solution_.converged;
    trust.bounces = solution_.bounces;
    trust.scaled = !is_of_the_paper(solution_.settings.method);
    const StoredRows* const rows = level_.rows();
    if (answer_->parts.empty() || rows == nullptr) {
        trust.asked = false;
        return trust;
    }
    const auto sums = rows->row_sums(work_);
    if (!sums) return std::nullopt;
    const std::vector<double> area = areas();
    std::vector<double> arriving(area.size());
    const std::vector<double> node_area = level_.now().nodes->areas;
    std::vector<double> passed_on;  // of what leaves: the rest has escaped
    for (const double sum : *sums) passed_on.push_back(std::min(1.0, sum));
    const std::vector<double> by_nodes = level_.node_values(passed_on);
    for (const MixPart& part : answer_->parts) {
        const SideLight& light = *part.light;
        const double share = part.level * part.band_weight;
        for (std::size_t k = 0; k < area.size(); ++k) {
            trust.iteration_bound += share * area[k] * passed_on[k] * light.exitance_half_width[k];
            trust.received += share * area[k] * light.interreflected[k];
        }
        if (!light.converged && light.bounces <= summed_one_by_one) {
            const auto count = static_cast<std::size_t>(light.bounces) + 1;
            const auto reflections = level_.reflections(part, input(), count, work_);
            if (!reflections) return std::nullopt;
            for (std::size_t k = 0; k < node_area.size(); ++k)
                trust.under_way += share * node_area[k] * by_nodes[k] * reflections->back()[k];
        } else {
            if (!rows->multiply(light.exitance, arriving, 1, work_)) return std::nullopt;
            for (std::size_t k = 0; k < area.size(); ++k)
                trust.under_way += share * area[k] * (light.gain * arriving[k] - light.interreflected[k]);
        }
    }
    trust.error = trust.scaled ? solution_.reflected_error * trust.received : area_ * error_;
    return trust;
}

std::optional<ExchangeTrust::Passed> ExchangeTrust::passed(Level& level, const Mesh& mesh, const SurfaceRef& from,
                                                           std::span<const SurfaceRef> to) const {
    level.cut(shining(mesh, from), solution_.settings.method);
    LevelInput wanted = input();
    wanted.scene = &dark_;
    StageClock clock(work_.progress);
    const auto answer = level.solve(wanted, work_, clock);
    if (!answer) return std::nullopt;
    Solution light;
    light.scene = solution_.scene;
    light.mesh = level.now().mesh;
    take_answer(light, level, *answer);
    Passed passed{std::vector<double>(to.size(), 0.0), light.reflected_error,
                  light.converged ? light.iteration_bound : 0.0};
    for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
        const auto face = std::find(to.begin(), to.end(), mesh.faces[mesh.patches[p].face].face.ref);
        if (face != to.end())
            passed.to[static_cast<std::size_t>(face - to.begin())] +=
                mesh.patches[p].area * light.patch_interreflected[p];
    }
    return passed;
}

std::optional<ReciprocityTrust> ExchangeTrust::reciprocity() {
    ReciprocityTrust trust;
    trust.asked = level_.rows() != nullptr;
    if (!trust.asked) return trust;
    trust.gain = solution_.closure;
    trust.misplaced = solution_.reflected_error;
    if (!pair_by_pair(trust)) return std::nullopt;

    const std::vector<SurfaceRef> faces = largest_faces(*solution_.mesh);
    const std::shared_ptr<const Mesh> wide = coarse_.now().mesh;
    std::vector<Passed> fine, rough;
    for (const SurfaceRef& face : faces) {
        auto by_fine = passed(level_, *solution_.mesh, face, faces);
        auto by_rough = by_fine ? passed(coarse_, *wide, face, faces) : std::nullopt;
        if (!by_rough) return std::nullopt;
        fine.push_back(std::move(*by_fine));
        rough.push_back(std::move(*by_rough));
    }
    double squares = 0.0, typical = 0.0;
    for (std::size_t a = 0; a < faces.size(); ++a)
        for (std::size_t b = 0; b < faces.size(); ++b) {
            const double apart = fine[a].to[b] - rough[a].to[b];
            squares += a == b ? 0.0 : apart * apart;
        }
    if (faces.size() > 1) typical = std::sqrt(squares / static_cast<double>(faces.size() * (faces.size() - 1)));
    const auto error = [&](std::size_t a, std::size_t b) {
        ValueParts parts;
        parts.interreflected = fine[a].to[b];
        parts.coarse = rough[a].to[b];
        parts.typical_mesh_error = typical;
        parts.reflected_error = fine[a].misplaced;
        return value_from(parts).error.total() + of_a_factor * fine[a].to[b];
    };
    for (std::size_t a = 0; a < faces.size(); ++a)
        for (std::size_t b = a + 1; b < faces.size(); ++b) {
            if (fine[a].to[b] == 0.0 && fine[b].to[a] == 0.0) continue;
            trust.pairs.push_back({faces[a], faces[b], fine[a].to[b], fine[b].to[a], error(a, b) + error(b, a)});
        }
    level_.cut(solution_.mesh, solution_.settings.method);
    return trust;
}

/// Coefficients between single patches, worked out from either end.
bool ExchangeTrust::pair_by_pair(ReciprocityTrust& trust) const {
    const std::vector<double> area = areas();
    const std::size_t per_patch = is_of_the_paper(solution_.settings.method) ? 1 : level_.now().nodes->per_patch;
    const std::vector<std::size_t> some = some_of(area.size() / per_patch, most_patches);
    std::vector<std::vector<double>> sent(some.size());
    std::vector<double> leaving(area.size()), arriving(area.size());
    for (std::size_t k = 0; k < some.size(); ++k) {
        std::fill(leaving.begin(), leaving.end(), 0.0);
        std::fill_n(leaving.begin() + static_cast<std::ptrdiff_t>(some[k] * per_patch), per_patch, 1.0);
        if (!level_.rows()->multiply(leaving, arriving, 1, work_)) return false;
        for (const std::size_t to : some) {
            double flux = 0.0;
            for (std::size_t n = to * per_patch; n < (to + 1) * per_patch; ++n) flux += area[n] * arriving[n];
            sent[k].push_back(flux);
        }
    }
    double apart = 0.0, all = 0.0;
    for (std::size_t i = 0; i < some.size(); ++i)
        for (std::size_t j = i + 1; j < some.size(); ++j) {
            apart += std::abs(sent[i][j] - sent[j][i]);
            all += 0.5 * (sent[i][j] + sent[j][i]);
            ++trust.rows_compared;
        }
    trust.rows_apart = all > 0.0 ? apart / all : 0.0;
    return true;
}

std::optional<ClosureTrust> ExchangeTrust::closure() {
    ClosureTrust trust;
    trust.asked = level_.rows() != nullptr;
    if (!trust.asked) return trust;
    trust.error_share = mean_ > 0.0 ? error_ / mean_ : 0.0;
    if (!compare_with_seen(trust) || !compare_with_rays(trust)) return std::nullopt;
    return trust;
}

bool ExchangeTrust::compare_with_seen(ClosureTrust& trust) {
    const auto used = level_.rows()->row_sums(work_);
    if (!used) return false;
    const std::vector<double> area = areas();
    const std::vector<Receiver> all = unknowns();
    const std::vector<std::size_t> some = some_of(all.size(), most_looks);
    std::vector<Receiver> receivers;
    for (const std::size_t k : some) receivers.push_back(all[k]);
    Level eye;
    eye.cut(solution_.mesh, Method::patch);
    const auto rows = eye.rows_to(receivers, input(), work_);
    const auto seen = rows ? rows->row_sums(work_) : std::nullopt;
    if (!seen) return false;
    double apart = 0.0, whole = 0.0;
    for (std::size_t k = 0; k < some.size(); ++k) {
        // a grid point in the very corner of bodies that touch may see more than all: that is misplaced, too
        apart += area[some[k]] * std::abs((*used)[some[k]] - std::min(1.0, (*seen)[k]));
        whole += area[some[k]];
    }
    const auto [least, greatest] = std::minmax_element(used->begin(), used->end());
    trust.least = *least;
    trust.greatest = *greatest;
    trust.greatest_place = all[static_cast<std::size_t>(greatest - used->begin())].position;
    const double lost = 1.0 - mean_reflectance();
    trust.misplaced = mean_ > 0.0 && whole > 0.0 && lost > 0.0 ? apart / whole / lost : 0.0;  // of no light nothing is
    return true;
}

bool ExchangeTrust::compare_with_rays(ClosureTrust& trust) {
    const Mesh& mesh = *solution_.mesh;
    std::set<std::uint32_t> opaque;
    for (const Luminaire& luminaire : solution_.scene->luminaires) opaque.insert(luminaire.id.value);
    const LevelInput wanted = input();
    const RaysFrom rays(mesh, wanted.patch_occluders.get(), opaque);
    std::vector<Receiver> receivers;
    for (const std::size_t p : some_of(mesh.patches.size(), ray_places))
        receivers.push_back(mesh.centre_of(mesh.patches[p]));
    Level eye;
    eye.cut(solution_.mesh, Method::patch);
    const auto rows = eye.rows_to(receivers, wanted, work_);
    const auto seen = rows ? rows->row_sums(work_) : std::nullopt;
    if (!seen) return false;
    trust.places = receivers.size();
    trust.rays = rays_a_place;
    trust.seen_by_rows = trust.seen_by_rays = trust.greatest_seen = 0.0;
    for (std::size_t k = 0; k < receivers.size(); ++k) {
        if (work_.stop.stop_requested()) return false;
        const double count = static_cast<double>(rays_a_place);
        const double met = static_cast<double>(rays.meeting_a_surface(receivers[k], rays_a_place));
        trust.greatest_seen = std::max(trust.greatest_seen, (*seen)[k]);
        trust.seen_by_rows += (*seen)[k] / static_cast<double>(receivers.size());
        trust.seen_by_rays += met / count / static_cast<double>(receivers.size());
        // one ray more of either kind, so that none is certain of what it has not met
        const double likely = (met + 1.0) / (count + 2.0);
        const double standard_error = std::sqrt(likely * (1.0 - likely) / count);
        trust.worst_deviation = std::max(trust.worst_deviation, std::abs((*seen)[k] - met / count) / standard_error);
    }
    return true;
}

}  // namespace hanei
