#include "engine/mesh/cells.h"

#include "engine/geometry/polygon.h"
#include "engine/mesh/pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hanei {

namespace {

/// q of the crowded grid. Linear elements in empty rooms err least with 2 (a fifth of the error of equal
/// cells beside edges); where furniture throws shadows amid the faces, the wider cells there cost more.
constexpr double crowding = 1.5;

/// Coordinates in the plane of a face.
struct FaceFrame {
    Vec3 origin{0.0};
    Vec3 along{0.0};
    Vec3 across{0.0};

    explicit FaceFrame(const Face& face)
        : origin(face.region.outline.front()), along(face.along), across(glm::cross(face.normal, face.along)) {}
    Vec2 flat(const Vec3& place) const { return {glm::dot(place - origin, along), glm::dot(place - origin, across)}; }
    Vec3 place(double u, double v) const { return origin + u * along + v * across; }
};

struct FlatBox {
    Vec2 low{std::numeric_limits<double>::infinity()};
    Vec2 high{-std::numeric_limits<double>::infinity()};

    FlatBox(const FaceFrame& frame, const Polygon& polygon) {
        for (const Vec3& place : polygon) {
            low = glm::min(low, frame.flat(place));
            high = glm::max(high, frame.flat(place));
        }
    }
    bool meets(const FlatBox& other) const {
        return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
    }
    /// For what may be a line, which has no width.
    bool reaches(const FlatBox& other) const {
        return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y;
    }
};

struct Cutter {
    Polygon outline;
    FlatBox box;
    ObjectId material;
};

std::vector<Cutter> cutters_of(const FaceFrame& frame, std::span<const Polygon> polygons) {
    std::vector<Cutter> cutters;
    for (const Polygon& polygon : polygons) cutters.push_back({polygon, FlatBox(frame, polygon), {}});
    return cutters;
}

double area_of(const Polygon& polygon) { return glm::length(vector_area(polygon)); }

/// The parts of a cell inside the face: the cell itself where it is wholly inside, also when the
/// face had to be cut into several pieces.
std::vector<Polygon> inside_face(const Polygon& cell, const FlatBox& box, const std::vector<Cutter>& pieces,
                                 const Vec3& normal, double thickness) {
    std::vector<Polygon> parts;
    double area = 0.0;
    for (const Cutter& piece : pieces) {
        if (!box.meets(piece.box)) continue;
        Polygon part = common_part(cell, piece.outline, normal, thickness);
        if (part.empty()) continue;
        area += area_of(part);
        parts.push_back(std::move(part));
    }
    // a corner cut off by less than this is narrower than the tolerance of a place
    if (area >= area_of(cell) - thickness * diameter(cell)) return {cell};
    return parts;
}

void take_away(std::vector<Polygon>& parts, const FlatBox& box, const std::vector<Cutter>& covers, double thickness) {
    for (const Cutter& cover : covers) {
        if (parts.empty()) return;
        if (!box.meets(cover.box)) continue;
        std::vector<Polygon> left;
        for (const Polygon& part : parts) {
            for (Polygon& piece : subtracted(part, cover.outline, thickness)) left.push_back(std::move(piece));
        }
        parts = std::move(left);
    }
}

/// True when more than `thickness` of the crease runs inside the convex polygon.
bool runs_inside(const Crease& crease, const Polygon& polygon, const Vec3& normal, double thickness) {
    const double length = glm::length(crease.to - crease.from);
    double enters = 0.0;
    double leaves = 1.0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 edge = polygon[(k + 1) % polygon.size()] - polygon[k];
        const Vec3 inward = glm::cross(normal, glm::normalize(edge));
        const double from = glm::dot(crease.from - polygon[k], inward);
        const double to = glm::dot(crease.to - polygon[k], inward);
        if (from <= thickness && to <= thickness) return false;
        if (from < 0.0) enters = std::max(enters, from / (from - to));
        if (to < 0.0) leaves = std::min(leaves, from / (from - to));
    }
    return (leaves - enters) * length > thickness;
}

struct FlatCrease {
    Crease crease;
    FlatBox box;
};

