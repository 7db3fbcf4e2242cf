#include "engine/transport/shaded_face.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hanei {

namespace {

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

FourLine::FourLine(const FlatLine& line)
    : a(all_four(static_cast<float>(line.a))),
      b(all_four(static_cast<float>(line.b))),
      c(all_four(static_cast<float>(line.c))),
      size_a(all_four(std::abs(a[0]))),
      size_b(all_four(std::abs(b[0]))) {}

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
        if (p % lanes == 0) groups.emplace_back();
        add_to_block(groups.size() - 1, box);
        Group& group = groups.back();
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

void ShadedFace::add_to_block(std::size_t group, const FlatBox& box) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const auto rounding = static_cast<float>(4e-7 * radius);
    if (group / lanes == blocks.size()) {
        const Four none{infinite, infinite, infinite, infinite};
        blocks.push_back({none, none, -none, -none});
    }
    Block& block = blocks.back();
    const std::size_t lane = group % lanes;
    block.low_u[lane] = std::min(block.low_u[lane], static_cast<float>(box.low_u) - rounding);
    block.low_v[lane] = std::min(block.low_v[lane], static_cast<float>(box.low_v) - rounding);
    block.high_u[lane] = std::max(block.high_u[lane], static_cast<float>(box.high_u) + rounding);
    block.high_v[lane] = std::max(block.high_v[lane], static_cast<float>(box.high_v) + rounding);
}

unsigned ShadedFace::reached(const Block& block, const FlatBox& shade) const {
    const auto low_u = static_cast<float>(shade.low_u), low_v = static_cast<float>(shade.low_v);
    const auto high_u = static_cast<float>(shade.high_u), high_v = static_cast<float>(shade.high_v);
    const FourFlags meets =
        (block.low_u <= high_u) & (block.high_u >= low_u) & (block.low_v <= high_v) & (block.high_v >= low_v);
    return static_cast<unsigned>(bits_of(meets));
}

FlatBox ShadedFace::shade_of(std::span<const FlatLine> lines) const {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    if (blocks.size() == 1 || corners.count + lines.size() > FlatLoop::most) return everywhere;
    FlatLoop shade = corners;
    for (const FlatLine& line : lines) clip(shade, line);
    FlatBox box{infinite, infinite, -infinite, -infinite};
    for (std::size_t k = 0; k < shade.count; ++k) {
        box = {std::min(box.low_u, shade.u[k]), std::min(box.low_v, shade.v[k]), std::max(box.high_u, shade.u[k]),
               std::max(box.high_v, shade.v[k])};
    }
    return box;
}

FlatLoop ShadedFace::loop(std::size_t patch) const {
    FlatLoop corners_of;
    for (std::size_t k = first[patch]; k < first[patch + 1]; ++k) corners_of.add(u[k], v[k]);
    return corners_of;
}

}  // namespace hanei
