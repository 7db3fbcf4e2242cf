#include "engine/base/tolerance.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/faces.h"
#include "engine/scene/scene_findings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace hanei {
namespace {

/// A convex solid with what a separating plane can be made of.
struct Body {
    const Solid* solid = nullptr;
    Bounds bounds;
    std::vector<Vec3> normals;  ///< of faces, opposite ones once
    std::vector<Vec3> edges;    ///< unit directions, parallel ones once
};

void add_direction(std::vector<Vec3>& directions, const Vec3& direction) {
    const double length = glm::length(direction);
    if (!(length > 0.0)) return;
    const Vec3 unit = direction / length;
    const bool known = std::any_of(directions.begin(), directions.end(), [&](const Vec3& other) {
        return std::abs(glm::dot(other, unit)) > 1.0 - tolerance::parallel;
    });
    if (!known) directions.push_back(unit);
}

Body body_of(const Solid& solid) {
    Body body{&solid, {solid.vertices[0], solid.vertices[0]}, {}, {}};
    for (const Vec3& vertex : solid.vertices) {
        body.bounds.low = glm::min(body.bounds.low, vertex);
        body.bounds.high = glm::max(body.bounds.high, vertex);
    }
    for (const std::vector<int>& face : solid.faces) {
        Polygon loop;
        for (const int vertex : face) loop.push_back(solid.vertices[static_cast<std::size_t>(vertex)]);
        add_direction(body.normals, unit_normal(loop));
        for (std::size_t k = 0; k < loop.size(); ++k) add_direction(body.edges, loop[(k + 1) % loop.size()] - loop[k]);
    }
    return body;
}

/// How far the bodies' shadows on an axis lie one over the other; negative when apart.
double overlap_along(const Body& a, const Body& b, const Vec3& axis) {
    const auto span = [&](const Body& body) {
        double low = HUGE_VAL;
        double high = -HUGE_VAL;
        for (const Vec3& vertex : body.solid->vertices) {
            const double at = glm::dot(vertex - a.solid->vertices[0], axis);
            low = std::min(low, at);
            high = std::max(high, at);
        }
        return std::pair{low, high};
    };
    const auto [low_a, high_a] = span(a);
    const auto [low_b, high_b] = span(b);
    return std::min(high_a - low_b, high_b - low_a);
}

/// How deep one convex body reaches into the other; 0 or less when a plane parts them.
double penetration(const Body& a, const Body& b) {
    std::vector<Vec3> axes = a.normals;
    axes.insert(axes.end(), b.normals.begin(), b.normals.end());
    for (const Vec3& edge_a : a.edges)
        for (const Vec3& edge_b : b.edges) {
            const Vec3 across = glm::cross(edge_a, edge_b);
            if (glm::dot(across, across) > tolerance::parallel) axes.push_back(glm::normalize(across));
        }
    double least = HUGE_VAL;
    for (const Vec3& axis : axes) {
        least = std::min(least, overlap_along(a, b, axis));
        if (least <= 0.0) break;
    }
    return least;
}

bool may_touch(const Bounds& a, const Bounds& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y && a.low.z < b.high.z &&
           b.low.z < a.high.z;
}

using Pair = std::pair<ObjectId, ObjectId>;

std::map<Pair, double> overlaps_of(const Scene& scene) {
    const std::vector<Solid> solids = solids_of(scene);
    const double thickness = tolerance::planar * bounds_of(scene).diameter();
    std::vector<Body> bodies;
    for (const Solid& solid : solids) bodies.push_back(body_of(solid));
    std::stable_sort(bodies.begin(), bodies.end(),
                     [](const Body& a, const Body& b) { return a.bounds.low.x < b.bounds.low.x; });
    std::map<Pair, double> deepest;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t k = i + 1; k < bodies.size() && bodies[k].bounds.low.x < bodies[i].bounds.high.x; ++k) {
            if (!may_touch(bodies[i].bounds, bodies[k].bounds)) continue;
            const double depth = penetration(bodies[i], bodies[k]);
            if (depth <= thickness) continue;
            const auto [first, second] = std::minmax(bodies[i].solid->object, bodies[k].solid->object);
            double& known = deepest[{first, second}];
            known = std::max(known, depth);
        }
    return deepest;
}

}  // namespace

void check_overlaps(SceneChecks& checks) {
    std::map<ObjectId, std::size_t> index;
    for (std::size_t i = 0; i < checks.scene.furniture.size(); ++i) index[checks.scene.furniture[i].id] = i;
    for (const auto& [pair, depth] : overlaps_of(checks.scene)) {
        const std::size_t second = index.at(pair.second);
        const Furniture& furniture = checks.scene.furniture[second];
        ObjectFindings object = checks.about("furniture", second, "furniture", furniture.name, furniture.id);
        const std::string depth_text = figure(depth) + " m deep";
        const std::string& other = checks.scene.furniture[index.at(pair.first)].name;
        if (pair.first == pair.second)
            object.warn("parts", "two of its parts share space, " + depth_text + "; let them touch only");
        else
            object.warn("position", "it shares space with \"" + other + "\", " + depth_text + "; move one of them");
    }
}

}  // namespace hanei
