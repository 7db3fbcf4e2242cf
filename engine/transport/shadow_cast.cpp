#include "engine/transport/shadow_cast.h"

#include "engine/geometry/contour.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace hanei {

namespace {

/// A share nearer to 0 or 1 than this is rounding.
constexpr double sharp = 1e-6;

double size_of(const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

struct Extent {
    double low, high;
};

/// Heights of the face's corners.
Extent extent_of(const ShadedFace& face, const FlatLine& line) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t k = 0; k < face.corners.count; ++k) {
        const double height = line.height(face.corners.u[k], face.corners.v[k]);
        low = std::min(low, height);
        high = std::max(high, height);
    }
    return {low, high};
}

float snapped(double share) {
    if (share < sharp) return 0.0F;
    return share > 1.0 - sharp ? 1.0F : static_cast<float>(share);
}

}  // namespace

void ShadowCast::start(std::span<const Receiver> side_by_side) {
    receivers_.assign(side_by_side.begin(), side_by_side.end());
    shadows_.start(side_by_side);
}

bool ShadowCast::write(const ShadedFace& face, std::size_t receiver, std::span<const BodyIndex> bodies, float* row) {
    look_at(face, receivers_[receiver]);
    float* shares = row + face.layout->face->first_patch;
    const std::size_t count = face.size();
    if (cast_all(face, receiver, bodies)) {
        std::fill_n(shares, count, 0.0F);
        return true;
    }
    if (cast_count_ == 0) return false;
    mark_all(face, everywhere);
    for (std::uint32_t p = 0; p < count; ++p) {
        if (hidden_[p]) {
            shares[p] = 0.0F;
        } else if (first_cut_[p] != Cut::none) {
            shares[p] = share_of(face, p);
        }
    }
    return true;
}

void ShadowCast::rewrite(const ShadedFace& face, std::size_t receiver, std::span<const BodyIndex> bodies,
                         const ShadedPatches& patches, float* row) {
    look_at(face, receivers_[receiver]);
    float* shares = row + face.layout->face->first_patch;
    const bool all_hidden = cast_all(face, receiver, bodies);
    if (!all_hidden) mark_all(face, patches.bounds);
    for (std::uint32_t p = 0; p < face.size(); ++p) {
        if (!patches.flags[p]) continue;
        if (all_hidden || hidden_[p]) {
            shares[p] = 0.0F;
        } else {
            shares[p] = first_cut_[p] != Cut::none ? share_of(face, p) : 1.0F;
        }
    }
}

bool ShadowCast::find_shaded(const ShadedFace& face, std::size_t receiver, BodyShadows& shadows,
                             std::span<const BodyIndex> bodies, ShadedPatches& patches) {
    look_at(face, receivers_[receiver]);
    bool any = false;
    for (const BodyIndex body : bodies) {
        std::size_t unknown = none;
        const Shaded shaded = cast_on(face, shadows.of(receiver, body), cast_, unknown);
        if (shaded == Shaded::nothing) continue;
        if (shaded == Shaded::everything) {
            patches.flags.assign(face.size(), 1);
            patches.bounds = everywhere;
            return true;
        }
        const FlatBox shade = face.shade_of(cast_.lines);
        if (!any) patches.flags.assign(face.size(), 0);
        patches.bounds = any ? around(patches.bounds, shade) : shade;
        any = true;
        for_each_shaded(face, cast_.four, shade, [&](std::size_t patch, bool) { patches.flags[patch] = 1; });
    }
    return any;
}

void ShadowCast::mark_all(const ShadedFace& face, const FlatBox& within) {
    hidden_.assign(face.size(), 0);
    first_cut_.assign(face.size(), Cut::none);
    cuts_.clear();
    for (std::uint32_t k = 0; k < cast_count_; ++k) {
        for_each_shaded(face, casts_[k].four, common(face.shade_of(casts_[k].lines), within),
                        [&](std::size_t patch, bool crossed) { mark(patch, crossed, k); });
    }
}

