#include "engine/direct/measured_source.h"

#include "engine/direct/opening_integral.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/visible_part.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {

namespace {

/// The angle over which the intensity would change by its peak at its fastest change: about 1 for a
/// cosine distribution, the width of the flank for a narrow beam.
double finest_beam(const Photometry& photometry) {
    const double peak = std::ranges::max(photometry.candela);
    if (!(peak > 0.0)) return 1.0;
    const std::size_t angles = photometry.vertical_deg.size();
    double fastest = peak;
    for (std::size_t k = 0; k < photometry.candela.size(); ++k) {
        if (k % angles == 0) continue;
        const double step = photometry.vertical_deg[k % angles] - photometry.vertical_deg[k % angles - 1];
        const double change = std::abs(photometry.candela[k] - photometry.candela[k - 1]);
        fastest = std::max(fastest, change / (step * std::numbers::pi / 180.0));
    }
    return peak / fastest;
}

/// True for a table of zeros above 90 degrees, or one that ends there.
bool is_dark_above(const Photometry& photometry) {
    if (photometry.type != PhotometricType::C) return false;
    const std::vector<double>& angles = photometry.vertical_deg;
    if (angles.back() <= 90.0) return true;
    const std::size_t count = angles.size();
    for (std::size_t k = 0; k < photometry.candela.size(); ++k) {
        const std::size_t angle = k % count;
        const bool reaches_above = angle + 1 == count || angles[angle + 1] > 90.0;
        if (reaches_above && photometry.candela[k] != 0.0) return false;
    }
    return true;
}

}  // namespace

MeasuredSource::MeasuredSource(const Placement& placed, const Region& opening, Photometry photometry, double scale)
    : rotation_(placed.rotation),
      pieces_(convex_pieces(opening)),
      outline_(opening.outline),
      table_(std::move(photometry)),
      scale_over_area_(scale / glm::length(vector_area(opening))),
      dark_above_(is_dark_above(table_.photometry())),
      finest_beam_(finest_beam(table_.photometry())) {}

bool MeasuredSource::may_light(const Receiver& receiver) const {
    const auto below_horizon = [&](const Vec3& corner) {
        return glm::dot(corner - receiver.position, receiver.normal) <= 0.0;
    };
    if (std::ranges::all_of(outline_, below_horizon)) return false;
    const auto seen_from_above = [&](const Vec3& corner) {
        const Vec3 away = receiver.position - corner;
        return glm::dot(away, rotation_[2]) > 1e-9 * glm::length(away);  // the last angle itself still shines
    };
    return !dark_above_ || !std::ranges::all_of(outline_, seen_from_above);
}

double MeasuredSource::obstructed(const Receiver& receiver, const Obstacles& obstacles) const {
    if (!may_light(receiver)) return 0.0;
    thread_local std::vector<BodyIndex> others;
    obstacles.between(receiver.position, outline_, others);
    OpeningIntegral integral(table_, rotation_, receiver, finest_beam_);
    for (const Polygon& piece : pieces_) {
        const bool wholly_above = std::ranges::all_of(
            piece, [&](const Vec3& corner) { return glm::dot(corner - receiver.position, receiver.normal) >= 0.0; });
        if (wholly_above && others.empty()) {
            integral.add(piece);
            continue;
        }
        const Polygon risen = wholly_above ? piece : clipped(piece, {receiver.position, receiver.normal}, 0.0);
        if (risen.empty()) continue;
        if (others.empty()) {
            integral.add(risen);
        } else {
            for (const Polygon& part : visible_part(risen, receiver.position, *obstacles.occluders, others))
                integral.add(part);
        }
    }
    return scale_over_area_ * integral.value();
}

}  // namespace hanei
