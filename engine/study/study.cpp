#include "engine/study/study.h"

#include "engine/base/tiles.h"
#include "engine/direct/light_on_luminaires.h"
#include "engine/geometry/polygon.h"
#include "engine/mesh/patch_count.h"
#include "engine/scene/faces.h"
#include "engine/study/contribution_stage.h"
#include "engine/study/display_stage.h"
#include "engine/study/finer_mesh.h"
#include "engine/study/first_picture.h"
#include "engine/study/level.h"
#include "engine/study/outcome.h"
#include "engine/study/shadow_stage.h"
#include "engine/study/stage_keys.h"
#include "engine/study/value_stage.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>

namespace hanei {

namespace {

constexpr int points_slot = 0;
constexpr int vertices_slot = 1;
constexpr double soon_ms = 50.0;           // an answer that comes sooner needs no picture ahead of it
constexpr std::size_t many_patches = 800;  // fewer are solved soon enough
constexpr double coarse_ratio = 2.0;       // the coarser solution's patches are this much wider

using Receivers = std::shared_ptr<const std::vector<Receiver>>;

bool same_bodies(const OccluderSet& a, const OccluderSet& b) {
    return std::equal(a.bodies().begin(), a.bodies().end(), b.bodies().begin(), b.bodies().end());
}

/// Keeps the object while its content is the same, so that the stages after it are.
template <class T, class Same>
void refresh(std::shared_ptr<const T>& kept, T made, Same&& same) {
    if (!kept || !same(*kept, made)) kept = std::make_shared<const T>(std::move(made));
}

std::vector<Receiver> vertex_receivers(const Mesh& mesh) {
    std::vector<Receiver> receivers;
    receivers.reserve(mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices) receivers.push_back(vertex.receiver);
    return receivers;
}

/// Values, then as many errors: each value beside its error.
std::vector<double> side_by_side(const std::vector<double>& estimates) {
    const std::size_t count = estimates.size() / 2;
    std::vector<double> pairs;
    pairs.reserve(estimates.size());
    for (std::size_t k = 0; k < count; ++k) pairs.insert(pairs.end(), {estimates[k], estimates[count + k]});
    return pairs;
}

double root_mean_square_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double squares = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) squares += (a[k] - b[k]) * (a[k] - b[k]);
    return a.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(a.size()));
}

/// Patches of one value leave steps between them: light at their corners is gathered anew while that is
/// not too dear; smaller steps are not seen. The other methods know it there.
bool gathers_at_vertices(const Settings& settings, const Mesh& mesh) {
    constexpr std::size_t most_patches = 15'000;
    return settings.method == Method::patch && mesh.patches.size() <= most_patches;
}

/// As many as can be solved within hours and a disk; what is asked beyond was hardly meant.
constexpr double most_unknowns = 50'000.0;

/// The wished patch width, or the least that can be computed.
double computable_width(const Scene& scene, const Settings& settings) {
    const double of_a_patch = settings.method == Method::linear ? 4.0 : 1.0;
    return width_for(faces_of(scene), settings.max_patch, most_unknowns / of_a_patch);
}

/// Rounds of refinement, by how many patches more.
constexpr std::array growth_of_rounds{2.0 / 3.0, 2.0 / 3.0, 0.3, 0.3, 0.3, 0.3};
constexpr std::size_t least_rounds = 2;
constexpr double settled_change = 0.03;  // of a value from one round to the next

/// Of any value, as a share of itself or of a tenth of their mean.
double greatest_change(const std::vector<double>& before, const std::vector<double>& now,
                       const std::vector<double>& illuminance) {
    double mean = 0.0;
    for (const double lux : illuminance) mean += lux / static_cast<double>(illuminance.size());
    double greatest = 0.0;
    for (std::size_t k = 0; k < now.size(); ++k) {
        const double scale = std::max(illuminance[k], 0.1 * mean);
        if (scale > 0.0) greatest = std::max(greatest, std::abs(now[k] - before[k]) / scale);
    }
    return greatest;
}

