#include "engine/transport/shaded_face.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

FlatBox around(const FlatBox& a, const FlatBox& b) {
    return {std::min(a.low_u, b.low_u), std::min(a.low_v, b.low_v), std::max(a.high_u, b.high_u),
            std::max(a.high_v, b.high_v)};
}

FlatBox box_of(std::span<const double> u, std::span<const double> v) {
    const auto [low_u, high_u] = std::ranges::minmax(u);
    const auto [low_v, high_v] = std::ranges::minmax(v);
    return {low_u, low_v, high_u, high_v};
}

FlatLoop rectangle(const FlatBox& box) {
    FlatLoop loop;
    loop.add(box.low_u, box.low_v);
    loop.add(box.high_u, box.low_v);
    loop.add(box.high_u, box.high_v);
    loop.add(box.low_u, box.high_v);
    return loop;
}

/// What floats may take for a touch. A patch less than a thousandth of the face wide would lose a share
/// that shows: it crosses every line that comes near.
float slack_of(const FlatBox& box, double radius) {
    constexpr double rounding = 4e-7, narrow = 1e-3;
    const double width = std::min(box.high_u - box.low_u, box.high_v - box.low_v);
    return static_cast<float>((width < narrow * radius ? -rounding : rounding) * radius);
}

}  // namespace

ShadedFace::ShadedFace(const Mesh& mesh, const FaceLayout& of)
    : layout(&of), along(of.along), across(of.across), normal(of.face->face.normal) {
    for (const Vec3& corner : of.corners) origin += corner / static_cast<double>(of.corners.size());
    std::vector<double> corner_u, corner_v;
    for (const Vec3& corner : of.corners) {
        corner_u.push_back(glm::dot(corner - origin, along));
        corner_v.push_back(glm::dot(corner - origin, across));
        radius = std::max(radius, std::hypot(corner_u.back(), corner_v.back()));
    }
    corners = rectangle(box_of(corner_u, corner_v));
    if (corner_u.size() <= most_corners) {
        corners.count = 0;
        for (std::size_t k = 0; k < corner_u.size(); ++k) corners.add(corner_u[k], corner_v[k]);
    }
    first.push_back(0);
    for (std::uint32_t p = 0; p < of.face->patch_count; ++p) {
        for (const Vec3& corner : mesh.patches[of.face->first_patch + p].outline) {
            u.push_back(glm::dot(corner - origin, along));
            v.push_back(glm::dot(corner - origin, across));
        }
        const std::size_t begin = first.back(), count = u.size() - begin;
        first.push_back(static_cast<std::uint32_t>(u.size()));
        const FlatBox box = box_of(std::span(u).subspan(begin, count), std::span(v).subspan(begin, count));
        if (p % lanes == 0) groups.emplace_back().box = box;
        Group& group = groups.back();
        group.box = around(group.box, box);
        for (std::size_t lane = p % lanes; lane < lanes; ++lane) {
            group.u[lane] = static_cast<float>(0.5 * (box.low_u + box.high_u));
            group.v[lane] = static_cast<float>(0.5 * (box.low_v + box.high_v));
            group.half_u[lane] = static_cast<float>(0.5 * (box.high_u - box.low_u));
            group.half_v[lane] = static_cast<float>(0.5 * (box.high_v - box.low_v));
            group.slack[lane] = slack_of(box, radius);
        }
        patch_radius.push_back(std::hypot(group.half_u[p % lanes], group.half_v[p % lanes]));
    }
}

FlatLoop ShadedFace::loop(std::size_t patch) const {
    FlatLoop corners_of;
    for (std::size_t k = first[patch]; k < first[patch + 1]; ++k) corners_of.add(u[k], v[k]);
    return corners_of;
}

}  // namespace hanei
