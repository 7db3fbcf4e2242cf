#include "engine/transport/far_patches.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {

namespace {

/// What four points leave out goes with the fourth power of size over distance on a rectangle, with the
/// third where the area is skewed; what points of degree 5 leave out with the sixth.
constexpr double far_of_rectangle = 12.0;  ///< distance over the fourth root of the half sides' fourth powers
constexpr double far_of_others = 40.0;     ///< distance over the farthest corner
constexpr double near_of_rectangle = 6.5;  ///< distance over the sixth root of the half sides' sixth powers
constexpr double near_of_others = 5.0;
/// A patch that the horizon cuts by less than this share is above it: of the form factor that is 1e-8.
constexpr float not_by_rounding = 1.0F - 1e-4F;

struct FlatPoint {
    double x, y, weight;  ///< weights add up to 1
};

// Degree 5 on [-1, 1] x [-1, 1] (Radon 1948; Stroud's C2 5-1).
const std::array<FlatPoint, 7> on_square = [] {
    const double far = std::sqrt(14.0 / 15.0), x = std::sqrt(3.0 / 5.0), y = std::sqrt(1.0 / 3.0);
    const double edge = 5.0 / 63.0, corner = 5.0 / 36.0;
    return std::array<FlatPoint, 7>{{{0.0, 0.0, 2.0 / 7.0},
                                     {0.0, far, edge},
                                     {0.0, -far, edge},
                                     {x, y, corner},
                                     {x, -y, corner},
                                     {-x, y, corner},
                                     {-x, -y, corner}}};
}();

// Degree 5 on the triangle (Radon 1948), in shares of two of its corners.
constexpr std::array<FlatPoint, 7> on_triangle = {{{1.0 / 3.0, 1.0 / 3.0, 0.225},
                                                   {0.47014206410511509, 0.47014206410511509, 0.13239415278850618},
                                                   {0.47014206410511509, 0.05971587178976982, 0.13239415278850618},
                                                   {0.05971587178976982, 0.47014206410511509, 0.13239415278850618},
                                                   {0.10128650732345634, 0.10128650732345634, 0.12593918054482715},
                                                   {0.10128650732345634, 0.79742698535308732, 0.12593918054482715},
                                                   {0.79742698535308732, 0.10128650732345634, 0.12593918054482715}}};

double farthest_corner(const Polygon& outline, const Vec3& centre) {
    double farthest = 0.0;
    for (const Vec3& corner : outline) farthest = std::max(farthest, glm::length(corner - centre));
    return farthest;
}

}  // namespace

bool is_rectangle(const Polygon& outline) {
    if (outline.size() != 4) return false;
    const Vec3 a = outline[1] - outline[0], b = outline[3] - outline[0];
    const double size = std::max(glm::length(a), glm::length(b));
    return glm::length(outline[0] + a + b - outline[2]) <= 1e-9 * size &&
           std::abs(glm::dot(a, b)) <= 1e-9 * glm::length(a) * glm::length(b);
}

FarPatches::FarPatches(const Mesh& mesh, const MeshFace& face, Elements elements, std::span<const PatchFrame> frames)
    : along_(face.face.along),
      across_(glm::cross(face.face.normal, face.face.along)),
      front_(face.face.normal),
      linear_(elements == Elements::linear) {
    const std::size_t last = face.first_patch + face.patch_count;
    for (std::size_t p = face.first_patch; p < last; ++p) {
        origin_ += mesh.patches[p].centre / static_cast<double>(face.patch_count);
    }
    unit_ = 0.0;
    for (std::size_t p = face.first_patch; p < last; ++p) {
        unit_ = std::max(unit_, farthest_corner(mesh.patches[p].outline, origin_));
    }
    first_points_.push_back(0);
    points_.reserve(face.patch_count);
    if (linear_) node_weights_.reserve(face.patch_count);
    for (std::size_t p = face.first_patch; p < last; ++p) {
        add_patch(mesh.patches[p], frames[p]);
    }
}

float FarPatches::flat_u(const Vec3& place) const {
    return static_cast<float>(glm::dot(place - origin_, along_) / unit_);
}
float FarPatches::flat_v(const Vec3& place) const {
    return static_cast<float>(glm::dot(place - origin_, across_) / unit_);
}

void FarPatches::add_patch(const Patch& patch, const PatchFrame& frame) {
    const double weight = patch.area / (4.0 * std::numbers::pi * unit_ * unit_);
    weights_.insert(weights_.end(), linear_ ? 4 : 1, static_cast<float>(weight));
    for (unsigned k = 0; k < 4; ++k) {
        node_u_[linear_ ? 0 : k].push_back(flat_u(frame.node(k)));
        node_v_[linear_ ? 0 : k].push_back(flat_v(frame.node(k)));
    }
    centre_u_.push_back(flat_u(patch.centre));
    centre_v_.push_back(flat_v(patch.centre));
    double extent_u = 0.0, extent_v = 0.0;
    for (const Vec3& corner : patch.outline) {
        extent_u = std::max(extent_u, std::abs(glm::dot(corner - patch.centre, along_)));
        extent_v = std::max(extent_v, std::abs(glm::dot(corner - patch.centre, across_)));
    }
    extent_u_.push_back(static_cast<float>(extent_u / unit_));
    extent_v_.push_back(static_cast<float>(extent_v / unit_));

    const double size = farthest_corner(patch.outline, patch.centre) / unit_;
    double far = far_of_others * size, near = near_of_others * size;
    if (is_rectangle(patch.outline)) {
        const double a = std::sqrt(3.0) * glm::length(frame.along) / unit_;
        const double b = std::sqrt(3.0) * glm::length(frame.across) / unit_;
        far = far_of_rectangle * std::sqrt(std::sqrt(a * a * a * a + b * b * b * b));
        near = near_of_rectangle * std::sqrt(std::cbrt(a * a * a * a * a * a + b * b * b * b * b * b));
    }
    far_square_.push_back(static_cast<float>(far * far));
    near_square_.push_back(static_cast<float>(near * near));
    add_points(patch, frame);
}