void ShadowCast::mark(std::size_t patch, bool crossed, std::uint32_t cast) {
    if (hidden_[patch]) return;
    if (!crossed) {
        hidden_[patch] = 1;
    } else {
        cuts_.push_back({cast, first_cut_[patch]});
        first_cut_[patch] = static_cast<std::int32_t>(cuts_.size()) - 1;
    }
}

/// True when one of the shadows covers the face; else those that cross it are kept.
bool ShadowCast::cast_all(const ShadedFace& face, std::size_t receiver, std::span<const BodyIndex> bodies) {
    if (casts_.size() < bodies.size()) casts_.resize(bodies.size());
    if (misses_.size() != bodies.size()) misses_.assign(bodies.size(), 0);
    cast_count_ = 0;
    const auto cast = [&](std::size_t k) {
        return cast_on(face, shadows_.of(receiver, bodies[k]), casts_[cast_count_], misses_[k]);
    };
    if (likely_ < bodies.size() && cast(likely_) == Shaded::everything) return true;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const Shaded shaded = cast(k);
        if (shaded == Shaded::everything) {
            likely_ = k;
            return true;
        }
        if (shaded == Shaded::part) ++cast_count_;
    }
    return false;
}

void ShadowCast::look_at(const ShadedFace& face, const Receiver& receiver) {
    constexpr double relative_rounding = 1e-14;  // a hundred times that of a height
    receiver_ = receiver;
    to_face_ = face.origin - receiver.position;
    rounding_ = relative_rounding * (size_of(to_face_) + face.radius);
    view_.eye_u = -glm::dot(to_face_, face.along);
    view_.eye_v = -glm::dot(to_face_, face.across);
    view_.height = -glm::dot(to_face_, face.normal);
    view_.rise = glm::dot(to_face_, receiver.normal);
    view_.rise_u = glm::dot(face.along, receiver.normal);
    view_.rise_v = glm::dot(face.across, receiver.normal);
}

/// Where the plane meets the face; not normalised.
FlatLine ShadowCast::line_of(const ShadedFace& face, const HalfSpace& plane) const {
    return {glm::dot(plane.outward, face.along), glm::dot(plane.outward, face.across),
            glm::dot(plane.outward, to_face_) - plane.reach};
}

/// Keeps the planes of the shadow that cross the face; all must. The plane by which the body's shadow
/// missed it from the receiver before is asked first.
ShadowCast::Shaded ShadowCast::cast_on(const ShadedFace& face, const BodyShadows::Shadow& shadow, Cast& cast,
                                       std::size_t& misses) const {
    if (shadow.hides == Hides::everything) return Shaded::everything;
    if (shadow.hides == Hides::nothing) return Shaded::nothing;
    const auto slack_of = [&](const HalfSpace& plane) {
        return std::max(plane.slack, rounding_ * size_of(plane.outward));
    };
    if (misses < shadow.planes.size()) {
        const HalfSpace& plane = shadow.planes[misses];
        if (extent_of(face, line_of(face, plane)).low >= -slack_of(plane)) return Shaded::nothing;
    }
    cast.planes.clear();
    cast.lines.clear();
    cast.four.clear();
    for (std::size_t k = 0; k < shadow.planes.size(); ++k) {
        const HalfSpace& plane = shadow.planes[k];
        const FlatLine line = line_of(face, plane);
        const Extent extent = extent_of(face, line);
        const double slack = slack_of(plane);
        if (extent.low >= -slack) {
            misses = k;
            return Shaded::nothing;
        }
        if (extent.high <= slack) continue;
        const double scale = 1.0 / std::sqrt(line.a * line.a + line.b * line.b);
        cast.planes.push_back({plane.outward, plane.reach, slack});
        cast.lines.push_back({scale * line.a, scale * line.b, scale * line.c});
        cast.four.emplace_back(cast.lines.back());
    }
    return cast.lines.empty() ? Shaded::everything : Shaded::part;
}

float ShadowCast::share_of(const ShadedFace& face, std::uint32_t patch) {
    cutting_.clear();
    for (std::int32_t cut = first_cut_[patch]; cut != Cut::none; cut = cuts_[static_cast<std::size_t>(cut)].next) {
        cutting_.push_back(&casts_[cuts_[static_cast<std::size_t>(cut)].cast]);
    }
    float share = 1.0F;
    if (flat_share(face, patch, share)) return share;
    return exact_share(mesh_.patches[face.layout->face->first_patch + patch]);
}

