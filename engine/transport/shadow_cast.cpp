#include "engine/transport/shadow_cast.h"

#include "engine/geometry/contour.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hanei {

void BodyShadows::start(const Receiver& receiver) {
    receiver_ = receiver;
    ++number_;
}

const BodyShadows::Shadow& BodyShadows::of(BodyIndex body) {
    Shadow& shadow = known_[body];
    if (shadow.made_for != number_) {
        shadow.hides = hidden_region(occluders_.shape(body), receiver_.position, receiver_.inward,
                                     occluders_.same_place(), shadow.planes);
        shadow.made_for = number_;
    }
    return shadow;
}

void ShadowCast::start(const Receiver& receiver) {
    receiver_ = receiver;
    shadows_.start(receiver);
}

void ShadowCast::write(const FaceLayout& layout, std::span<const BodyIndex> bodies, float* row) {
    const MeshFace& face = *layout.face;
    float* shares = row + face.first_patch;
    corners_.clear();
    farthest_ = 0.0;
    for (const Vec3& corner : layout.corners) {
        corners_.push_back(corner - receiver_.position);
        const Vec3 away = glm::abs(corners_.back());
        farthest_ = std::max({farthest_, away.x, away.y, away.z});
    }
    hidden_.assign(face.patch_count, 0);
    if (cutting_.size() < face.patch_count) cutting_.resize(face.patch_count);
    for (std::size_t p = 0; p < face.patch_count; ++p) cutting_[p].clear();
    if (casts_.size() < bodies.size()) casts_.resize(bodies.size());

    for (std::uint32_t k = 0; k < bodies.size(); ++k) {
        const Shaded shaded = region_on(shadows_.of(bodies[k]), casts_[k]);
        if (shaded == Shaded::everything) {
            std::fill_n(shares, face.patch_count, 0.0F);
            return;
        }
        if (shaded == Shaded::part) mark_patches(layout, k);
    }
    for (std::uint32_t p = 0; p < face.patch_count; ++p) {
        if (hidden_[p]) {
            shares[p] = 0.0F;
        } else if (!cutting_[p].empty()) {
            shares[p] = share_of(mesh_.patches[face.first_patch + p], cutting_[p]);
        }
    }
}

/// Below this a height over a plane through the receiver is rounding.
double ShadowCast::slack_of(const HalfSpace& plane) const {
    constexpr double relative_rounding = 1e-14;  // a hundred times that of a height
    const Vec3 size = glm::abs(plane.outward);
    return std::max(plane.slack, relative_rounding * farthest_ * (size.x + size.y + size.z));
}

/// Cuts the face down to the shadow, into `loop_`; keeps the planes that took part in it.
Shaded ShadowCast::region_on(const BodyShadows::Shadow& shadow, std::vector<HalfSpace>& crossing) {
    crossing.clear();
    if (shadow.hides == Hides::everything) return Shaded::everything;
    if (shadow.hides == Hides::nothing) return Shaded::nothing;
    for (const HalfSpace& plane : shadow.planes) {
        const double slack = slack_of(plane);
        double lowest = std::numeric_limits<double>::infinity();
        double highest = -lowest;
        for (const Vec3& corner : corners_) {
            const double height = glm::dot(plane.outward, corner) - plane.reach;
            lowest = std::min(lowest, height);
            highest = std::max(highest, height);
        }
        if (lowest >= -slack) return Shaded::nothing;
        if (highest > slack) crossing.push_back({plane.outward, plane.reach, slack});
    }
    if (crossing.empty()) return Shaded::everything;
    loop_ = corners_;
    for (const HalfSpace& plane : crossing) clip(plane);
    return loop_.size() < 3 ? Shaded::nothing : Shaded::part;
}

