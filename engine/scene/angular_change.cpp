#include "engine/scene/angular_change.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hanei {

using std::numbers::pi;

namespace {

constexpr double radian = pi / 180.0;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double at_pole = 1e-6;  // rad: a file that writes 0.00001 degrees means the pole

/// The direction of colatitude 0, in the luminaire's frame.
Vec3 pole_of(const Photometry& photometry) {
    if (photometry.type != PhotometricType::B) return {0.0, 0.0, -1.0};
    constexpr std::array<Vec3, 4> turned = {Vec3{0, 1, 0}, Vec3{-1, 0, 0}, Vec3{0, -1, 0}, Vec3{1, 0, 0}};
    return turned[static_cast<std::size_t>(photometry.quarter_turns & 3)];
}

/// What lies beyond the first and the last longitude.
enum class Ends { joined, mirrored, mirrored_and_dark, dark };

Ends ends_of(const Photometry& photometry) {
    if (photometry.type == PhotometricType::B) return Ends::dark;
    if (photometry.type == PhotometricType::A) {
        const bool mirrored =
            photometry.symmetry == PhotometricSymmetry::plane_0 && std::abs(photometry.horizontal_deg.front()) < 1e-6;
        return mirrored ? Ends::mirrored_and_dark : Ends::dark;
    }
    const bool folded =
        photometry.symmetry != PhotometricSymmetry::none && photometry.symmetry != PhotometricSymmetry::rotational;
    return folded ? Ends::mirrored : Ends::joined;
}

/// The greatest of T / sin over a zone. From a pole T rises as the angle does, so that the quotient is
/// greatest at the other end; what the planes differ by at the pole itself is counted as a jump.
double over_sine(double first, double last, double low, double high) {
    if (low > at_pole && high < pi - at_pole) return std::max(first, last) / std::min(std::sin(low), std::sin(high));
    if (low <= at_pole && high >= pi - at_pole) return infinite;
    return low <= at_pole ? last / std::sin(high) : first / std::sin(low);
}

}  // namespace

/// All figures of one colatitude, by longitude.
struct AngularChanges::Row {
    double colatitude = 0.0;
    std::vector<double> candela;
    double around = 0.0;  ///< cd/rad of longitude, the greatest slope
    double bend = 0.0;    ///< cd/rad of longitude, the greatest step of the slope
};

std::vector<AngularChanges::Row> AngularChanges::rows_of(const Photometry& photometry) {
    const std::size_t rays = photometry.vertical_deg.size(), planes = photometry.horizontal_deg.size();
    std::vector<Row> rows;
    if (photometry.type == PhotometricType::B) {
        const auto row = [&](std::size_t plane, double sign) {
            const double* first = photometry.candela.data() + plane * rays;
            const double latitude = sign * photometry.horizontal_deg[plane];
            rows.push_back({(90.0 + latitude) * radian, {first, first + rays}});
        };
        if (photometry.symmetry == PhotometricSymmetry::plane_0) {
            for (std::size_t plane = planes; plane-- > 0;) row(plane, -1.0);
            if (!(photometry.horizontal_deg.front() > 0.0)) rows.pop_back();
        }
        for (std::size_t plane = 0; plane < planes; ++plane) row(plane, 1.0);
        return rows;
    }
    const double shift = photometry.type == PhotometricType::A ? 90.0 : 0.0;
    for (std::size_t ray = 0; ray < rays; ++ray) {
        Row row{(shift + photometry.vertical_deg[ray]) * radian, {}};
        for (std::size_t plane = 0; plane < planes; ++plane)
            row.candela.push_back(photometry.candela[plane * rays + ray]);
        rows.push_back(std::move(row));
    }
    return rows;
}

void AngularChanges::measure_around(std::vector<Row>& rows, const Photometry& photometry) {
    const std::vector<double>& longitudes =
        photometry.type == PhotometricType::B ? photometry.vertical_deg : photometry.horizontal_deg;
    const Ends ends = ends_of(photometry);
    const std::size_t count = longitudes.size();
    if (count < 2) return;
    std::vector<double> widths;
    for (std::size_t k = 0; k + 1 < count; ++k) widths.push_back((longitudes[k + 1] - longitudes[k]) * radian);
    const double gap = 2.0 * pi - (longitudes.back() - longitudes.front()) * radian;
    const bool closes = ends == Ends::joined && gap > 1e-9;
    if (closes) widths.push_back(gap);
    least_gap_ = std::ranges::min(widths);
    for (Row& row : rows) {
        const auto slope = [&](std::size_t k) { return (row.candela[(k + 1) % count] - row.candela[k]) / widths[k]; };
        const double front = slope(0), back = slope(widths.size() - 1);
        double before = front;
        for (std::size_t k = 0; k < widths.size(); ++k) {
            const double here = slope(k);
            row.around = std::max(row.around, std::abs(here));
            row.bend = std::max(row.bend, std::abs(here - before));
            before = here;
        }
        // A mirror doubles the slope at its plane; where the table goes around, its ends meet.
        const double at_ends =
            ends == Ends::joined ? std::abs(front - back) : 2.0 * std::max(std::abs(front), std::abs(back));
        row.bend = std::max(row.bend, at_ends);
        double jump = 0.0;
        if (ends == Ends::joined && !closes) jump = std::abs(row.candela.front() - row.candela.back());
        if (ends == Ends::dark) jump = std::max(row.candela.front(), row.candela.back());
        if (ends == Ends::mirrored_and_dark) jump = row.candela.back();
        jump_everywhere_ = std::max(jump_everywhere_, jump);
    }
}

