#include "engine/geometry/body_shape.h"

#include "engine/geometry/occluders.h"
#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

/// For every vertex the first vertex at its place.
std::vector<int> welded(const std::vector<Vec3>& vertices, double same_place) {
    std::vector<int> first(vertices.size());
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        first[k] = static_cast<int>(k);
        for (std::size_t j = 0; j < k; ++j) {
            const Vec3 apart = vertices[j] - vertices[k];
            if (glm::dot(apart, apart) > same_place * same_place) continue;
            first[k] = static_cast<int>(j);
            break;
        }
    }
    return first;
}

void outline_of(const ConvexBody& body, const std::vector<int>& face, Polygon& outline) {
    outline.clear();
    for (const int vertex : face) outline.push_back(body.vertices[static_cast<std::size_t>(vertex)]);
}

void add_face(BodyShape& shape, const ConvexBody& body, const std::vector<int>& first, BodyFace face,
              std::vector<int> loop, bool turn_round) {
    if (turn_round) {
        face.normal = -face.normal;
        std::ranges::reverse(loop);
    }
    const int number = static_cast<int>(shape.faces.size());
    shape.faces.push_back(face);
    for (int& vertex : loop) vertex = first[static_cast<std::size_t>(vertex)];
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const int a = loop[k];
        const int b = loop[(k + 1) % loop.size()];
        if (a == b) continue;
        const Vec3& from = body.vertices[static_cast<std::size_t>(a)];
        const Vec3& to = body.vertices[static_cast<std::size_t>(b)];
        const auto twin = std::ranges::find_if(shape.edges, [&](const BodyEdge& edge) {
            return edge.right == BodyEdge::no_face && edge.from == to && edge.to == from;
        });
        if (twin == shape.edges.end()) {
            shape.edges.push_back({from, to, number, BodyEdge::no_face});
        } else {
            twin->right = number;
        }
    }
}

bool is_thin(const std::vector<Vec3>& vertices, const BodyFace& face, double same_place) {
    return std::ranges::all_of(vertices, [&](const Vec3& v) { return std::abs(face.height(v)) <= same_place; });
}

}  // namespace

BodyShape::BodyShape(const ConvexBody& body, double same_place) {
    if (body.vertices.empty()) return;
    box = {body.vertices[0], body.vertices[0]};
    Vec3 middle{0.0};
    for (const Vec3& vertex : body.vertices) {
        box.include(vertex);
        middle += vertex / static_cast<double>(body.vertices.size());
    }
    const std::vector<int> first = welded(body.vertices, same_place);
    std::size_t corner_count = 0;
    for (const std::vector<int>& corners : body.faces) corner_count += corners.size();
    faces.reserve(body.faces.size());
    edges.reserve(corner_count / 2 + 1);  // every edge of a closed body is listed by two faces
    Polygon outline;
    for (const std::vector<int>& corners : body.faces) {
        outline_of(body, corners, outline);
        const BodyFace face{outline.empty() ? Vec3{0.0} : outline[0], unit_normal(outline)};
        if (face.normal == Vec3{0.0}) continue;
        flat = body.faces.size() == 1 || is_thin(body.vertices, face, same_place);
        if (flat) {  // one face of a solid without thickness stands for all
            faces.clear();
            edges.clear();
        }
        add_face(*this, body, first, face, corners, !flat && face.height(middle) > 0.0);
        if (flat) break;
    }
}

}  // namespace hanei