void split(std::vector<Polygon>& parts, const FlatBox& cell, const std::vector<FlatCrease>& creases, const Vec3& normal,
           double thickness) {
    for (const auto& [crease, box] : creases) {
        if (!box.reaches(cell)) continue;
        const Vec3 left = glm::cross(normal, glm::normalize(crease.to - crease.from));
        std::vector<Polygon> halves;
        for (Polygon& part : parts) {
            if (!runs_inside(crease, part, normal, thickness)) {
                halves.push_back(std::move(part));
                continue;
            }
            for (const Vec3& side : {left, -left}) {
                Polygon half = clipped(part, {crease.from, side}, thickness);
                if (!half.empty()) halves.push_back(std::move(half));
            }
        }
        parts = std::move(halves);
    }
}

/// Cuts cells along sub-areas, in their order: the later one is seen.
void give_materials(std::vector<Cell>& cells, const FlatBox& box, const std::vector<Cutter>& areas, double thickness) {
    for (const Cutter& area : areas) {
        if (!box.meets(area.box)) continue;
        std::vector<Cell> cut;
        for (Cell& cell : cells) {
            Polygon inside;
            std::vector<Polygon> outside = subtracted(cell.outline, area.outline, thickness, &inside);
            if (inside.empty()) {
                cut.push_back(std::move(cell));
                continue;
            }
            for (Polygon& part : outside) cut.push_back({std::move(part), cell.material});
            cut.push_back({std::move(inside), area.material});
        }
        cells = std::move(cut);
    }
}

}  // namespace

int patches_along(double side, double wished) {
    return std::max(1, static_cast<int>(std::floor(std::min(side / wished, 1e6) + 0.5)));
}

std::vector<double> grid_lines(double low, double high, double wished, Grading grading) {
    const int count = patches_along(high - low, wished);
    std::vector<double> lines;
    for (int k = 0; k <= count; ++k) {
        double share = static_cast<double>(k) / count;
        if (grading == Grading::crowded) {
            share = 2 * k <= count ? 0.5 * std::pow(2.0 * share, crowding)
                                   : 1.0 - 0.5 * std::pow(2.0 * (1.0 - share), crowding);
        }
        lines.push_back(low + (high - low) * share);
    }
    return lines;
}

std::vector<Cell> cells_of(const Face& face, std::span<const Polygon> covers, std::span<const Crease> creases,
                           double max_patch, Grading grading, double thickness) {
    const FaceFrame frame(face);
    const FlatBox whole(frame, face.region.outline);
    const std::vector<Cutter> pieces = cutters_of(frame, pieces_of(face.region, face.normal));
    const std::vector<Cutter> cuts = cutters_of(frame, covers);
    std::vector<Cutter> areas;
    for (const FaceArea& area : face.areas)
        areas.push_back({area.outline, FlatBox(frame, area.outline), area.material});

    std::vector<FlatCrease> lines;
    for (const Crease& crease : creases) {
        const FlatBox box(frame, {crease.from, crease.to});
        if (box.reaches(whole)) lines.push_back({crease, box});
    }
    const std::vector<double> u = grid_lines(whole.low.x, whole.high.x, max_patch, grading);
    const std::vector<double> v = grid_lines(whole.low.y, whole.high.y, max_patch, grading);

    std::vector<Cell> cells;
    for (std::size_t j = 0; j + 1 < v.size(); ++j) {
        for (std::size_t i = 0; i + 1 < u.size(); ++i) {
            const Polygon cell{frame.place(u[i], v[j]), frame.place(u[i + 1], v[j]), frame.place(u[i + 1], v[j + 1]),
                               frame.place(u[i], v[j + 1])};
            const FlatBox box(frame, cell);
            std::vector<Polygon> parts = inside_face(cell, box, pieces, face.normal, thickness);
            take_away(parts, box, cuts, thickness);
            split(parts, box, lines, face.normal, thickness);
            std::vector<Cell> cut;
            for (Polygon& part : parts) cut.push_back({std::move(part), face.material});
            give_materials(cut, box, areas, thickness);
            for (Cell& part : cut) cells.push_back(std::move(part));
        }
    }
    return cells;
}

}  // namespace hanei