/// The method for final figures looks where its patches are too coarse.
bool is_refined(const Solution& solution, const StudyRequest& request) {
    return solution.settings.method == Method::linear && request.refine && !request.live &&
           solution.plan.simulates(Effect::interreflection);
}

/// lx at full output, below which direct light need be no more exact: a tenth of the room's mean.
double dim_illuminance(const Scene& scene) {
    double area = 0.0, flux = 0.0;
    for (const Face& face : faces_of(scene)) area += glm::length(vector_area(face.region));
    for (const Luminaire& luminaire : scene.luminaires) flux += Emitter(scene, luminaire).flux().value;
    // a power of two, so that a luminaire more or less does not ask for other light of all the others
    return area > 0.0 && flux > 0.0 ? std::exp2(std::floor(std::log2(0.1 * flux / area))) : 0.0;
}

/// Of values: not beyond what sampling a measured opening can tell.
double share_at_points(const Settings& settings) { return std::max(settings.accuracy, 1e-4); }

constexpr double not_cancelled = 0.1;  // of the errors of many patches, in a value that gathers from all

/// Of means over patches: their errors are those of many patches and all but cancel in a value.
constexpr double least_share_of_means = 1e-3, most_share_of_means = 1e-2;
double share_of_means(const Settings& settings) {
    return std::clamp(3.0 * settings.accuracy, least_share_of_means, most_share_of_means);
}

std::vector<double> nothing(std::size_t count) { return std::vector<double>(count, 0.0); }

}  // namespace

struct Study::Stages {
    Level fine, coarse, open_fine;              // open: the same patch width, nothing casts shadows
    std::vector<std::unique_ptr<Level>> finer;  // rounds of cutting where the light asks for it
    Level *newest = &fine, *rougher = &coarse;  // the answer's, and the one that its mesh error is told from
    DirectStage point_direct;
    DirectStage luminaire_flux;
    std::shared_ptr<const OccluderSet> occluders;
    Receivers points, vertices;
    DisplayStage display_stage;
    CarriedLight carried;
    double typical_mesh_error = 0.0;  ///< lx, of the last answer that knew it
    struct Taken {
        std::shared_ptr<const Mesh> mesh;
        std::shared_ptr<const OccluderSet> occluders;
        double ms = 0.0;
    };
    Taken taken[2];  ///< by the last full answer; [1]: while the scene was dragged
    ShadowStage shadow_stage;
    SolutionSnapshot given;             ///< the last complete one
    std::optional<LevelAnswer> solved;  ///< what it was made from

    struct Run {
        SceneSnapshot scene;
        Settings settings;
        StudyRequest request;
        Work work;
        StageClock clock;
        std::shared_ptr<Solution> solution;
        Accuracy at_points, of_means, while_dragged;  ///< of direct light; `of_means` for the answer that stays
        std::chrono::steady_clock::time_point begun = std::chrono::steady_clock::now();
        LevelInput fine_input() const;
    };

    void prepare(Run& run);
    bool shadows(Run& run);
    bool values(Run& run, const LevelAnswer& answer, const LevelAnswer* rough);
    bool light_display(Run& run, bool open);
    bool display(Run& run, const LightOfSurfaces& light, bool open);
    bool picture_ahead(Run& run, const std::function<void(SolutionSnapshot)>& publish);
    void keep_for_next(const Run& run, LightOfSurfaces light);
    std::optional<LightOfSurfaces> vertex_light(Run& run, const LevelAnswer& answer);
    bool energy(Run& run, const LevelAnswer& answer);
    std::optional<LevelAnswer> solve_coarse(Run& run);
    std::optional<LevelAnswer> refine(Run& run, const LevelAnswer& base);
    std::optional<std::vector<double>> open_interreflected(Run& run);
    std::optional<std::vector<double>> direct_at_points(Run& run);
};

