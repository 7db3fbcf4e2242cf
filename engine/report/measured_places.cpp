#include "engine/report/measured_report.h"
#include "engine/report/numbers.h"
#include "engine/study/study.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

constexpr std::size_t most_faults = 20;

template <class Objects>
auto named(const Objects& objects, const std::string& name) {
    return std::find_if(objects.begin(), objects.end(), [&](const auto& object) { return object.name == name; });
}

/// Finds the place of every value and computes ours there.
class Matching {
public:
    Matching(const Solution& solution, const MeasuredValues& measured) : solution_(solution) {
        comparison_.file = measured.file;
        comparison_.without_value = measured.without_value;
    }

    void take(const MeasuredValue& value) {
        const bool on_upright_grid = value.index && !value.height && grid_of(value) && !is_level(*grid_of(value));
        if (value.plan && !on_upright_grid)
            at_place(value);
        else if (value.index)
            at_index(value);
        else
            at_point(value);
    }

    MeasuredComparison done() {
        if (faults_ > most_faults)
            comparison_.faults.push_back(
                {Severity::error, {comparison_.file, 0, "", 0}, fmt::format("{} faults more", faults_ - most_faults)});
        if (faults_ == 0 && comparison_.pairs.empty())
            comparison_.faults.push_back({Severity::error,
                                          {comparison_.file, 0, "", 0},
                                          "every place of it is inside a solid here: there is nothing to compare"});
        return std::move(comparison_);
    }

private:
    void fault(const MeasuredValue& value, const char* field, const std::string& message) {
        if (++faults_ <= most_faults)
            comparison_.faults.push_back({Severity::error, {comparison_.file, value.line, field, 0}, message});
    }

    const CalculationGrid* grid_of(const MeasuredValue& value) const {
        const auto& grids = solution_.scene->grids;
        if (value.set.empty()) return grids.size() == 1 ? &grids.front() : nullptr;
        const auto found = named(grids, value.set);
        return found == grids.end() ? nullptr : &*found;
    }

    static Vec3 facing(const CalculationGrid& grid) { return glm::normalize(glm::cross(grid.along, grid.across)); }
    static bool is_level(const CalculationGrid& grid) { return std::abs(facing(grid).z) > 0.1; }

    /// That of the grid or point that is named; else up.
    Vec3 facing(const MeasuredValue& value) const {
        if (const CalculationGrid* const grid = grid_of(value)) return facing(*grid);
        const auto point = named(solution_.scene->points, value.set);
        return point != solution_.scene->points.end() ? point->normal : Vec3{0.0, 0.0, 1.0};
    }

    std::string names() const {
        std::string text;
        const auto add = [&](const std::string& name) {
            text += fmt::format("{}\"{}\"", text.empty() ? "there are " : ", ", name);
        };
        for (const CalculationGrid& grid : solution_.scene->grids) add(grid.name);
        for (const CalculationPoint& point : solution_.scene->points) add(point.name);
        return text.empty() ? "the scene has none" : text;
    }

    void at_place(const MeasuredValue& value) {
        const CalculationGrid* const grid = grid_of(value);
        Vec3 position{*value.plan, value.height.value_or(0.0)};
        if (!value.height) {
            if (!grid || !is_level(*grid))
                return fault(value, "z",
                             "the height is missing; it can be left out only on a grid that is named and not upright");
            const Vec3 from = position - grid->corner, faces = facing(*grid);
            position.z = grid->corner.z - (from.x * faces.x + from.y * faces.y) / faces.z;
        }
        const Vec3 normal = value.normal.value_or(facing(value));
        const std::string set = !value.set.empty() ? value.set : grid ? grid->name : std::string("places");
        add(value, set, position, value_at(solution_, position, normal));
    }

    void at_index(const MeasuredValue& value) {
        const CalculationGrid* const grid = grid_of(value);
        if (!grid)
            return fault(value, "set",
                         value.set.empty() ? "the grid that the index counts in is not named; " + names()
                                           : fmt::format("no calculation grid \"{}\"; {}", value.set, names()));
        const auto result = std::find_if(solution_.grids.begin(), solution_.grids.end(),
                                         [&](const GridResult& found) { return found.grid == grid->id; });
        const auto place = static_cast<std::size_t>(*value.index - 1);
        const std::size_t points = result == solution_.grids.end() ? 0 : result->points.size();
        if (place >= points)
            return fault(value, "index",
                         fmt::format("{} is beyond the grid \"{}\", which has points 1 to {}", *value.index, grid->name,
                                     points));
        const PointResult& ours = result->points[place];
        add(value, grid->name, ours.position, ours.value);
    }

