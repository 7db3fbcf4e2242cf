/// Our values against those of somebody else: a meter, another program.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/scene/measured_values.h"
#include "engine/solution/solution.h"

#include <stop_token>
#include <string>
#include <vector>

namespace hanei {

struct MeasuredPair {
    MeasuredValue theirs;
    std::size_t set = 0;  ///< into MeasuredComparison::sets
    Vec3 position{0.0};
    double ours = 0.0;       ///< lx
    double error_bar = 0.0;  ///< lx, ours
    double difference() const { return ours - theirs.lux; }
};

/// Deviations without their sign, lx and shares of their value; where that is less than a tenth of the set's mean, of
/// this tenth, so that dark places do not count for more than they light.
struct MeasuredSet {
    std::string name;
    std::size_t points = 0;
    double theirs = 0.0, ours = 0.0;  ///< means, lx
    struct Deviation {
        double mean = 0.0, p95 = 0.0, max = 0.0;
    };
    Deviation lux, share;
    std::size_t within_ours = 0;    ///< no further apart than our error bar
    std::size_t with_theirs = 0;    ///< values that come with an uncertainty of theirs
    std::size_t within_theirs = 0;  ///< of these, no further apart than it
    std::size_t within_both = 0;    ///< no further apart than our error bar and their uncertainty together
    std::size_t largest = 0;        ///< the largest deviation, lx: into MeasuredComparison::pairs
};

struct MeasuredComparison {
    std::string file;
    std::vector<MeasuredPair> pairs;
    std::vector<MeasuredSet> sets;  ///< as they come in the file; several are closed by "all"
    std::size_t without_value = 0;  ///< of theirs
    std::size_t inside = 0;         ///< of ours: inside solids
    Diagnostics faults;             ///< values of places that the scene does not have; then there are no sets
};

/// A row with x and y is of that place, computed there, facing as it says, else as the grid or point it names,
/// else up; one with an index of that point of the grid it names, or of the only grid; one with a name alone of
/// that calculation point.
///
/// Needs     a complete solution.
/// Returns   empty pairs with `stop` wished.
/// Cost      a value_at() for every row with a place.
MeasuredComparison compared_with(const Solution& solution, const MeasuredValues& measured,
                                 const std::stop_token& stop = {});

/// Where the largest deviation of a set is: "row 12: Desk 3 at 1.2, 3.4, 0.75: theirs 512, ours 498.1 ± 0.6 lx".
std::string largest_text(const MeasuredComparison& comparison, const MeasuredSet& set);

std::string measured_text(const MeasuredComparison& comparison);
std::string measured_csv(const MeasuredComparison& comparison);   ///< a row a pair
std::string measured_json(const MeasuredComparison& comparison);  ///< sets and pairs, as one object

}  // namespace hanei