LevelInput Study::Stages::Run::fine_input() const {
    const auto if_simulated = [&](Effect effect) {
        return solution->plan.simulates(effect) ? solution->occluders : nullptr;
    };
    LevelInput input;
    input.scene = scene.get();
    input.settings = &settings;
    input.plan = &solution->plan;
    input.occluders = if_simulated(Effect::occlusion_direct);
    input.patch_occluders = if_simulated(Effect::occlusion_patches);
    input.direct_accuracy = request.live ? while_dragged : of_means;
    input.warm = request.live;
    return input;
}

void Study::Stages::prepare(Run& run) {
    run.clock.enter(Stage::planning);
    run.solution = std::make_shared<Solution>();
    run.solution->scene = run.scene;
    run.solution->settings = run.settings;
    run.settings.max_patch = run.solution->patch_width = computable_width(*run.scene, run.settings);
    note_width(*run.solution);
    run.solution->plan =
        plan_effects(*run.scene, run.settings, run.request.live ? PlanDetail::decisions : PlanDetail::bounds);
    const double dim = dim_illuminance(*run.scene);
    const auto accuracy = [&](double share) { return accuracy_of_each(share, dim, run.scene->luminaires.size()); };
    run.at_points = accuracy(share_at_points(run.settings));
    run.of_means = accuracy(share_of_means(run.settings));
    run.while_dragged = accuracy(most_share_of_means);

    run.clock.enter(Stage::meshing);
    refresh(occluders, occluders_of(*run.scene), same_bodies);
    run.solution->occluders = occluders;
    newest = &fine;
    rougher = is_refined(*run.solution, run.request) ? &fine : &coarse;
    run.solution->mesh =
        fine.cut(*run.scene, run.settings.max_patch, run.settings.method, run.solution->plan.black).mesh;
    CalculationPlaces places = places_of(*run.scene);
    refresh(points, receivers_at(places, *run.solution->mesh), std::equal_to{});
    refresh(vertices, vertex_receivers(*run.solution->mesh), std::equal_to{});
    run.solution->points = std::move(places.points);
    run.solution->grids = std::move(places.grids);
}

bool Study::Stages::shadows(Run& run) {
    run.clock.enter(Stage::refining);
    Solution& solution = *run.solution;
    solution.shadows = shadow_stage.get(*run.scene, solution.mesh, run.fine_input().occluders, run.work);
    return solution.shadows != nullptr;
}

/// Values and their errors, side by side.
std::optional<std::vector<double>> Study::Stages::direct_at_points(Run& run) {
    const LevelInput input = run.fine_input();
    LightReceivers receivers;
    receivers.identity = points;
    receivers.count = points->size();
    receivers.figures = 2;
    receivers.accuracy = run.at_points;
    receivers.places = [&](std::size_t k) { return std::span(&(*points)[k].position, 1); };
    receivers.compute = [&](const Emitter& emitter, std::span<const std::uint32_t> which) {
        std::vector<Receiver> some;
        some.reserve(which.size());
        for (const std::uint32_t k : which) some.push_back((*points)[k]);
        auto estimates = direct_estimates(emitter, some, input.occluders.get(), run.at_points, run.work);
        if (estimates) *estimates = side_by_side(*estimates);
        return estimates;
    };
    auto direct = point_direct.sum(*run.scene, receivers, input.occluders);
    run.clock.mark_reused(point_direct.reused());
    return direct;
}

bool Study::Stages::energy(Run& run, const LevelAnswer& answer) {
    run.clock.enter(Stage::gathering);
    const auto account = newest->flux(answer, *run.scene, run.solution->plan, run.work);
    if (!account) return false;
    // The luminaires' bodies as one receiver of two figures: what a luminaire gives, and what of it they take.
    const std::shared_ptr<const OccluderSet> in_the_way = run.fine_input().occluders;
    LightReceivers bodies;
    bodies.identity = in_the_way;
    bodies.count = 1;
    bodies.figures = 2;
    bodies.accuracy = run.of_means;
    bodies.places = [](std::size_t) { return std::span<const Vec3>(); };
    bodies.compute = [&](const Emitter& emitter, std::span<const std::uint32_t>) -> std::optional<std::vector<double>> {
        if (!in_the_way) return std::vector{emitter.flux().value, 0.0};
        const auto met = flux_on_luminaires(emitter, *run.scene, *in_the_way, run.of_means, run.work);
        if (!met) return std::nullopt;
        return std::vector{emitter.flux().value, met->value};
    };
    const auto sums = luminaire_flux.sum(*run.scene, bodies, in_the_way);
    if (!sums) return false;
    run.solution->energy = energy_of(*run.scene, *account, (*sums)[0], (*sums)[1]);
    return true;
}

