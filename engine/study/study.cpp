#include "engine/study/study.h"

#include "engine/base/tiles.h"
#include "engine/study/display_stage.h"
#include "engine/study/level.h"
#include "engine/study/outcome.h"
#include "engine/study/shadow_stage.h"
#include "engine/study/stage_keys.h"
#include "engine/study/value_stage.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace hanei {

namespace {

constexpr int points_slot = 0;
constexpr int vertices_slot = 1;
constexpr double coarse_ratio = 2.0;  // the coarser solution's patches are this much wider

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

std::vector<double> nothing(std::size_t count) { return std::vector<double>(count, 0.0); }

/// What the display's cells and their direct light are made from.
struct DisplayKey {
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const OccluderSet> occluders;
    std::vector<Luminaire> lights;
    std::vector<Photometry> photometries;
    double maintenance_factor = 1.0;
    bool open = false;
    bool operator==(const DisplayKey&) const = default;
};

}  // namespace

struct Study::Stages {
    Level fine, coarse, open_fine;  // open: the same patch width, nothing casts shadows
    DirectStage point_direct;
    std::shared_ptr<const OccluderSet> occluders;
    Receivers points, vertices;
    StageCache<DisplayKey, DirectDisplay> direct_display;
    ShadowStage shadow_stage;

    struct Run {
        SceneSnapshot scene;
        Settings settings;
        StudyRequest request;
        Work work;
        StageClock clock;
        std::shared_ptr<Solution> solution;
        LevelInput fine_input() const;
    };

    void prepare(Run& run);
    bool shadows(Run& run);
    bool values(Run& run, const LevelAnswer& answer, const LevelAnswer* rough);
    bool display(Run& run, const std::vector<double>& interreflected, const std::vector<double>& open);
    std::optional<std::vector<double>> vertex_interreflected(Run& run, const LevelAnswer& answer);
    std::optional<LevelAnswer> solve_coarse(Run& run);
    std::optional<std::vector<double>> open_interreflected(Run& run);
    std::optional<std::vector<double>> direct_at_points(Run& run);
};

LevelInput Study::Stages::Run::fine_input() const {
    const auto if_simulated = [&](Effect effect) {
        return solution->plan.simulates(effect) ? solution->occluders : nullptr;
    };
    return {scene.get(),
            &settings,
            &solution->plan,
            settings.max_patch,
            if_simulated(Effect::occlusion_direct),
            if_simulated(Effect::occlusion_patches)};
}

