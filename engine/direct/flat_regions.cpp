#include "engine/direct/flat_regions.h"

#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cmath>

namespace hanei {

namespace {

using namespace ClipperLib;

constexpr double grid_lines = 5e8;  // across a face: Clipper is at its fastest below 2^30
constexpr double margin = 0.1;      // borders of shadows that reach beyond the face lie outside it
constexpr double one_point = 2.0;   // grid lines: corners closer than this are one

Paths executed(Clipper& clipper, ClipType type) {
    Paths result;
    clipper.Execute(type, result, pftNonZero, pftNonZero);
    CleanPolygons(result, one_point);
    std::erase_if(result, [](const Path& path) { return path.size() < 3; });
    return result;
}

}  // namespace

FlatRegions::FlatRegions(const Face& face)
    : face_(face), origin_(face.region.outline[0]), x_(face.along), y_(glm::cross(face.normal, face.along)) {
    for (const Vec3& corner : face.region.outline) {
        const Vec2 at{glm::dot(corner - origin_, x_), glm::dot(corner - origin_, y_)};
        low_ = glm::min(low_, at);
        high_ = glm::max(high_, at);
    }
    scale_ = grid_lines / std::max(glm::length(high_ - low_), 1e-300);
}

Polygon FlatRegions::around() const {
    const Vec2 wider = margin * (high_ - low_) + Vec2(margin * glm::length(high_ - low_));
    const Vec2 low = low_ - wider, high = high_ + wider;
    const auto at = [&](double x, double y) { return origin_ + x * x_ + y * y_; };
    return {at(low.x, low.y), at(high.x, low.y), at(high.x, high.y), at(low.x, high.y)};
}

Path FlatRegions::flat(const Polygon& polygon) const {
    Path path;
    for (const Vec3& corner : polygon) {
        path.emplace_back(std::llround(scale_ * glm::dot(corner - origin_, x_)),
                          std::llround(scale_ * glm::dot(corner - origin_, y_)));
    }
    if (!Orientation(path)) ReversePath(path);
    return path;
}

Paths FlatRegions::face_without(std::span<const Polygon> covers) const {
    Clipper clipper;
    clipper.AddPath(flat(face_.region.outline), ptSubject, true);
    for (const Polygon& hole : face_.region.holes) clipper.AddPath(flat(hole), ptClip, true);
    const Polygon frame = around();  // beyond it Clipper's numbers could end
    for (Polygon cover : covers) {
        for (std::size_t k = 0; k < frame.size(); ++k) {
            const Vec3 side = frame[(k + 1) % frame.size()] - frame[k];
            cover = clipped(cover, {frame[k], glm::normalize(glm::cross(face_.normal, side))}, 0.0);
        }
        if (!cover.empty()) clipper.AddPath(flat(cover), ptClip, true);
    }
    return executed(clipper, ctDifference);
}

std::vector<Polygon> FlatRegions::in_space(const Paths& paths) const {
    std::vector<Polygon> polygons;
    for (const Path& path : paths) {
        Polygon& polygon = polygons.emplace_back();
        for (const IntPoint& at : path) {
            polygon.push_back(origin_ + (static_cast<double>(at.X) / scale_) * x_ +
                              (static_cast<double>(at.Y) / scale_) * y_);
        }
    }
    return polygons;
}

Paths united(const Paths& polygons) {
    Clipper clipper;
    clipper.AddPaths(polygons, ptSubject, true);
    return executed(clipper, ctUnion);
}

Paths common(const Paths& a, const Paths& b) {
    Clipper clipper;
    clipper.AddPaths(a, ptSubject, true);
    clipper.AddPaths(b, ptClip, true);
    return executed(clipper, ctIntersection);
}

Paths borders(const Paths& of, const Paths& within) {
    Clipper clipper;
    for (Path line : of) {
        line.push_back(line.front());
        clipper.AddPath(line, ptSubject, false);
    }
    clipper.AddPaths(within, ptClip, true);
    PolyTree found;
    clipper.Execute(ctIntersection, found, pftNonZero, pftNonZero);
    Paths lines;
    OpenPathsFromPolyTree(found, lines);
    return lines;
}

}  // namespace hanei
