#include "ui/panels/choosing.h"
#include "ui/view/luminaire_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hanei {
namespace {

constexpr float caught = 3.0F;  // pixels around a point or a line that count as touched

/// A box of the screen.
struct Box {
    ImVec2 low, high;
    bool holds(ImVec2 at) const { return at.x >= low.x && at.x <= high.x && at.y >= low.y && at.y <= high.y; }
};

float cross(ImVec2 a, ImVec2 b, ImVec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// Of the whole of some places; one that turns neither way makes a line.
std::vector<ImVec2> hull_of(std::vector<ImVec2> places) {
    std::sort(places.begin(), places.end(), [](ImVec2 a, ImVec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::vector<ImVec2> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t kept = hull.size();
        for (const ImVec2 each : places) {
            while (hull.size() >= kept + 2 && cross(hull[hull.size() - 2], hull.back(), each) <= 0.0F) hull.pop_back();
            hull.push_back(each);
        }
        hull.pop_back();
        std::reverse(places.begin(), places.end());
    }
    if (hull.empty() && !places.empty()) hull.push_back(places.front());
    return hull;
}

/// Do the hull and the box part along any of their sides?
bool touches(const std::vector<ImVec2>& hull, const Box& box) {
    constexpr float far = std::numeric_limits<float>::max();
    ImVec2 low{far, far}, high{-far, -far};
    for (const ImVec2 each : hull) {
        low = {std::min(low.x, each.x), std::min(low.y, each.y)};
        high = {std::max(high.x, each.x), std::max(high.y, each.y)};
    }
    if (low.x - caught > box.high.x || high.x + caught < box.low.x) return false;
    if (low.y - caught > box.high.y || high.y + caught < box.low.y) return false;
    const ImVec2 corners[] = {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
    for (std::size_t k = 0; k < hull.size() && hull.size() > 2; ++k) {
        const ImVec2 a = hull[k], b = hull[(k + 1) % hull.size()];
        const float slack = caught * std::hypot(b.x - a.x, b.y - a.y);
        if (std::all_of(std::begin(corners), std::end(corners), [&](ImVec2 c) { return cross(a, b, c) < -slack; }))
            return false;
    }
    return true;
}

class Boxing {
public:
    Boxing(const Pane& pane, const Box& box, bool wholly) : pane_(pane), box_(box), wholly_(wholly) {}

    /// A convex piece of an object. Pieces behind the eye are never in the box.
    void piece(ObjectId id, const std::vector<Vec3>& corners) {
        std::vector<ImVec2> seen;
        for (const Vec3& corner : corners)
            if (const auto at = pane_.on_screen(corner)) seen.push_back(*at);
        if (found_.empty() || found_.back().object != id) found_.push_back({id, true, false});
        const bool whole = seen.size() == corners.size() &&
                           std::all_of(seen.begin(), seen.end(), [&](ImVec2 at) { return box_.holds(at); });
        found_.back().whole &= whole && !corners.empty();
        found_.back().touched |= !seen.empty() && touches(hull_of(std::move(seen)), box_);
    }

    ObjectIds objects() const {
        ObjectIds ids;
        for (const Found& found : found_)
            if (wholly_ ? found.whole : found.touched) ids.push_back(found.object);
        return ids;
    }

private:
    struct Found {
        ObjectId object;
        bool whole, touched;
    };
    const Pane& pane_;
    Box box_;
    bool wholly_;
    std::vector<Found> found_;
};

void pieces_of(const Luminaire& luminaire, const Scene& scene, Boxing& boxing) {
    const LuminaireShape shape = shape_of(luminaire, scene);
    for (const Polygon& polygon : shape.shining) boxing.piece(luminaire.id, polygon);
    if (shape.tube) boxing.piece(luminaire.id, {shape.tube->first, shape.tube->second});
    if (shape.point) boxing.piece(luminaire.id, {*shape.point});
    if (!shape.shining.empty() || shape.tube || shape.point) return;
    std::vector<Vec3> corners{luminaire.position};
    for (const auto& [from, to] : shape.outline) corners.insert(corners.end(), {from, to});
    boxing.piece(luminaire.id, corners);
}

}  // namespace

ObjectIds objects_in_box(const Scene& scene, const Pane& pane, ImVec2 from, ImVec2 to, bool with_points) {
    const Box box{{std::min(from.x, to.x), std::min(from.y, to.y)}, {std::max(from.x, to.x), std::max(from.y, to.y)}};
    Boxing boxing(pane, box, from.x <= to.x);
    for (const Shell& shell : shells_of(scene)) boxing.piece(shell.object, shell.vertices);
    for (const FreeSurface& surface : scene.surfaces) boxing.piece(surface.id, surface.region.outline);
    for (const Luminaire& luminaire : scene.luminaires) pieces_of(luminaire, scene, boxing);
    if (!with_points) return boxing.objects();
    for (const CalculationPoint& point : scene.points) boxing.piece(point.id, {point.position});
    for (const CalculationGrid& grid : scene.grids) {
        boxing.piece(grid.id, {grid.corner, grid.corner + grid.along, grid.corner + grid.along + grid.across,
                               grid.corner + grid.across});
    }
    return boxing.objects();
}

}  // namespace hanei