void Study::Stages::prepare(Run& run) {
    run.clock.enter(Stage::planning);
    run.solution = std::make_shared<Solution>();
    run.solution->scene = run.scene;
    run.solution->settings = run.settings;
    run.solution->plan = plan_effects(*run.scene, run.settings);

    run.clock.enter(Stage::meshing);
    refresh(occluders, occluders_of(*run.scene), same_bodies);
    run.solution->occluders = occluders;
    run.solution->mesh = fine.mesh(*run.scene, run.settings.max_patch);
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

std::optional<std::vector<double>> Study::Stages::direct_at_points(Run& run) {
    const LevelInput input = run.fine_input();
    auto direct = point_direct.sum(
        *run.scene, 2 * points->size(), points, input.occluders,
        [&](const Emitter& emitter) { return direct_estimates(emitter, *points, input.occluders.get(), run.work); });
    run.clock.mark_reused(point_direct.reused());
    return direct;
}

bool Study::Stages::values(Run& run, const LevelAnswer& answer, const LevelAnswer* rough) {
    run.clock.enter(Stage::gathering);
    Solution& solution = *run.solution;
    const auto between = run.fine_input().patch_occluders;
    const auto direct = direct_at_points(run);
    if (!direct) return false;
    std::vector<double> interreflected = nothing(points->size()), iteration = interreflected;
    std::vector<double> coarse_values(points->size(), -1.0);
    if (solution.plan.simulates(Effect::interreflection)) {
        const auto rows = fine.rows_to(points_slot, points, between, run.work, run.clock);
        if (!rows.factors) return false;
        interreflected = gather(*rows.factors, rows.visibility, answer.exitance, run.work);
        iteration = gather(*rows.factors, rows.visibility, answer.exitance_half_width, run.work);
        if (rough) {
            const auto coarse_rows = coarse.rows_to(points_slot, points, between, run.work, run.clock);
            if (!coarse_rows.factors) return false;
            coarse_values = gather(*coarse_rows.factors, coarse_rows.visibility, rough->exitance, run.work);
            double squares = 0.0;
            for (std::size_t k = 0; k < points->size(); ++k)
                squares += std::pow(coarse_values[k] - interreflected[k], 2);
            solution.typical_mesh_error =
                points->empty() ? 0.0 : std::sqrt(squares / static_cast<double>(points->size()));
        }
    }
    CalculationPlaces places{std::move(solution.points), std::move(solution.grids)};
    const std::span<const double> sampling = std::span(*direct).subspan(points->size());  // after the values
    std::size_t k = 0;
    const double skipped = solution.plan.skipped_bound_lux();
    places.for_each([&](PointResult& point) {
        point.value = value_from({(*direct)[k], interreflected[k], iteration[k], coarse_values[k],
                                  solution.typical_mesh_error, skipped, sampling[k]});
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
    input.max_patch = coarse_ratio * run.settings.max_patch;
    run.solution->coarse_mesh = coarse.mesh(*run.scene, input.max_patch);
    auto answer = coarse.solve(input, run.work, run.clock);
    if (answer) run.solution->coarse_exitance = answer->exitance;
    return answer;
}

std::optional<std::vector<double>> Study::Stages::open_interreflected(Run& run) {
    LevelInput input = run.fine_input();
    input.occluders = input.patch_occluders = nullptr;
    open_fine.mesh(*run.scene, input.max_patch);
    const auto answer = open_fine.solve(input, run.work, run.clock);
    if (!answer) return std::nullopt;
    if (!run.solution->plan.simulates(Effect::interreflection)) return nothing(vertices->size());
    const auto rows = open_fine.rows_to(vertices_slot, vertices, nullptr, run.work, run.clock);
    if (!rows.factors) return std::nullopt;
    return gather(*rows.factors, rows.visibility, answer->exitance, run.work);
}

std::optional<std::vector<double>> Study::Stages::vertex_interreflected(Run& run, const LevelAnswer& answer) {
    if (!answer.vertex_interreflected.empty()) return answer.vertex_interreflected;
    if (!run.solution->plan.simulates(Effect::interreflection)) return nothing(vertices->size());
    run.clock.enter(Stage::gathering);
    const auto rows = fine.rows_to(vertices_slot, vertices, run.fine_input().patch_occluders, run.work, run.clock);
    if (!rows.factors) return std::nullopt;
    return gather(*rows.factors, rows.visibility, answer.exitance, run.work);
}

bool Study::Stages::display(Run& run, const std::vector<double>& interreflected, const std::vector<double>& open) {
    run.clock.enter(Stage::refining);
    Solution& solution = *run.solution;
    const auto shadows = run.fine_input().occluders;
    DisplayKey key{solution.mesh, shadows, {}, run.scene->photometries, run.scene->maintenance_factor, !open.empty()};
    for (const Luminaire& luminaire : run.scene->luminaires) {
        key.lights.push_back(light_of(luminaire));
        key.lights.back().dimming = luminaire.dimming;
    }
    const DirectDisplay* direct = direct_display.get(key, [&] {
        const auto emitters = emitters_of(*run.scene);
        DisplayInput input;
        input.mesh = solution.mesh.get();
        input.emitters = emitters;
        input.occluders = shadows.get();
        input.open = key.open;
        return make_direct_display(input, run.work);
    });
    run.clock.mark_reused(direct_display.reused());
    if (!direct) return false;
    solution.display = dressed(*direct, interreflected, open);
    return true;
}

Study::Study() : stages_(std::make_unique<Stages>()) {}
Study::~Study() = default;

SolutionSnapshot Study::run(SceneSnapshot scene, const Settings& settings, const StudyRequest& request,
                            const Work& work, const std::function<void(SolutionSnapshot)>& publish) {
    Stages::Run run{std::move(scene), settings, request, work, StageClock(work.progress), nullptr};
    run.work.threads = settings.threads > 0 ? settings.threads : hardware_threads();
    stages_->prepare(run);
    if (request.shadows && !stages_->shadows(run)) return nullptr;

    const auto on_direct = [&](const LevelAnswer& answer) {
        if (!publish) return;
        take_answer(*run.solution, answer);
        if (request.display && !stages_->display(run, nothing(stages_->vertices->size()), {})) return;
        publish(std::make_shared<const Solution>(*run.solution));
    };
    const auto answer = stages_->fine.solve(run.fine_input(), run.work, run.clock, on_direct);
    if (!answer) return nullptr;
    std::optional<LevelAnswer> rough;
    if (request.mesh_error && run.solution->plan.simulates(Effect::interreflection)) {
        rough = stages_->solve_coarse(run);
        if (!rough) return nullptr;
    }
    take_answer(*run.solution, *answer);
    if (!stages_->values(run, *answer, rough ? &*rough : nullptr)) return nullptr;
    if (request.display) {
        const auto interreflected = stages_->vertex_interreflected(run, *answer);
        if (!interreflected) return nullptr;
        std::vector<double> open;
        if (request.unshadowed) {
            auto without_shadows = stages_->open_interreflected(run);
            if (!without_shadows) return nullptr;
            open = std::move(*without_shadows);
        }
        if (!stages_->display(run, *interreflected, open)) return nullptr;
    }

    for (const double half_width : answer->exitance_half_width)
        run.solution->iteration_bound = std::max(run.solution->iteration_bound, half_width);
    note_divergence(*run.solution);
    run.solution->complete = true;
    run.clock.enter(Stage::done);
    take_times(*run.solution, run.clock.finish());
    return run.solution;
}

}  // namespace hanei