/// The mesh as wished was the first look: patches that misplace light are cut, twice, and then some more
/// as long as a value still moves.
std::optional<LevelAnswer> Study::Stages::refine(Run& run, const LevelAnswer& base) {
    std::vector<double> illuminance, before;
    CalculationPlaces places{run.solution->points, run.solution->grids};
    places.for_each([&](const PointResult& point) {
        illuminance.push_back(point.value.total().value);
        before.push_back(point.value.interreflected.value);
    });
    const LevelInput input = run.fine_input();
    std::optional<LevelAnswer> answer = base;
    for (std::size_t round = 0; round < growth_of_rounds.size(); ++round) {
        const auto mesh =
            finer_mesh(*newest, *answer, {*points, illuminance}, growth_of_rounds[round], input, run.work, run.clock);
        if (!mesh) return std::nullopt;
        if (finer.size() == round) finer.push_back(std::make_unique<Level>());
        newest = finer[round].get();
        newest->cut(mesh, run.settings.method);
        answer = newest->solve(input, run.work, run.clock);
        if (!answer) return std::nullopt;
        run.clock.enter(Stage::gathering);
        auto now = newest->gather(points_slot, answer->parts, points, input, run.work, run.clock);
        if (!now) return std::nullopt;
        const bool settled = greatest_change(before, now->interreflected, illuminance) < settled_change;
        before = std::move(now->interreflected);
        if (round + 1 >= least_rounds && settled) break;
    }
    run.solution->mesh = newest->now().mesh;
    refresh(vertices, vertex_receivers(*run.solution->mesh), std::equal_to{});
    run.solution->coarse_mesh = fine.now().mesh;
    run.solution->coarse_exitance = fine.node_values(mixed(base.parts, &SideLight::exitance));
    return answer;
}

bool Study::Stages::values(Run& run, const LevelAnswer& answer, const LevelAnswer* rough) {
    run.clock.enter(Stage::gathering);
    Solution& solution = *run.solution;
    const auto direct = direct_at_points(run);
    if (!direct) return false;
    GatheredLight gathered{nothing(points->size()), nothing(points->size()), {}};
    std::vector<double> coarse_values(points->size(), -1.0), misplaced = nothing(points->size());
    if (!answer.parts.empty()) {
        auto fine_light = newest->gather(points_slot, answer.parts, points, run.fine_input(), run.work, run.clock);
        if (!fine_light) return false;
        gathered = std::move(*fine_light);
        if (rough) {
            auto coarse_light =
                rougher->gather(points_slot, rough->parts, points, run.fine_input(), run.work, run.clock);
            if (!coarse_light) return false;
            coarse_values = std::move(coarse_light->interreflected);
            if (rougher == &fine) {  // refined: what was not cut does not differ from the coarser solution
                auto left = misplaced_light(*newest, answer, *points, run.fine_input(), run.work, run.clock);
                if (!left) return false;
                misplaced = std::move(*left);
            }
            solution.typical_mesh_error = root_mean_square_difference(coarse_values, gathered.interreflected);
            typical_mesh_error = solution.typical_mesh_error;
        }
    }
    CalculationPlaces places{std::move(solution.points), std::move(solution.grids)};
    std::size_t k = 0;
    places.for_each([&](PointResult& point) {
        point.value = value_from({(*direct)[2 * k], gathered.interreflected[k], gathered.iteration[k], coarse_values[k],
                                  misplaced[k], solution.typical_mesh_error, solution.reflected_error,
                                  solution.plan.skipped_at(point.position, point.normal), (*direct)[2 * k + 1]});
        if (run.request.live && !rough) point.value.error.mesh = typical_mesh_error;
        if (is_covered(*solution.occluders, point.position, point.normal)) {
            point.value = PointValue{};
            point.value.inside_solid = true;
        }
        ++k;
    });
    solution.points = std::move(places.points);
    solution.grids = std::move(places.grids);
    return true;
}

