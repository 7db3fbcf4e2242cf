#include "engine/direct/intensity_table.h"

#include "engine/geometry/arc_tangent.h"
#include "engine/scene/intensity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {

namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

/// As in intensity(): a direction this far past the last angle is still on it.
constexpr double at_the_end = 1e-9;

/// How far the stored planes may reach from the first one.
double range_of(PhotometricSymmetry symmetry) {
    switch (symmetry) {
        case PhotometricSymmetry::rotational:
        case PhotometricSymmetry::none:
            break;
        case PhotometricSymmetry::quadrant:
            return 90.0;
        case PhotometricSymmetry::plane_0:
        case PhotometricSymmetry::plane_90:
            return 180.0;
    }
    return 360.0;
}

}  // namespace

IntensityTable::Angles::Angles(std::vector<double> angles) : angles_(std::move(angles)) {
    const double width = angles_.back() - angles_.front();
    const double interval = width / static_cast<double>(angles_.size() - 1);
    even_ = true;
    for (std::size_t k = 0; k < angles_.size(); ++k) {
        const double expected = angles_.front() + static_cast<double>(k) * interval;
        even_ = even_ && std::abs(angles_[k] - expected) <= 1e-12 * interval;
    }
    const std::size_t steps = even_ ? angles_.size() - 1 : 4 * angles_.size();
    steps_a_degree_ = static_cast<double>(steps) / width;
    for (std::size_t k = 0; k + 1 < angles_.size(); ++k) inverse_width_.push_back(1.0 / (angles_[k + 1] - angles_[k]));
    std::uint32_t at = 0;
    for (std::size_t step = 0; step < steps; ++step) {
        const double angle = angles_.front() + static_cast<double>(step) / steps_a_degree_;
        while (at + 2 < angles_.size() && angles_[at + 1] <= angle) ++at;
        begin_.push_back(at);
    }
}

IntensityTable::Angles::Place IntensityTable::Angles::place_of(double angle) const {
    const double away = std::max(0.0, angle - angles_.front()) * steps_a_degree_;
    const auto step = static_cast<std::size_t>(static_cast<std::int64_t>(away));
    if (even_) {
        const std::size_t first = std::min(step, angles_.size() - 2);
        return {first, std::min(away - static_cast<double>(static_cast<std::int64_t>(first)), 1.0)};
    }
    return search(angle, std::min(step, begin_.size() - 1));
}

IntensityTable::Angles::Place IntensityTable::Angles::search(double angle, std::size_t step) const {
    std::size_t k = begin_[step];
    while (k > 0 && angles_[k] > angle) --k;
    while (k + 2 < angles_.size() && angles_[k + 1] <= angle) ++k;
    return {k, std::clamp((angle - angles_[k]) * inverse_width_[k], 0.0, 1.0)};
}

IntensityTable::IntensityTable(Photometry photometry)
    : photometry_(std::move(photometry)), peak_(peak_intensity(photometry_).value) {
    if (photometry_.type != PhotometricType::C || photometry_.vertical_deg.size() < 2) return;
    vertical_ = Angles(photometry_.vertical_deg);
    prepared_ = unfold();
}

void IntensityTable::add_plane(std::vector<double>& planes, double angle, std::size_t stored) {
    if (!planes.empty() && angle <= planes.back()) return;  // on the mirror plane itself
    planes.push_back(angle);
    row_of_.push_back(stored * photometry_.vertical_deg.size());
}

/// The planes from the first one all around; a plane and its mirror image hold the same candela.
bool IntensityTable::unfold() {
    const std::vector<double>& stored = photometry_.horizontal_deg;
    const PhotometricSymmetry symmetry = photometry_.symmetry;
    if (symmetry == PhotometricSymmetry::rotational) return true;
    const bool folded = symmetry != PhotometricSymmetry::none;
    const double mirror = symmetry == PhotometricSymmetry::quadrant ? 0.0 : stored.front();
    if (stored.front() < mirror || stored.back() > mirror + range_of(symmetry)) return false;

    std::vector<double> planes;
    for (std::size_t k = 0; k < stored.size(); ++k) add_plane(planes, stored[k], k);
    if (symmetry == PhotometricSymmetry::quadrant) {
        for (std::size_t k = stored.size(); k-- > 0;) add_plane(planes, 180.0 - stored[k], k);
    }
    if (folded) {
        for (std::size_t k = row_of_.size(); k-- > 0;) {
            add_plane(planes, 2.0 * mirror + 360.0 - planes[k], row_of_[k] / photometry_.vertical_deg.size());
        }
    }
    add_plane(planes, planes.front() + 360.0, 0);
    if (planes.size() < 2) return false;
    planes_ = Angles(std::move(planes));
    return true;
}

double IntensityTable::in_plane(std::size_t plane, const Angles::Place& vertical) const {
    const double* candela = photometry_.candela.data() + plane + vertical.first;
    return candela[0] + vertical.weight * (candela[1] - candela[0]);
}

double IntensityTable::candela(const Vec3& in_luminaire) const {
    if (!prepared_) return intensity(photometry_, in_luminaire).value;  // which asks for angles only
    const Vec3 direction = in_file_frame(photometry_, in_luminaire);
    const double level = std::sqrt(direction.x * direction.x + direction.y * direction.y);
    const double angle = arc_tangent(level, -direction.z) * degrees;
    if (angle < vertical_.front() - at_the_end || angle > vertical_.back() + at_the_end) return 0.0;
    const Angles::Place vertical = vertical_.place_of(angle);
    if (row_of_.empty()) return in_plane(0, vertical);
    double around = arc_tangent(direction.y, direction.x) * degrees;
    while (around < planes_.front()) around += 360.0;
    while (around > planes_.front() + 360.0) around -= 360.0;
    const Angles::Place plane = planes_.place_of(around);
    const double first = in_plane(row_of_[plane.first], vertical);
    return first + plane.weight * (in_plane(row_of_[plane.first + 1], vertical) - first);
}

}  // namespace hanei
