/// A convex body made ready for questions of visibility: planes, edges, bounds.
#pragma once

#include "engine/base/vector.h"

#include <vector>

namespace hanei {

struct ConvexBody;

/// Axis-aligned box.
struct Box {
    Vec3 low{0.0};
    Vec3 high{0.0};

    void include(const Vec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void include(const Box& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    Vec3 centre() const { return 0.5 * (low + high); }
    Vec3 half_size() const { return 0.5 * (high - low); }
};

/// A face's plane, its normal outward.
struct BodyFace {
    Vec3 point{0.0};
    Vec3 normal{0.0};
    double height(const Vec3& place) const { return glm::dot(place - point, normal); }
};

/// An edge as its left face (seen from outside) runs through it.
struct BodyEdge {
    static constexpr int no_face = -1;
    Vec3 from{0.0};
    Vec3 to{0.0};
    int left = no_face;
    int right = no_face;  ///< no_face: the body is open or flat there
};

/// Holds     faces with area only; neighbours in one plane stay two faces with an edge between.
struct BodyShape {
    Box box;
    std::vector<BodyFace> faces;
    std::vector<BodyEdge> edges;
    bool flat = false;  ///< one face, opaque from both sides

    /// `same_place`: distance under which vertices are one vertex, and a solid is flat.
    BodyShape(const ConvexBody& body, double same_place);
};

}  // namespace hanei