void FarPatches::add_eight(const Vec3& spare) {
    EightPoints& eight = points_.emplace_back();
    eight.u.fill(flat_u(spare));
    eight.v.fill(flat_v(spare));
    if (linear_) node_weights_.emplace_back();
}

void FarPatches::add_points(const Patch& patch, const PatchFrame& frame) {
    if (is_rectangle(patch.outline)) {
        add_eight(patch.centre);
        const double half = std::sqrt(3.0);
        for (std::size_t k = 0; k < on_square.size(); ++k) {
            const FlatPoint& point = on_square[k];
            add_point(k, frame.place(half * point.x, half * point.y), patch.area * point.weight, frame);
        }
    } else {
        const Polygon& corners = patch.outline;
        for (std::size_t c = 2; c < corners.size(); ++c) {
            add_eight(patch.centre);
            const Vec3 a = corners[c - 1] - corners[0], b = corners[c] - corners[0];
            const double area = 0.5 * glm::length(glm::cross(a, b));
            for (std::size_t k = 0; k < on_triangle.size(); ++k) {
                const FlatPoint& point = on_triangle[k];
                add_point(k, corners[0] + point.x * a + point.y * b, area * point.weight, frame);
            }
        }
    }
    first_points_.push_back(static_cast<std::uint32_t>(points_.size()));
}

void FarPatches::add_point(std::size_t k, const Vec3& place, double area, const PatchFrame& frame) {
    EightPoints& eight = points_.back();
    eight.u[k] = flat_u(place);
    eight.v[k] = flat_v(place);
    const double weight = area / (std::numbers::pi * unit_ * unit_);
    eight.weights[k] = static_cast<float>(weight);
    if (!linear_) return;
    const Vec2 at = frame.coordinates(place);
    for (unsigned node = 0; node < 4; ++node) {
        const double x = node & 1U ? at.x : -at.x, y = node & 2U ? at.y : -at.y;
        node_weights_.back()[k][node] = static_cast<float>(0.25 * weight * (1.0 + x) * (1.0 + y));
    }
}

FlatReceiver FarPatches::flat(const Receiver& receiver) const {
    const auto normal = [&](const Vec3& axis) { return static_cast<float>(glm::dot(receiver.normal, axis)); };
    return {flat_u(receiver.position),
            flat_v(receiver.position),
            static_cast<float>(glm::dot(receiver.position - origin_, front_) / unit_),
            normal(along_),
            normal(across_),
            normal(front_)};
}

void FarPatches::write_far(const FlatReceiver& receiver, float* columns) const {
    if (linear_) {
        kernel_at_points(receiver, node_u_[0], node_v_[0], weights_, columns);
        return;
    }
    kernel_at_fours(receiver, {node_u_[0].data(), node_u_[1].data(), node_u_[2].data(), node_u_[3].data()},
                    {node_v_[0].data(), node_v_[1].data(), node_v_[2].data(), node_v_[3].data()}, weights_, columns);
}

bool FarPatches::may_be_cut(std::size_t patch, const FlatReceiver& receiver) const {
    const float up_u = receiver.normal_u * (centre_u_[patch] - receiver.u);
    const float up_v = receiver.normal_v * (centre_v_[patch] - receiver.v);
    const float rising = up_u + up_v - receiver.normal_height * receiver.height;
    const float extent =
        std::abs(receiver.normal_u) * extent_u_[patch] + std::abs(receiver.normal_v) * extent_v_[patch];
    return std::abs(rising) < not_by_rounding * extent;
}

std::size_t FarPatches::list_others(const FlatReceiver& receiver, bool horizon_cuts, std::uint32_t* list) const {
    std::size_t count = 0;
    for (std::size_t p = 0; p < patches(); ++p) {
        list[count] = static_cast<std::uint32_t>(p);
        const bool near = square_of_distance(p, receiver) < far_square_[p];
        count += near || (horizon_cuts && may_be_cut(p, receiver)) ? 1 : 0;
    }
    return count;
}

bool FarPatches::write_by_points(std::size_t patch, const FlatReceiver& receiver, bool horizon_cuts,
                                 float* columns) const {
    if (square_of_distance(patch, receiver) < near_square_[patch]) return false;
    if (horizon_cuts && may_be_cut(patch, receiver)) return false;
    const std::size_t first = first_points_[patch];
    const std::span<const EightPoints> points(&points_[first], first_points_[patch + 1] - first);
    if (linear_) {
        const std::array<float, 4> sums = kernel_sums(receiver, points, &node_weights_[first]);
        std::copy(sums.begin(), sums.end(), columns + 4 * patch);
    } else {
        columns[patch] = kernel_sum(receiver, points);
    }
    return true;
}

}  // namespace hanei
