#include "engine/edit/plan_shape.h"

#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace hanei {
namespace {

constexpr double same = 1e-6;   // m: nobody draws walls that short
constexpr double shared = 0.4;  // of the outer sides that the arms of an L, T or U take
constexpr double widest = 1e4;  // m

double across(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// The corner lies on the straight line between its neighbours.
bool is_straight(const Vec2& before, const Vec2& corner, const Vec2& after) {
    const Vec2 a = corner - before, b = after - corner;
    return std::abs(across(a, b)) <= same * (glm::length(a) + glm::length(b)) && glm::dot(a, b) > 0.0;
}

bool on_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 edge = b - a;
    const double length = glm::dot(edge, edge);
    const double along = length > 0.0 ? std::clamp(glm::dot(p - a, edge) / length, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + along * edge) <= same;
}

bool segments_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const double c_side = across(b - a, c - a), d_side = across(b - a, d - a);
    const double a_side = across(d - c, a - c), b_side = across(d - c, b - c);
    if (((c_side > 0.0) != (d_side > 0.0)) && ((a_side > 0.0) != (b_side > 0.0)) && c_side * d_side != 0.0) return true;
    return on_segment(a, c, d) || on_segment(b, c, d) || on_segment(c, a, b) || on_segment(d, a, b);
}

}  // namespace

bool plan_holds(const std::vector<Vec2>& plan, const Vec2& p) {
    bool inside = false;
    for (std::size_t k = 0; k < plan.size(); ++k) {
        const Vec2& a = plan[k];
        const Vec2& b = plan[(k + 1) % plan.size()];
        if (on_segment(p, a, b)) return true;
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

bool plan_holds(const std::vector<Vec2>& plan, const Vec2& low, const Vec2& high) {
    const Vec2 corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
    for (const Vec2& corner : corners)
        if (!plan_holds(plan, corner)) return false;
    // No corner of the plan, and no wall, may reach into the rectangle.
    const Vec2 inner_low = low + Vec2{same}, inner_high = high - Vec2{same};
    if (!(inner_low.x < inner_high.x && inner_low.y < inner_high.y)) return true;
    const Vec2 inner[] = {inner_low, {inner_high.x, inner_low.y}, inner_high, {inner_low.x, inner_high.y}};
    for (std::size_t k = 0; k < plan.size(); ++k) {
        const Vec2& a = plan[k];
        const Vec2& b = plan[(k + 1) % plan.size()];
        if (a.x > inner_low.x && a.x < inner_high.x && a.y > inner_low.y && a.y < inner_high.y) return false;
        for (int side = 0; side < 4; ++side)
            if (segments_meet(a, b, inner[side], inner[(side + 1) % 4])) return false;
    }
    return true;
}

Vec2 middle_of_plan(const std::vector<Vec2>& plan) {
    Polygon outline;
    for (const Vec2& corner : plan) outline.emplace_back(corner, 0.0);
    return outline.empty() ? Vec2{0.0} : Vec2(centroid(outline));
}

std::string fault_of_plan(const std::vector<Vec2>& corners) {
    for (const Vec2& corner : corners)
        if (!(std::abs(corner.x) <= widest && std::abs(corner.y) <= widest))
            return "A corner of the plan lies farther than 10 km away; bring it nearer.";
    const std::vector<Vec2> plan = tidy_plan(corners);
    if (plan.size() < 3) return "A plan needs three corners that are not on one line.";
    if (!is_simple(plan)) return "Walls cross or touch each other; draw an outline that does not meet itself.";
    if (std::abs(signed_area(plan)) < 1e-4) return "The plan has no area to stand on; move its corners apart.";
    return {};
}

std::vector<Vec2> tidy_plan(std::vector<Vec2> corners) {
    for (bool changed = true; changed && corners.size() > 2;) {
        changed = false;
        for (std::size_t k = 0; k < corners.size() && corners.size() > 2; ++k) {
            const Vec2& before = corners[(k + corners.size() - 1) % corners.size()];
            const Vec2& after = corners[(k + 1) % corners.size()];
            if (glm::distance(corners[k], after) > same && !is_straight(before, corners[k], after)) continue;
            corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(k));
            changed = true;
            break;
        }
    }
    if (corners.size() > 2 && signed_area(corners) < 0.0) std::reverse(corners.begin(), corners.end());
    return corners;
}

bool last_edge_crosses(const std::vector<Vec2>& line) {
    if (line.size() < 3) return false;
    const Vec2& from = line[line.size() - 2];
    const Vec2& to = line.back();
    if (on_segment(to, line[line.size() - 3], from)) return true;  // back along the wall before
    for (std::size_t k = 0; k + 3 < line.size(); ++k)
        if (segments_meet(line[k], line[k + 1], from, to)) return true;
    return false;
}

std::vector<Vec2> usual_plan(std::string_view shape, double length, double width) {
    const double x = shared * length, y = shared * width;
    if (shape == "box") return {{0.0, 0.0}, {length, 0.0}, {length, width}, {0.0, width}};
    if (shape == "L") return {{0.0, 0.0}, {length, 0.0}, {length, y}, {x, y}, {x, width}, {0.0, width}};
    if (shape == "T") {
        const double left = 0.5 * (length - x), right = left + x, bar = width - y;
        return {{left, 0.0},     {right, 0.0}, {right, bar}, {length, bar},
                {length, width}, {0.0, width}, {0.0, bar},   {left, bar}};
    }
    if (shape == "U") {
        const double arm = 0.3 * length;
        return {{0.0, 0.0},        {length, 0.0}, {length, width}, {length - arm, width},
                {length - arm, y}, {arm, y},      {arm, width},    {0.0, width}};
    }
    return {};
}

std::vector<Vec2> plan_of_text(const std::string& text) {
    std::istringstream words(text);
    std::vector<Vec2> plan;
    for (std::string word; words >> word;) {
        std::istringstream pair(word);
        Vec2 corner{0.0};
        char comma = ' ';
        if (!(pair >> corner.x >> comma >> corner.y) || comma != ',' || pair.peek() != EOF) return {};
        plan.push_back(corner);
    }
    return plan;
}

}  // namespace hanei