std::optional<LevelAnswer> Study::Stages::solve_coarse(Run& run) {
    LevelInput input = run.fine_input();
    coarse.cut(*run.scene, coarse_ratio * run.settings.max_patch, run.settings.method, run.solution->plan.black);
    auto answer = coarse.solve(input, run.work, run.clock);
    if (!answer) return std::nullopt;
    run.solution->coarse_mesh = coarse.now().mesh;
    run.solution->coarse_exitance = coarse.node_values(mixed(answer->parts, &SideLight::exitance));
    return answer;
}

std::optional<std::vector<double>> Study::Stages::open_interreflected(Run& run) {
    LevelInput input = run.fine_input();
    input.occluders = input.patch_occluders = nullptr;
    open_fine.cut(run.solution->mesh, run.settings.method);
    const auto answer = open_fine.solve(input, run.work, run.clock);
    if (!answer) return std::nullopt;
    if (answer->parts.empty()) return nothing(vertices->size());
    if (!gathers_at_vertices(run.settings, *run.solution->mesh))
        return open_fine.vertex_values(mixed(answer->parts, &SideLight::interreflected));
    auto light = open_fine.gather(vertices_slot, answer->parts, vertices, input, run.work, run.clock);
    if (!light) return std::nullopt;
    return std::move(light->interreflected);
}

std::optional<LightOfSurfaces> Study::Stages::vertex_light(Run& run, const LevelAnswer& answer) {
    if (answer.parts.empty() || !gathers_at_vertices(run.settings, *run.solution->mesh))
        return light_at_vertices(*newest, answer);
    run.clock.enter(Stage::gathering);
    auto light = newest->gather(vertices_slot, answer.parts, vertices, run.fine_input(), run.work, run.clock);
    if (!light) return std::nullopt;
    return LightOfSurfaces{std::move(light->interreflected), std::move(light->bands), {}};
}

bool Study::Stages::light_display(Run& run, bool open) {
    run.clock.enter(Stage::refining);
    const LevelInput level = run.fine_input();
    DisplayInput input;
    input.scene = run.scene.get();
    input.mesh = run.solution->mesh;
    input.occluders = level.occluders;
    input.accuracy = run.of_means;
    input.open = open;
    input.live = run.request.live;
    if (!display_stage.update(input, run.work)) return false;
    run.clock.mark_reused(display_stage.reused());
    return true;
}

bool Study::Stages::display(Run& run, const LightOfSurfaces& light, bool open) {
    if (!light_display(run, open)) return false;
    run.solution->display = display_stage.dressed(light);
    return true;
}

/// What can be shown before interreflection is solved. Nothing when the answer itself comes at once.
/// Returns   false when a first guess of the answer should be shown instead.
bool Study::Stages::picture_ahead(Run& run, const std::function<void(SolutionSnapshot)>& publish) {
    if (!publish || !run.request.display) return false;
    const Taken& last = taken[run.request.live];
    const bool as_before = last.mesh == run.solution->mesh && last.occluders == run.solution->occluders;
    if (as_before && last.ms < soon_ms) return true;

    if (carried.empty()) {
        if (run.solution->mesh->patches.size() < many_patches) return false;
        auto first = FirstPicture().make(run.fine_input(), run.work, run.clock);
        if (!first) return false;
        Solution solution = *run.solution;
        solution.mesh = first->mesh;
        solution.display = first->display;
        publish(std::make_shared<const Solution>(std::move(solution)));
        carried.keep(first->mesh, std::move(first->light), first->flux);
    }
    if (!light_display(run, false)) return false;
    run.solution->display = display_stage.dressed(carried.at(run.solution->mesh, display_stage.flux()));
    publish(std::make_shared<const Solution>(*run.solution));
    return true;
}