    void at_point(const MeasuredValue& value) {
        const auto& points = solution_.scene->points;
        const auto authored = named(points, value.set);
        if (authored == points.end())
            return fault(
                value, "set",
                fmt::format("no calculation point \"{}\", and no index or place beside it; {}", value.set, names()));
        for (const PointResult& ours : solution_.points)
            if (ours.point == authored->id) return add(value, "points", ours.position, ours.value);
    }

    void add(const MeasuredValue& value, const std::string& set, const Vec3& position, const PointValue& ours) {
        if (ours.inside_solid) {
            ++comparison_.inside;
            return;
        }
        auto found = named(comparison_.sets, set);
        if (found == comparison_.sets.end()) {
            comparison_.sets.emplace_back().name = set;
            found = comparison_.sets.end() - 1;
        }
        comparison_.pairs.push_back({value, static_cast<std::size_t>(found - comparison_.sets.begin()), position,
                                     ours.total().value, ours.error.total()});
    }

    const Solution& solution_;
    MeasuredComparison comparison_;
    std::size_t faults_ = 0;
};

MeasuredSet::Deviation spread(std::vector<double> off) {
    MeasuredSet::Deviation deviation;
    std::sort(off.begin(), off.end());
    for (const double value : off) deviation.mean += value / static_cast<double>(off.size());
    deviation.p95 = off[std::min(off.size() - 1, off.size() * 95 / 100)];
    deviation.max = off.back();
    return deviation;
}

/// The figures of a set over the pairs that are in it: `which` says so.
template <class Which>
void fill(MeasuredSet& set, const std::vector<MeasuredPair>& pairs, Which which) {
    std::vector<double> lux, share;
    double theirs = 0.0, ours = 0.0;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const MeasuredPair& pair = pairs[k];
        if (!which(pair)) continue;
        const double off = std::abs(pair.difference());
        if (lux.empty() || off > std::abs(pairs[set.largest].difference())) set.largest = k;
        lux.push_back(off);
        theirs += pair.theirs.lux;
        ours += pair.ours;
        const double u = pair.theirs.uncertainty.value_or(0.0);
        set.within_ours += has_bound(pair.error_bar) && off <= pair.error_bar;
        set.within_both += has_bound(pair.error_bar) && off <= pair.error_bar + u;
        set.with_theirs += pair.theirs.uncertainty.has_value();
        set.within_theirs += pair.theirs.uncertainty.has_value() && off <= u;
    }
    set.points = lux.size();
    set.theirs = theirs / static_cast<double>(set.points);
    set.ours = ours / static_cast<double>(set.points);
    for (const MeasuredPair& pair : pairs) {
        const double whole = std::max(pair.theirs.lux, 0.1 * set.theirs);
        const double off = std::abs(pair.difference());
        if (which(pair)) share.push_back(whole > 0.0 ? off / whole : off > 0.0 ? 1.0 : 0.0);
    }
    set.lux = spread(std::move(lux));
    set.share = spread(std::move(share));
}

}  // namespace

MeasuredComparison compared_with(const Solution& solution, const MeasuredValues& measured,
                                 const std::stop_token& stop) {
    Matching matching(solution, measured);
    for (const MeasuredValue& value : measured.values) {
        if (stop.stop_requested()) return {};
        matching.take(value);
    }
    MeasuredComparison comparison = matching.done();
    if (!comparison.faults.empty()) {
        comparison.pairs.clear();
        comparison.sets.clear();
        return comparison;
    }
    for (std::size_t k = 0; k < comparison.sets.size(); ++k)
        fill(comparison.sets[k], comparison.pairs, [k](const MeasuredPair& pair) { return pair.set == k; });
    if (comparison.sets.size() > 1) {
        MeasuredSet all;
        all.name = "all";
        fill(all, comparison.pairs, [](const MeasuredPair&) { return true; });
        comparison.sets.push_back(std::move(all));
    }
    return comparison;
}

}  // namespace hanei
