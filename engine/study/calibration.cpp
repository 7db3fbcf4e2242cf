#include "engine/study/calibration.h"

#include "engine/mesh/patch_count.h"
#include "engine/scene/grid_spacing.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace hanei {
namespace {

/// Figures of a scene, mixed into one (FNV-1a).
class Mixture {
public:
    void add(std::uint64_t bits) {
        for (int byte = 0; byte < 8; ++byte) {
            state_ ^= (bits >> (8 * byte)) & 0xff;
            state_ *= 0x100000001b3ULL;
        }
    }
    void add(double figure) { add(std::bit_cast<std::uint64_t>(figure)); }
    void add(const Vec3& place) {
        for (int axis = 0; axis < 3; ++axis) add(place[axis]);
    }
    std::uint64_t value() const { return state_ == 0 ? 1 : state_; }

private:
    std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

std::uint64_t room_of(const Scene& scene, const std::vector<Face>& faces) {
    Mixture mixture;
    for (const Face& face : faces) {
        for (const Vec3& corner : face.region.outline) mixture.add(corner);
        mixture.add(face.own_exitance.value);
    }
    for (const Luminaire& luminaire : scene.luminaires) mixture.add(luminaire.position);
    for (const CalculationPoint& point : scene.points) mixture.add(point.position);
    for (const CalculationGrid& grid : scene.grids) mixture.add(grid.corner);
    return mixture.value();
}

/// By how much errors fall when unknowns become more, by method: error ~ unknowns^-order.
double order_of(Method method) {
    switch (method) {
        case Method::paper:
            return 0.3;
        case Method::paper_closed:
            return 0.4;
        case Method::patch:
            return 0.6;
        case Method::linear:
            return 0.7;
    }
    return 0.5;
}

std::optional<TimedStage> timed(Stage stage) {
    switch (stage) {
        case Stage::planning:
        case Stage::meshing:
            return TimedStage::meshing;
        case Stage::direct:
            return TimedStage::direct;
        case Stage::factors:
            return TimedStage::factors;
        case Stage::balance:
            return TimedStage::balance;
        case Stage::gathering:
            return TimedStage::gathering;
        default:
            return std::nullopt;
    }
}

double median(std::vector<double> figures) {
    if (figures.empty()) return 0.0;
    std::sort(figures.begin(), figures.end());
    const std::size_t half = figures.size() / 2;
    return figures.size() % 2 == 1 ? figures[half] : 0.5 * (figures[half - 1] + figures[half]);
}

constexpr std::size_t neighbours = 5;
constexpr double of_another_room = 2.0;  // errors of unlike rooms differ so much: what is promised shall hold

/// The samples most like what is asked, nearest first.
std::vector<const CalibrationSample*> nearest(const std::vector<CalibrationSample>& samples, const ExpectedWork& work,
                                              Method method, bool with_error) {
    const auto distance = [&](const CalibrationSample& sample) {
        constexpr double another_room = 100.0;  // more than any number of unknowns
        const double apart = std::abs(std::log(std::max(1.0, sample.unknowns) / std::max(1.0, work.unknowns)));
        return apart + (sample.room == work.room ? 0.0 : another_room);
    };
    std::vector<const CalibrationSample*> alike;
    for (auto sample = samples.rbegin(); sample != samples.rend(); ++sample)  // the newest first
        if (sample->method == method && (!with_error || sample->error)) alike.push_back(&*sample);
    std::stable_sort(alike.begin(), alike.end(), [&](const CalibrationSample* a, const CalibrationSample* b) {
        return distance(*a) < distance(*b);
    });
    const bool known = !alike.empty() && alike.front()->room == work.room;
    std::size_t count = std::min(neighbours, alike.size());
    while (known && alike[count - 1]->room != work.room) --count;
    // Of the same room and size one is as good as measured: others would only blur it.
    if (known && distance(*alike.front()) < 0.1)
        while (distance(*alike[count - 1]) > 0.35) --count;
    alike.resize(count);
    return alike;
}

}  // namespace

ExpectedWork expected_work(const Scene& scene, const Settings& settings) {
    constexpr double least_width = 1e-3;  // m
    const std::vector<Face> faces = faces_of(scene);
    const double patches = patch_count(faces, std::max(settings.max_patch, least_width));
    double points = static_cast<double>(scene.points.size());
    for (const CalculationGrid& grid : scene.grids)
        if (grid.spacing > 0.0) points += grid_points(grid);
    double bodies = static_cast<double>(scene.surfaces.size());
    for (const Furniture& piece : scene.furniture) bodies += static_cast<double>(piece.parts.size());
    const double hiding = std::log2(2.0 + bodies);
    const double luminaires = std::max(1.0, static_cast<double>(scene.luminaires.size()));
    const double reflections =
        std::min<double>(settings.bounces, std::ceil(std::log2(1.0 / std::clamp(settings.accuracy, 1e-12, 0.5))));

    ExpectedWork work;
    work.room = room_of(scene, faces);
    work.unknowns = settings.method == Method::linear ? 4.0 * patches : patches;
    work.units = {patches, patches * luminaires * hiding, work.unknowns * work.unknowns * hiding,
                  work.unknowns * work.unknowns * (1.0 + reflections),
                  points * (luminaires + work.unknowns) * hiding + work.unknowns};
    return work;
}

CalibrationSample sample_of(const ExpectedWork& work, Method method, const std::vector<StageTime>& times) {
    CalibrationSample sample;
    sample.method = method;
    sample.unknowns = work.unknowns;
    sample.room = work.room;
    for (const StageTime& time : times) {
        const auto stage = timed(time.stage);
        if (!stage) continue;
        const std::size_t k = static_cast<std::size_t>(*stage);
        if (work.units[k] > 0.0) sample.ns_a_unit[k] += 1e6 * time.ms / work.units[k];
    }
    return sample;
}

void Calibration::learn(const CalibrationSample& sample) {
    samples_.push_back(sample);
    if (samples_.size() > most_samples)
        samples_.erase(samples_.begin(), samples_.end() - static_cast<std::ptrdiff_t>(most_samples));
}

Prediction Calibration::predict(const ExpectedWork& work, Method method) const {
    Prediction prediction;
    auto timing = nearest(samples_, work, method, false);
    prediction.studies = static_cast<int>(timing.size());
    prediction.same_room = !timing.empty() && timing.front()->room == work.room;
    if (timing.empty()) timing = nearest(usual_samples(), work, method, false);
    for (std::size_t stage = 0; stage < timed_stages; ++stage) {
        std::vector<double> ns;
        for (const CalibrationSample* sample : timing) ns.push_back(sample->ns_a_unit[stage]);
        prediction.ms += 1e-6 * median(std::move(ns)) * work.units[stage];
    }
    auto erring = nearest(samples_, work, method, true);
    if (erring.empty()) erring = nearest(usual_samples(), work, method, true);
    std::vector<double> errors;
    for (const CalibrationSample* sample : erring)
        errors.push_back(*sample->error *
                         std::pow(std::max(1.0, sample->unknowns) / std::max(1.0, work.unknowns), order_of(method)));
    prediction.error = median(std::move(errors));
    if (!erring.empty() && erring.front()->room != work.room) prediction.error *= of_another_room;
    return prediction;
}

}  // namespace hanei