void AngularChanges::measure_along(const std::vector<Row>& rows) {
    std::vector<double> before(rows.front().candela.size(), 0.0), along = before;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const Row& row = rows[k];
        Ring ring{row.colatitude, std::ranges::max(row.candela), 0.0};
        std::ranges::fill(along, 0.0);
        if (k + 1 < rows.size()) {
            const Row& next = rows[k + 1];
            const double width = next.colatitude - row.colatitude;
            Zone zone{row.colatitude, next.colatitude};
            for (std::size_t p = 0; p < along.size(); ++p) {
                along[p] = (next.candela[p] - row.candela[p]) / width;
                zone.slope = std::max(zone.slope, std::abs(along[p]));
            }
            const auto [least, most] = std::ranges::minmax(along);
            zone.sideways = over_sine(row.around, next.around, zone.low, zone.high);
            zone.bend = over_sine(row.bend, next.bend, zone.low, zone.high);
            zone.twist = std::min((row.around + next.around) / width, (most - least) / least_gap_);
            zones_.push_back(zone);
        }
        for (std::size_t p = 0; p < along.size(); ++p) ring.step = std::max(ring.step, std::abs(along[p] - before[p]));
        before = along;
        rings_.push_back(ring);
    }
}

/// At a pole where the planes disagree a part of the table that depends on the plane alone fades out
/// over the first zone: it is a jump, and what is left has the mean for the planes' figures. Elsewhere
/// the table ends, and what goes on along its end ends too.
AngularChanges::End AngularChanges::end_at(const Row& row, bool first) {
    Zone& zone = first ? zones_.front() : zones_.back();
    if (first ? row.colatitude > at_pole : row.colatitude < pi - at_pole) {
        const double jump = std::ranges::max(row.candela);
        return {jump, jump > 0.0 ? zone.sideways : 0.0, row.colatitude};
    }
    const double jump = std::ranges::max(row.candela) - std::ranges::min(row.candela);
    const double steeper = jump / (zone.high - zone.low);
    zone.slope += steeper;
    rings_[first ? 1 : rings_.size() - 2].step += steeper;
    return {jump, 0.0, first ? zone.high : zone.low};
}

AngularChanges::AngularChanges(const Photometry& photometry)
    : pole_(pole_of(photometry)), upright_(photometry.type != PhotometricType::B) {
    std::vector<Row> rows = rows_of(photometry);
    measure_around(rows, photometry);
    measure_along(rows);
    if (zones_.empty()) return;  // one plane of type B: dark but in that plane
    first_ = end_at(rows.front(), true);
    last_ = end_at(rows.back(), false);
}

double AngularChanges::colatitude(const Vec3& direction) const {
    return std::acos(std::clamp(glm::dot(direction, pole_) / glm::length(direction), -1.0, 1.0));
}

AngularChange AngularChanges::over(double low, double high, double angle) const {
    AngularChange change;
    const double from = low - angle, to = high + angle;
    const bool at_a_pole = from <= 0.0 || to >= pi;
    double bend = 0.0, below = 0.0, above = 0.0, sideways = 0.0, twist = 0.0, meridional = 0.0;
    const auto zone_at = std::ranges::lower_bound(zones_, from, {}, &Zone::high);
    for (auto k = static_cast<std::size_t>(zone_at - zones_.begin()); k < zones_.size(); ++k) {
        const Zone& zone = zones_[k];
        if (zone.low > to) break;
        if (zone.low <= high && zone.high >= low)
            change.greatest = std::max({change.greatest, rings_[k].greatest, rings_[k + 1].greatest});
        change.slope = std::max(change.slope, std::hypot(zone.slope, zone.sideways));
        meridional = std::max(meridional, zone.slope);
        sideways = std::max(sideways, zone.sideways);
        bend = std::max(bend, zone.bend);
        twist = std::max(twist, zone.twist);
    }
    const auto ring_at = std::ranges::lower_bound(rings_, from, {}, &Ring::colatitude);
    for (auto ring = ring_at; ring != rings_.end() && ring->colatitude <= to; ++ring) {
        const double at = ring->colatitude;
        if (at >= low) above += ring->step * (1.0 - std::max(0.0, at - high) / angle);
        if (at <= high) below += ring->step * (1.0 - std::max(0.0, low - at) / angle);
    }
    double stops = 0.0;
    if (first_.reach >= from) change.jump = first_.jump, stops = first_.stops;
    if (last_.reach <= to) change.jump = std::max(change.jump, last_.jump), stops += last_.stops;
    change.jump += jump_everywhere_;
    if (upright_) change.lean = at_a_pole ? 1.0 : std::max(std::abs(std::cos(from)), std::abs(std::cos(to)));
    if (at_a_pole) {
        change.turning = 1.0;
        change.kinks = change.bends = change.curvature = infinite;
        return change;
    }
    const double sine = std::min(std::sin(from), std::sin(to));
    const double cotangent = std::sqrt(std::max(0.0, 1.0 - sine * sine)) / sine;
    const double meridians = 1.0 + angle / (sine * 2.0 * least_gap_);
    change.turning = std::min(1.0, angle * cotangent);
    change.kinks = std::max(std::max(above, below), 2.0 * change.turning * (above + below));
    change.bends = bend * meridians + stops;
    change.curvature = 0.5 * (twist / sine + meridional * cotangent + sideways * cotangent);
    return change;
}

}  // namespace hanei
