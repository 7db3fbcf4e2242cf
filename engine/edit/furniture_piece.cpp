#include "engine/edit/furniture_piece.h"

#include <cmath>
#include <numbers>

namespace hanei {
namespace {

/// Sums of typed centimetres come out a few units of the last digit beside them: a picometre is neither
/// seen nor felt, and files stay readable.
double neat(double length) { return std::round(length * 1e12) / 1e12; }

constexpr double least = 1e-6;  // m: thinner than that there is nothing to see

}  // namespace

void Piece::box(int finish, const Vec3& low, const Vec3& high) {
    const Vec3 size = high - low;
    if (!(size.x > least && size.y > least && size.z > least)) return;
    ModelPart& made = parts_.emplace_back();
    made.finish = finish;
    made.part.shape = BoxShape{{neat(size.x), neat(size.y), neat(size.z)}};
    made.part.position = {neat(0.5 * (low.x + high.x)), neat(0.5 * (low.y + high.y)), neat(low.z)};
}

void Piece::solid(int finish, SolidShape shape) {
    for (Vec3& vertex : shape.vertices) vertex = {neat(vertex.x), neat(vertex.y), neat(vertex.z)};
    ModelPart& made = parts_.emplace_back();
    made.finish = finish;
    made.part.shape = std::move(shape);
}

void Piece::frustum(int finish, const std::vector<Vec2>& below, const std::vector<Vec2>& above, double low,
                    double high) {
    if (!(high - low > least)) return;
    const int count = static_cast<int>(below.size());
    SolidShape shape;
    for (const Vec2& corner : below) shape.vertices.emplace_back(corner, low);
    for (const Vec2& corner : above) shape.vertices.emplace_back(corner, high);
    std::vector<int> bottom, top;
    for (int k = 0; k < count; ++k) {
        bottom.push_back(count - 1 - k);
        top.push_back(count + k);
    }
    shape.faces = {bottom, top};
    for (int k = 0; k < count; ++k) {
        const int next = (k + 1) % count;
        shape.faces.push_back({k, next, count + next, count + k});
    }
    solid(finish, std::move(shape));
}

void Piece::prism(int finish, const std::vector<Vec2>& outline, double low, double high) {
    frustum(finish, outline, outline, low, high);
}

void Piece::disc(int finish, const Vec2& middle, double diameter, int sides, double low, double high) {
    if (diameter > least) prism(finish, regular_polygon(middle, diameter, sides), low, high);
}

void Piece::bar(int finish, const std::vector<Vec2>& outline, double low, double high) {
    if (!(high - low > least)) return;
    const int count = static_cast<int>(outline.size());
    SolidShape shape;
    for (const double x : {low, high})
        for (const Vec2& corner : outline) shape.vertices.emplace_back(x, corner.x, corner.y);
    std::vector<int> left, right;
    for (int k = 0; k < count; ++k) {
        left.push_back(count - 1 - k);
        right.push_back(count + k);
    }
    shape.faces = {left, right};
    for (int k = 0; k < count; ++k) {
        const int next = (k + 1) % count;
        shape.faces.push_back({k, next, count + next, count + k});
    }
    solid(finish, std::move(shape));
}

std::vector<Vec2> regular_polygon(const Vec2& middle, double diameter, int sides) {
    std::vector<Vec2> outline;
    for (int k = 0; k < sides; ++k) {
        // Half a side turned: an edge, not a corner, looks along each axis of a polygon of 4, 8, 12.
        const double angle = 2.0 * std::numbers::pi * (k + 0.5) / sides;
        outline.push_back(middle + 0.5 * diameter * Vec2{std::cos(angle), std::sin(angle)});
    }
    return outline;
}

}  // namespace hanei