/// False when the patch is too near, or has too many sides.
bool ShadowCast::flat_share(const ShadedFace& face, std::uint32_t patch, float& share) {
    const double radius = face.patch_radius[patch];
    const double square = view_.square_distance(face.middle_u(patch), face.middle_v(patch));
    if (radius * radius > FlatView::nearest * FlatView::nearest * square) return false;
    std::size_t sides = face.corner_count(patch) + 1;
    for (const Cast* cast : cutting_) sides += cast->lines.size();
    if (sides > FlatLoop::most) return false;

    const bool split_up = radius * radius > FlatView::near * FlatView::near * square;
    FlatLoop loop = face.loop(patch);
    bool below_horizon = false;
    for (std::size_t k = 0; k < loop.count; ++k) below_horizon |= view_.rise_at(loop.u[k], loop.v[k]) < 0.0;
    if (below_horizon) clip(loop, {-view_.rise_u, -view_.rise_v, -view_.rise});
    const double whole = view_.weight(loop, split_up);
    if (!(whole > 0.0)) return true;  // weighs nothing either way
    if (cutting_.size() == 1) {
        for (const FlatLine& line : cutting_.front()->lines) clip(loop, line);
        share = snapped(1.0 - view_.weight(loop, split_up) / whole);
    } else {
        share = snapped(visible_weight(loop, split_up) / whole);
    }
    return true;
}

/// Of what several shadows leave of a loop.
double ShadowCast::visible_weight(const FlatLoop& loop, bool split_up) {
    rest_.assign(1, loop);
    for (const Cast* cast : cutting_) {
        next_rest_.clear();
        for (const FlatLoop& piece : rest_) subtract(piece, *cast);
        rest_.swap(next_rest_);
    }
    double sum = 0.0;
    for (const FlatLoop& piece : rest_) sum += view_.weight(piece, split_up);
    return sum;
}

/// Adds to `next_rest_` what a shadow leaves of a piece.
void ShadowCast::subtract(const FlatLoop& piece, const Cast& cast) {
    crossing_.clear();
    for (const FlatLine& line : cast.lines) {
        bool any_inside = false, any_outside = false;
        for (std::size_t k = 0; k < piece.count; ++k) {
            const double height = line.height(piece.u[k], piece.v[k]);
            any_inside |= height < 0.0;
            any_outside |= height > 0.0;
        }
        if (!any_inside) return next_rest_.push_back(piece);
        if (any_outside) crossing_.push_back(&line);
    }
    const std::size_t before = next_rest_.size();
    FlatLoop left = piece, inside, outside;
    for (const FlatLine* line : crossing_) {
        split(left, *line, inside, outside);
        if (outside.count > 2) next_rest_.push_back(outside);
        left = inside;
        if (left.count > 2) continue;
        next_rest_.resize(before);  // none of the piece is in the shadow
        return next_rest_.push_back(piece);
    }
}

double ShadowCast::factor_of(std::span<const Vec3> loop) {
    if (loop.size() < 3) return 0.0;
    offsets_.clear();
    for (const Vec3& point : loop) offsets_.push_back(point - loop.front());
    return contour_factor({loop.front(), offsets_}, receiver_.normal);
}

/// Of what is left of the patch, by the contour formula.
float ShadowCast::exact_share(const Patch& patch) {
    loop_.clear();
    for (const Vec3& corner : patch.outline) loop_.push_back(corner - receiver_.position);
    const double whole = factor_of(loop_);
    if (!(whole > 0.0)) return 1.0F;  // weighs nothing either way
    pieces_.start(loop_);
    for (const Cast* cast : cutting_) pieces_.subtract(cast->planes);
    double visible = 0.0;
    for (std::size_t k = 0; k < pieces_.size(); ++k) visible += factor_of(pieces_[k]);
    return static_cast<float>(std::clamp(visible / whole, 0.0, 1.0));
}

}  // namespace hanei
