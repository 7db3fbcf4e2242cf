#include "engine/direct/measured_opening.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {

namespace {

using std::numbers::pi;

constexpr int corners_a_turn = 32;

void box_faces(const OpeningSolid& box, const Vec3& eye, std::vector<Polygon>& faces) {
    const Vec3& h = box.half;
    if (eye.z < -h.z) faces.push_back({{-h.x, -h.y, -h.z}, {-h.x, h.y, -h.z}, {h.x, h.y, -h.z}, {h.x, -h.y, -h.z}});
    if (eye.z > h.z) faces.push_back({{-h.x, -h.y, h.z}, {h.x, -h.y, h.z}, {h.x, h.y, h.z}, {-h.x, h.y, h.z}});
    const auto side = [&](const Vec3& from, const Vec3& to, double height) {
        const Vec3 up{0.0, 0.0, height};
        if (height > 0.0) faces.push_back({from, to, to + up, from + up});
    };
    const Vec3 a{h.x, -h.y, -h.z}, b{h.x, h.y, -h.z}, c{-h.x, h.y, -h.z}, d{-h.x, -h.y, -h.z};
    if (eye.x > h.x) side(a, b, box.sides[0]);
    if (eye.y > h.y) side(b, c, box.sides[1]);
    if (eye.x < -h.x) side(c, d, box.sides[2]);
    if (eye.y < -h.y) side(d, a, box.sides[3]);
}

/// Corners of an arc of the unit circle between two angles, the ends on it and the others a little
/// outside, so that with the middle the polygon has the sector's area.
std::vector<Vec2> arc(double from, double to) {
    const int steps = std::max(3, static_cast<int>(std::ceil((to - from) / (2.0 * pi) * corners_a_turn)));
    const double step = (to - from) / steps;
    // Triangles from the middle: two with one corner moved out to r, the others with both:
    // 2 r + (steps - 2) r^2 = steps step / sin(step).
    const double inner = steps - 2.0, wanted = steps * step / std::sin(step);
    const double out = (std::sqrt(1.0 + inner * wanted) - 1.0) / inner;
    std::vector<Vec2> corners;
    for (int k = 0; k <= steps; ++k) {
        const double radius = k == 0 || k == steps ? 1.0 : out;
        corners.emplace_back(radius * std::cos(from + k * step), radius * std::sin(from + k * step));
    }
    return corners;
}

std::vector<Vec2> full_circle() {
    constexpr double step = 2.0 * pi / corners_a_turn;
    const double radius = std::sqrt(step / std::sin(step));
    std::vector<Vec2> corners;
    for (int k = 0; k < corners_a_turn; ++k)
        corners.emplace_back(radius * std::cos(k * step), radius * std::sin(k * step));
    return corners;
}

class CylinderSeen {
public:
    CylinderSeen(const OpeningSolid& cylinder, const Vec3& eye, std::vector<Polygon>& faces)
        : half_(cylinder.half), c_(cylinder.axis), a_((c_ + 1) % 3), b_((c_ + 2) % 3), faces_(faces) {
        const Vec2 across{eye[a_] / half_[a_], eye[b_] / half_[b_]};
        const double away = glm::length(across), along = eye[c_];
        constexpr double rounding = 1e-12;  // under it no arc is left
        if (away <= 1.0 + rounding) {       // before an end, or inside
            if (std::abs(along) > half_[c_]) end(full_circle(), along > 0.0);
            return;
        }
        const double towards = std::atan2(across.y, across.x), touching = std::acos(1.0 / away);
        for (const bool far_end : {false, true}) {
            const bool seen = far_end ? along > half_[c_] : along < -half_[c_];
            end(seen ? arc(towards + touching, towards - touching + 2.0 * pi)
                     : arc(towards - touching, towards + touching),
                far_end);
        }
        const Vec2 first{std::cos(towards - touching), std::sin(towards - touching)};
        const Vec2 last{std::cos(towards + touching), std::sin(towards + touching)};
        faces_.push_back({place(first, false), place(last, false), place(last, true), place(first, true)});
    }

private:
    Vec3 place(const Vec2& on_circle, bool far_end) const {
        Vec3 p{0.0};
        p[a_] = half_[a_] * on_circle.x;
        p[b_] = half_[b_] * on_circle.y;
        p[c_] = far_end ? half_[c_] : -half_[c_];
        return p;
    }
    void end(const std::vector<Vec2>& outline, bool far_end) {
        Polygon face;
        for (const Vec2& corner : outline) face.push_back(place(corner, far_end));
        faces_.push_back(std::move(face));
    }

    Vec3 half_;
    int c_, a_, b_;
    std::vector<Polygon>& faces_;
};

/// In the frame where it is the unit sphere sight touches a circle in a plane square to the eye.
void ellipsoid_face(const OpeningSolid& ellipsoid, const Vec3& eye, std::vector<Polygon>& faces) {
    const Vec3 scaled = eye / ellipsoid.half;
    const double away = glm::length(scaled);
    if (away <= 1.0) return;
    const Vec3 front = scaled / away;
    const Vec3 any = std::abs(front.z) < 0.7 ? Vec3{0.0, 0.0, 1.0} : Vec3{1.0, 0.0, 0.0};
    const Vec3 u = glm::normalize(glm::cross(any, front)), v = glm::cross(front, u);
    const double radius = std::sqrt(1.0 - 1.0 / (away * away));
    Polygon face;
    for (const Vec2& corner : full_circle())
        face.push_back(ellipsoid.half * (front / away + radius * (corner.x * u + corner.y * v)));
    faces.push_back(std::move(face));
}

}  // namespace

void seen_faces(const OpeningSolid& solid, const Vec3& eye, std::vector<Polygon>& faces) {
    faces.clear();
    switch (solid.kind) {
        case OpeningSolid::Kind::box:
            box_faces(solid, eye, faces);
            break;
        case OpeningSolid::Kind::cylinder:
            CylinderSeen(solid, eye, faces);
            break;
        case OpeningSolid::Kind::ellipsoid:
            ellipsoid_face(solid, eye, faces);
            break;
    }
}

}  // namespace hanei