void Study::Stages::keep_for_next(const Run& run, LightOfSurfaces light) {
    const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - run.begun;
    taken[run.request.live] = {run.solution->mesh, run.solution->occluders, passed.count()};
    carried.keep(run.solution->mesh, std::move(light), display_stage.flux());
}

Study::Study() : stages_(std::make_unique<Stages>()) {}
Study::~Study() = default;

SolutionSnapshot Study::run(SceneSnapshot scene, const Settings& settings, const StudyRequest& request,
                            const Work& work, const std::function<void(SolutionSnapshot)>& publish) {
    Stages::Run run{std::move(scene), settings, request, work, StageClock(work.progress), nullptr, {}, {}, {}};
    run.work.threads = settings.threads > 0 ? settings.threads : hardware_threads();
    stages_->prepare(run);
    if (request.shadows && !stages_->shadows(run)) return nullptr;

    const bool is_shown = stages_->picture_ahead(run, publish);
    const auto on_way = [&](const LevelAnswer& estimate) {
        if (!publish || is_shown) return;
        take_answer(*run.solution, stages_->fine, estimate);
        if (request.display && !stages_->display(run, light_at_vertices(stages_->fine, estimate), false)) return;
        publish(std::make_shared<const Solution>(*run.solution));
    };
    auto answer = stages_->fine.solve(run.fine_input(), run.work, run.clock, on_way);
    if (!answer) return nullptr;
    std::optional<LevelAnswer> rough;
    const bool is_lit = !answer->parts.empty();  // not where what shines has no patch: a sheet behind another
    if (is_lit && is_refined(*run.solution, request)) {
        if (!stages_->values(run, *answer, nullptr)) return nullptr;
        rough = std::move(answer);
        answer = stages_->refine(run, *rough);
        if (!answer) return nullptr;
    } else if (request.mesh_error && run.solution->plan.simulates(Effect::interreflection)) {
        rough = stages_->solve_coarse(run);
        if (!rough) return nullptr;
    }
    take_answer(*run.solution, *stages_->newest, *answer);
    run.solution->reflected_error += not_cancelled * run.of_means.share;
    if (!stages_->values(run, *answer, rough ? &*rough : nullptr)) return nullptr;
    if (request.display) {
        auto light = stages_->vertex_light(run, *answer);
        if (!light) return nullptr;
        if (request.unshadowed) {
            auto without_shadows = stages_->open_interreflected(run);
            if (!without_shadows) return nullptr;
            light->open = std::move(*without_shadows);
        }
        if (!stages_->display(run, *light, request.unshadowed)) return nullptr;
        stages_->keep_for_next(run, std::move(*light));
    }

    if (request.energy && !stages_->energy(run, *answer)) return nullptr;
    note_divergence(*run.solution);
    run.solution->complete = true;
    run.clock.enter(Stage::done);
    take_times(*run.solution, run.clock.finish());
    stages_->given = run.solution;
    stages_->solved = std::move(answer);
    return run.solution;
}

std::optional<Contributions> Study::contributions(SolutionSnapshot solution, const Vec3& position, const Vec3& normal,
                                                  const Work& work) {
    if (stages_->given != solution) {
        solution = run(solution->scene, solution->settings, {}, Work{work.threads, work.stop, nullptr});
        if (!solution) return std::nullopt;
    }
    const auto if_simulated = [&](Effect effect) {
        return solution->plan.simulates(effect) ? solution->occluders : nullptr;
    };
    LevelInput input;
    input.scene = solution->scene.get();
    input.settings = &solution->settings;
    input.plan = &solution->plan;
    input.occluders = if_simulated(Effect::occlusion_direct);
    input.patch_occluders = if_simulated(Effect::occlusion_patches);
    return contributions_at(solution, *stages_->newest, *stages_->solved, input, {position, glm::normalize(normal)},
                            work);
}

}  // namespace hanei
