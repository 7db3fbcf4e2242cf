#include "engine/direct/shadow_volume.h"

#include <algorithm>

namespace hanei {

namespace {

/// A body and a source, and the planes between them.
class Between {
public:
    Between(std::span<const Vec3> body, std::span<const Vec3> source, double same_place)
        : body_(body), source_(source), same_place_(same_place) {}

    /// Keeps the plane when the body is behind it and the source before it.
    void add(const Vec3& point, const Vec3& normal) {
        const Plane plane{point, normal};
        const auto behind = [&](const Vec3& place) { return plane.height(place) <= same_place_; };
        const auto before = [&](const Vec3& place) { return plane.height(place) >= -same_place_; };
        if (std::ranges::all_of(source_, before) && std::ranges::all_of(body_, behind)) planes.push_back(plane);
    }

    void add_through(const Vec3& from, const Vec3& to, const Vec3& corner) {
        const Vec3 across = glm::cross(to - from, corner - from);
        const double length = glm::length(across);
        if (!(length > same_place_ * glm::length(to - from))) return;  // on one line: no plane
        add(from, across / length);
        add(from, -across / length);
    }

    std::vector<Plane> planes;

private:
    std::span<const Vec3> body_, source_;
    double same_place_;
};

}  // namespace

std::vector<Plane> shadow_planes(const BodyShape& shape, std::span<const Vec3> vertices, std::span<const Vec3> source,
                                 double same_place) {
    Between between(vertices, source, same_place);
    for (const BodyFace& face : shape.faces) {
        between.add(face.point, face.normal);
        if (shape.flat) between.add(face.point, -face.normal);
    }
    for (const BodyEdge& edge : shape.edges) {
        for (const Vec3& corner : source) between.add_through(edge.from, edge.to, corner);
    }
    const std::size_t sides = source.size() < 3 ? source.size() - 1 : source.size();
    for (std::size_t k = 0; k < sides; ++k) {
        for (const Vec3& vertex : vertices) between.add_through(source[k], source[(k + 1) % source.size()], vertex);
    }
    return std::move(between.planes);
}

}  // namespace hanei
