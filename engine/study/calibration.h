/// What studies take and how exact they are, by studies of before: predictions before anything is run.
#pragma once

#include "engine/plan/settings.h"
#include "engine/scene/scene.h"
#include "engine/solution/solution.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace hanei {

/// The stages whose time is predicted, one from the other because they grow differently with the scene.
enum class TimedStage { meshing, direct, factors, balance, gathering };
inline constexpr std::size_t timed_stages = 5;
using StageFigures = std::array<double, timed_stages>;

/// How much there is to do before anything is made: patches; patches times luminaires; pairs of
/// unknowns; these times reflections; points times what they see. Each past so many bodies.
struct ExpectedWork {
    double unknowns = 0.0;
    StageFigures units{};
    std::uint64_t room = 0;  ///< of what stands in the room and what lights it; equal for equal scenes
};
ExpectedWork expected_work(const Scene& scene, const Settings& settings);

/// What one study taught.
struct CalibrationSample {
    Method method = Method::patch;
    double unknowns = 0.0;   ///< expected ones
    std::uint64_t room = 0;  ///< ExpectedWork::room; 0: of no room in particular
    StageFigures ns_a_unit{};
    /// Share of the value that 95 of 100 points were within; not known of studies that nothing was
    /// compared with.
    std::optional<double> error{};
    bool operator==(const CalibrationSample&) const = default;
};

/// Needs     times of a study from nothing.
CalibrationSample sample_of(const ExpectedWork& work, Method method, const std::vector<StageTime>& times);

struct Prediction {
    double ms = 0.0;         ///< from nothing to every value
    double error = 0.0;      ///< share of the value that 95 of 100 points are predicted to be within
    int studies = 0;         ///< of this machine that it rests on; 0: on figures measured elsewhere
    bool same_room = false;  ///< these studies were of this very room
};

/// The last studies of this machine. A plain value.
///
/// Holds     the last `most_samples`, oldest first.
class Calibration {
public:
    static constexpr std::size_t most_samples = 240;

    void learn(const CalibrationSample& sample);
    const std::vector<CalibrationSample>& samples() const { return samples_; }
    bool operator==(const Calibration&) const = default;

    /// From the five studies of this method that are most like it, first those of the same room, then
    /// those of about as many unknowns: the median of each stage's time a unit of work, and of the
    /// error carried over to this number of unknowns, twice that of other rooms. What was never studied
    /// here is predicted from figures measured on the rooms that come with the program.
    ///
    /// Weak when the room is unlike all others: take it for the order of magnitude.
    Prediction predict(const ExpectedWork& work, Method method) const;
    Prediction predict(const Scene& scene, const Settings& settings) const {
        return predict(expected_work(scene, settings), settings.method);
    }

private:
    std::vector<CalibrationSample> samples_;
};

/// What is known of every machine: measured on the rooms that come with the program.
const std::vector<CalibrationSample>& usual_samples();

}  // namespace hanei