/// Keeps the part of `loop_` inside the plane.
void ShadowCast::clip(const HalfSpace& plane) {
    heights_.clear();
    bool any_outside = false;
    for (const Vec3& point : loop_) {
        heights_.push_back(glm::dot(plane.outward, point) - plane.reach);
        any_outside = any_outside || heights_.back() > 0.0;
    }
    if (!any_outside) return;
    clipped_.clear();
    for (std::size_t k = 0; k < loop_.size(); ++k) {
        const std::size_t next = k + 1 < loop_.size() ? k + 1 : 0;
        const double here = heights_[k], there = heights_[next];
        if (here <= 0.0) clipped_.push_back(loop_[k]);
        if ((here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0)) {
            clipped_.push_back(loop_[k] + here / (here - there) * (loop_[next] - loop_[k]));
        }
    }
    loop_.swap(clipped_);
}

void ShadowCast::mark_patches(const FaceLayout& layout, std::uint32_t cast) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const double eye_u = glm::dot(receiver_.position, layout.along);
    const double eye_v = glm::dot(receiver_.position, layout.across);
    FlatBox shade{infinite, infinite, -infinite, -infinite};
    for (const Vec3& point : loop_) {
        const double u = eye_u + glm::dot(point, layout.along);
        const double v = eye_v + glm::dot(point, layout.across);
        shade = {std::min(shade.low_u, u), std::min(shade.low_v, v), std::max(shade.high_u, u),
                 std::max(shade.high_v, v)};
    }
    shade = {shade.low_u - layout.same_place, shade.low_v - layout.same_place, shade.high_u + layout.same_place,
             shade.high_v + layout.same_place};
    for (std::uint32_t group = 0; group < layout.group_boxes.size(); ++group) {
        if (!layout.group_boxes[group].meets(shade)) continue;
        const std::uint32_t first = group * FaceLayout::group_size;
        const std::uint32_t last = std::min(first + FaceLayout::group_size, layout.face->patch_count);
        for (std::uint32_t p = first; p < last; ++p) {
            if (hidden_[p] || !layout.boxes[p].meets(shade)) continue;
            mark_patch(p, mesh_.patches[layout.face->first_patch + p].outline, cast);
        }
    }
}

void ShadowCast::mark_patch(std::uint32_t patch, const Polygon& outline, std::uint32_t cast) {
    bool inside = true;
    for (const HalfSpace& plane : casts_[cast]) {
        bool all_outside = true;
        for (const Vec3& corner : outline) {
            const double height = glm::dot(plane.outward, corner - receiver_.position) - plane.reach;
            all_outside = all_outside && height >= -plane.slack;
            inside = inside && height <= plane.slack;
            if (!all_outside && !inside) break;
        }
        if (all_outside) return;
    }
    if (inside) {
        hidden_[patch] = 1;
    } else {
        cutting_[patch].push_back(cast);
    }
}

double ShadowCast::factor_of(std::span<const Vec3> loop) {
    if (loop.size() < 3) return 0.0;
    offsets_.clear();
    for (const Vec3& point : loop) offsets_.push_back(point - loop.front());
    return contour_factor({loop.front(), offsets_}, receiver_.normal);
}

/// One shadow: its part of the patch is one convex polygon. Several: what is left of the patch.
float ShadowCast::share_of(const Patch& patch, std::span<const std::uint32_t> casts) {
    loop_.clear();
    for (const Vec3& corner : patch.outline) loop_.push_back(corner - receiver_.position);
    const double whole = factor_of(loop_);
    if (!(whole > 0.0)) return 1.0F;  // weighs nothing either way
    double visible = 0.0;
    if (casts.size() == 1) {
        for (const HalfSpace& plane : casts_[casts.front()]) clip(plane);
        visible = whole - factor_of(loop_);
    } else {
        pieces_.start(loop_);
        for (const std::uint32_t cast : casts) pieces_.subtract(casts_[cast]);
        for (std::size_t k = 0; k < pieces_.size(); ++k) visible += factor_of(pieces_[k]);
    }
    return static_cast<float>(std::clamp(visible / whole, 0.0, 1.0));
}

}  // namespace hanei
