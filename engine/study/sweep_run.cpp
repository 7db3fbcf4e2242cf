#include "engine/study/sweep_run.h"

#include "engine/base/tiles.h"
#include "engine/scene/dimmers.h"
#include "engine/study/level.h"
#include "engine/study/study.h"
#include "engine/study/value_stage.h"

#include <chrono>
#include <utility>

namespace hanei {
namespace {

double milliseconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

/// A solution as if nothing stood between surfaces: one level, gathered at the points.
class OpenRun {
public:
    std::optional<Solution> run(const SceneSnapshot& scene, const Settings& settings, const Work& work) {
        StageClock clock(nullptr);
        clock.enter(Stage::meshing);
        Solution solution;
        solution.scene = scene;
        solution.settings = settings;
        solution.plan = plan_effects(*scene, settings, PlanDetail::decisions);
        solution.mesh = level_.cut(*scene, settings.max_patch, settings.method, solution.plan.black).mesh;
        if (!occluders_) occluders_ = std::make_shared<const OccluderSet>(occluders_of(*scene));
        CalculationPlaces places = places_of(*scene);
        if (!points_) points_ = std::make_shared<const std::vector<Receiver>>(receivers_at(places, *solution.mesh));

        LevelInput input;
        input.scene = scene.get();
        input.settings = &settings;
        input.plan = &solution.plan;
        input.occluders = occluders_;
        input.direct_accuracy = accuracy_of_each(share_of_direct, dim_lux, scene->luminaires.size());
        const auto answer = level_.solve(input, work, clock);
        if (!answer) return std::nullopt;
        clock.enter(Stage::gathering);
        std::vector<double> interreflected(points_->size(), 0.0);
        if (!answer->parts.empty()) {
            auto gathered = level_.gather(0, answer->parts, points_, input, work, clock);
            if (!gathered) return std::nullopt;
            interreflected = std::move(gathered->interreflected);
        }
        if (direct_.empty() && !light_points(*scene, work)) return std::nullopt;
        std::size_t k = 0;
        places.for_each([&](PointResult& point) {
            point.value.direct = {direct_[k]};
            point.value.interreflected = {interreflected[k]};
            point.value.inside_solid = is_covered(*occluders_, point.position, point.normal);
            ++k;
        });
        solution.points = std::move(places.points);
        solution.grids = std::move(places.grids);
        solution.exitance = level_.node_values({});
        solution.times = clock.finish();
        return solution;
    }

private:
    static constexpr double share_of_direct = 1e-3, dim_lux = 1.0;

    bool light_points(const Scene& scene, const Work& work) {
        std::vector<double> sum(points_->size(), 0.0);
        for (const Luminaire& luminaire : scene.luminaires) {
            const double share = scene.maintenance_factor * dimming_of(scene, luminaire);
            const auto light = direct_illuminance(Emitter(scene, luminaire), *points_, occluders_.get(), work);
            if (!light) return false;
            for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += share * (*light)[k];
        }
        direct_ = std::move(sum);
        return true;
    }

    Level level_;
    std::shared_ptr<const OccluderSet> occluders_;
    std::shared_ptr<const std::vector<Receiver>> points_;
    std::vector<double> direct_;  ///< lx, at the points
};

}  // namespace

double SweepAnswer::balance_ms() const {
    for (const StageTime& time : times)
        if (time.stage == Stage::balance) return time.ms;
    return 0.0;
}

struct SweepRun::Parts {
    SceneSnapshot scene;
    Settings settings;
    bool shadows = true;
    std::vector<std::string> point_sets;
    Study study;
    OpenRun open;
};

SweepRun::SweepRun(SceneSnapshot scene, const Settings& settings, bool shadows, std::vector<std::string> point_sets)
    : parts_(std::make_unique<Parts>()) {
    parts_->scene = std::move(scene);
    parts_->settings = settings;
    parts_->shadows = shadows;
    parts_->point_sets = std::move(point_sets);
}
SweepRun::~SweepRun() = default;
SweepRun::SweepRun(SweepRun&&) noexcept = default;

std::optional<SweepAnswer> SweepRun::with_bounces(int bounces, const Work& work) {
    Settings settings = parts_->settings;
    settings.bounces = bounces;
    const auto begin = std::chrono::steady_clock::now();
    SweepAnswer answer;
    if (parts_->shadows) {
        answer.solution = parts_->study.run(parts_->scene, settings, StudyRequest{.mesh_error = false}, work);
    } else {
        const int threads = settings.threads > 0 ? settings.threads : hardware_threads();
        auto solution = parts_->open.run(parts_->scene, settings, Work{threads, work.stop, nullptr});
        if (solution) answer.solution = std::make_shared<const Solution>(std::move(*solution));
    }
    if (!answer.solution) return std::nullopt;
    answer.milliseconds = milliseconds_since(begin);
    const Solution& solution = *answer.solution;
    answer.values = compared_values(solution, parts_->point_sets);
    answer.unknowns = is_of_the_paper(settings.method) ? solution.mesh->vertices.size() : solution.exitance.size();
    answer.times = solution.times;
    return answer;
}

}  // namespace hanei
