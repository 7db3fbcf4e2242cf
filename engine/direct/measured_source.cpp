#include "engine/direct/measured_source.h"

#include "engine/direct/measured_opening.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/visible_part.h"
#include "engine/scene/intensity.h"

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

Polygon corners_of(const OpeningSolid& solid) {
    constexpr double of_polygon = 1.004;  // round outlines of 32 sides and equal area
    Polygon corners;
    for (const double z : {-1.0, 1.0}) {
        for (const Vec2& xy : {Vec2{-1, -1}, Vec2{-1, 1}, Vec2{1, 1}, Vec2{1, -1}})
            corners.push_back(of_polygon * solid.half * Vec3{xy, z});
    }
    return corners;
}

}  // namespace

MeasuredSource::MeasuredSource(const Placement& placed, const Region& opening, Photometry photometry, double scale)
    : placed_(placed),
      pieces_(convex_pieces(opening)),
      extent_(placed.region(opening).outline),
      table_(std::move(photometry)),
      certificate_(table_.photometry(), form_of(pieces_)),
      scale_(scale),
      area_(glm::length(vector_area(opening))),
      dark_above_(is_dark_above(table_.photometry())),
      finest_beam_(finest_beam(table_.photometry())),
      greatest_error_(share_left_out_by_points * peak_intensity(table_.photometry()).value) {}

MeasuredSource::MeasuredSource(const Placement& placed, const OpeningSolid& opening, Photometry photometry,
                               double scale)
    : placed_(placed),
      solid_(opening),
      extent_(corners_of(opening)),
      table_(std::move(photometry)),
      certificate_(table_.photometry(), form_of(opening)),
      scale_(scale),
      dark_above_(is_dark_above(table_.photometry())),
      finest_beam_(finest_beam(table_.photometry())),
      greatest_error_(share_left_out_by_points * peak_intensity(table_.photometry()).value) {
    for (Vec3& corner : extent_) corner = placed.point(corner);
}

std::vector<Polygon> MeasuredSource::pieces() const {
    std::vector<Polygon> pieces = pieces_;
    for (Polygon& piece : pieces) {
        for (Vec3& corner : piece) corner = placed_.point(corner);
    }
    if (!solid_) return pieces;
    const Polygon& c = extent_;  // below, then above
    pieces = {{c[0], c[1], c[2], c[3]}, {c[7], c[6], c[5], c[4]}};
    for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t next = (k + 1) % 4;
        pieces.push_back({c[k], c[k + 4], c[next + 4], c[next]});
    }
    return pieces;
}

MeasuredSource::Sight MeasuredSource::sight_of(const Receiver& receiver) const {
    const Vec3& up = placed_.rotation[2];
    bool any_above = false, all_above = true, any_from_below = false;
    for (const Vec3& corner : extent_) {
        const Vec3 away = receiver.position - corner;
        const double height = -glm::dot(away, receiver.normal);
        any_above = any_above || height > 0.0;
        all_above = all_above && height >= 0.0;
        // The last angle itself still shines.
        any_from_below = any_from_below || glm::dot(away, up) <= 1e-9 * glm::length(away);
    }
    if (!any_above || (dark_above_ && !any_from_below)) return Sight::none;
    return all_above ? Sight::whole : Sight::partly;
}

std::optional<Estimate> MeasuredSource::as_point(const Receiver& receiver, const Accuracy& accuracy) const {
    constexpr double nearest = 4.0;  // radii; nearer than that no distribution is certified to a few percent
    const Vec3 away = receiver.position - certificate_.opening().centre;
    const double square = glm::dot(away, away);
    const double radius = certificate_.opening().radius;
    if (square < nearest * nearest * radius * radius) return std::nullopt;
    const double distance = std::sqrt(square);
    const double cosine = -glm::dot(away, receiver.normal) / distance;
    const double candela = table_.candela(away);
    const double allowed =
        std::max({greatest_error_, accuracy.share * candela * cosine, accuracy.floor * square / scale_});
    // What the inverse square law alone leaves out is soon known.
    const double ratio = certificate_.opening().mean_distance / distance;
    if (3.0 * ratio * ratio * candela > allowed) return std::nullopt;
    const double error = certificate_.error(away, distance, candela, cosine);
    if (!(error <= allowed)) return std::nullopt;
    return Estimate{scale_ * candela * cosine / square, scale_ * error / square};
}

double MeasuredSource::from_place(const Vec3& place, const Receiver& receiver) const {
    const Vec3 away = receiver.position - place;
    const double square = glm::dot(away, away), height = -glm::dot(away, receiver.normal);
    if (!(height > 0.0) || !(square > 0.0)) return 0.0;
    return scale_ * table_.candela(away * placed_.rotation) * height / (square * std::sqrt(square));
}

Estimate MeasuredSource::obstructed(const Receiver& receiver, const Obstacles& obstacles,
                                    const Accuracy& accuracy) const {
    const Sight sight = sight_of(receiver);
    if (sight == Sight::none) return {};
    thread_local std::vector<BodyIndex> others;
    obstacles.between(receiver.position, extent_, others);
    const Receiver local{(receiver.position - placed_.position) * placed_.rotation, receiver.normal * placed_.rotation,
                         Vec3{0.0}};
    if (sight == Sight::whole && others.empty()) {
        if (const auto point = as_point(local, accuracy)) return *point;
    }
    thread_local std::vector<Polygon> seen;
    if (solid_) seen_faces(*solid_, local.position, seen);
    OpeningIntegral integral(table_, solid_ ? &*solid_ : nullptr, local, finest_beam_);
    for (const Polygon& piece : solid_ ? seen : pieces_) {
        const Polygon risen = sight == Sight::whole ? piece : clipped(piece, {local.position, local.normal}, 0.0);
        if (risen.empty()) continue;
        if (others.empty()) {
            integral.add(risen);
            continue;
        }
        Polygon in_scene = risen;
        for (Vec3& corner : in_scene) corner = placed_.point(corner);
        for (Polygon& part : visible_part(in_scene, receiver.position, *obstacles.occluders, others)) {
            for (Vec3& corner : part) corner = (corner - placed_.position) * placed_.rotation;
            integral.add(part);
        }
    }
    const double scale = solid_ ? scale_ : scale_ / area_;
    const Estimate sum = integral.value({accuracy.share, accuracy.floor / scale});
    return {scale * sum.value, scale * sum.error};
}

}  // namespace hanei
