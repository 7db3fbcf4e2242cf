#include "engine/geometry/hidden_region.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hanei {

namespace {

/// The plane through the eye and an edge that the front face left of it ends at.
HalfSpace silhouette_plane(const BodyEdge& edge, const Vec3& eye, bool left_is_front) {
    const Vec3 plane = glm::cross(edge.from - eye, edge.to - eye);
    return {left_is_front ? plane : -plane, 0.0, 0.0};
}

/// A flat body that the eye lies on: what it hides as the eye comes to it from `beside`.
Hides hidden_by_touched_sheet(const BodyShape& shape, const Vec3& eye, const Vec3& beside, double same_place,
                              std::vector<HalfSpace>& planes) {
    const BodyFace& face = shape.faces[0];
    const double rise = glm::dot(beside, face.normal);
    if (std::abs(rise) <= 1e-6 * glm::length(beside)) return Hides::nothing;
    const double front = rise > 0.0 ? 1.0 : -1.0;
    planes.push_back({front * face.normal, 0.0, same_place});
    for (const BodyEdge& edge : shape.edges) {
        const Vec3 run = edge.to - edge.from;
        const double inward = glm::dot(glm::cross(face.normal, run), eye - edge.from);
        const double touching = same_place * glm::length(run);
        if (inward < -touching) return Hides::nothing;  // beside the sheet: seen edge on
        if (inward <= touching) planes.push_back({front * glm::cross(run, beside), 0.0, 0.0});
    }
    return Hides::region;
}

Hides hidden_by_sheet(const BodyShape& shape, const Vec3& eye, const Vec3& beside, double same_place,
                      std::vector<HalfSpace>& planes) {
    const BodyFace& face = shape.faces[0];
    const double height = face.height(eye);
    if (std::abs(height) <= same_place) return hidden_by_touched_sheet(shape, eye, beside, same_place, planes);
    const double front = height > 0.0 ? 1.0 : -1.0;
    planes.push_back({front * face.normal, -front * height, same_place});
    for (const BodyEdge& edge : shape.edges) planes.push_back(silhouette_plane(edge, eye, height > 0.0));
    return Hides::region;
}

/// Where the eye stands towards each face; few enough for the stack in most bodies.
class Sides {
public:
    enum Side : signed char { behind, on, before };

    Sides(const BodyShape& shape, const Vec3& eye, double same_place) {
        if (shape.faces.size() > few_.size()) many_.resize(shape.faces.size());
        sides_ = many_.empty() ? few_.data() : many_.data();
        for (std::size_t k = 0; k < shape.faces.size(); ++k) {
            const double height = shape.faces[k].height(eye);
            sides_[k] = height > same_place ? before : height < -same_place ? behind : on;
            any_on_ = any_on_ || sides_[k] == on;
            any_before_ = any_before_ || sides_[k] == before;
        }
    }
    Side operator[](int face) const { return face == BodyEdge::no_face ? behind : sides_[face]; }
    bool any_on() const { return any_on_; }
    bool any_before() const { return any_before_; }

private:
    std::array<Side, 24> few_;
    std::vector<Side> many_;
    Side* sides_;
    bool any_on_ = false;
    bool any_before_ = false;
};

/// True when some sight line misses the ball around the box: few bodies fill as much of the view as an
/// opening, and most that do not are told by one product a corner.
bool looks_past_ball(const Box& box, const Vec3& eye, std::span<const Vec3> points) {
    const Vec3 centre = box.centre() - eye, half = box.half_size();
    const double tangent_square = glm::dot(centre, centre) - glm::dot(half, half);
    if (tangent_square <= 0.0) return false;
    return std::ranges::any_of(points, [&](const Vec3& point) {
        const Vec3 along = point - eye;
        const double near = glm::dot(along, centre);
        return near <= 0.0 || near * near < tangent_square * glm::dot(along, along);
    });
}

/// Every sight line runs deeper than `margin` through the solid before it ends.
bool solid_hides_all(const BodyShape& shape, const Vec3& eye, std::span<const Vec3> points, double margin) {
    return std::ranges::all_of(points, [&](const Vec3& point) {
        const Vec3 along = point - eye;
        double enters = 0.0, leaves = 1.0;
        for (const BodyFace& face : shape.faces) {
            const double start = face.height(eye) + margin;
            const double change = glm::dot(along, face.normal);
            if (start >= 0.0 && start + change >= 0.0) return false;
            if (change < 0.0) enters = std::max(enters, -start / change);
            if (change > 0.0) leaves = std::min(leaves, -start / change);
            if (enters >= leaves) return false;
        }
        return true;
    });
}

/// All points lie beyond the sheet, and inside the planes through the eye and its edges.
bool sheet_hides_all(const BodyShape& shape, const Vec3& eye, std::span<const Vec3> points, double margin) {
    const double height = shape.faces[0].height(eye);
    if (std::abs(height) <= margin) return false;
    const double front = height > 0.0 ? 1.0 : -1.0;
    const auto beyond = [&](const Vec3& point) { return front * shape.faces[0].height(point) < -margin; };
    if (!std::ranges::all_of(points, beyond)) return false;
    return std::ranges::all_of(shape.edges, [&](const BodyEdge& edge) {
        const HalfSpace plane = silhouette_plane(edge, eye, height > 0.0);
        const Vec3 size = glm::abs(plane.outward);
        const double slack = margin * (size.x + size.y + size.z);
        return std::ranges::all_of(points,
                                   [&](const Vec3& point) { return glm::dot(plane.outward, point - eye) < -slack; });
    });
}

}  // namespace

bool hides_all(const BodyShape& shape, const Vec3& eye, std::span<const Vec3> points, double margin) {
    if (shape.faces.empty() || looks_past_ball(shape.box, eye, points)) return false;
    return shape.flat ? sheet_hides_all(shape, eye, points, margin) : solid_hides_all(shape, eye, points, margin);
}

Hides hidden_region(const BodyShape& shape, const Vec3& eye, const Vec3& beside, double same_place,
                    std::vector<HalfSpace>& planes) {
    planes.clear();
    if (shape.faces.empty()) return Hides::nothing;
    if (shape.flat) return hidden_by_sheet(shape, eye, beside, same_place, planes);

    const Sides sides(shape, eye, same_place);
    if (!sides.any_before() && !sides.any_on()) return Hides::everything;
    for (int k = 0; k < static_cast<int>(shape.faces.size()); ++k) {
        const BodyFace& face = shape.faces[static_cast<std::size_t>(k)];
        // A plane through the eye bounds the body, hence what it hides.
        if (sides[k] == Sides::on) planes.push_back({face.normal, 0.0, same_place});
        if (sides[k] == Sides::before) planes.push_back({face.normal, -face.height(eye), same_place});
    }
    if (!sides.any_before()) return Hides::region;
    for (const BodyEdge& edge : shape.edges) {
        const Sides::Side left = sides[edge.left];
        const Sides::Side right = sides[edge.right];
        const bool ends_left = left == Sides::before && right == Sides::behind;
        const bool ends_right = right == Sides::before && left == Sides::behind;
        if (ends_left || ends_right) planes.push_back(silhouette_plane(edge, eye, ends_left));
    }
    return Hides::region;
}

}  // namespace hanei
