#include "engine/geometry/flat_faces.h"

#include "engine/geometry/coplanar_regions.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace hanei {
namespace {

/// Whether the middle one of three corners lies between the others.
bool is_straight(const Vec3& before, const Vec3& corner, const Vec3& after, double distance) {
    const Vec3 line = after - before;
    const double length = glm::length(line);
    if (!(length > 0.0)) return false;
    const double along = glm::dot(corner - before, line) / length;
    return along > 0.0 && along < length && glm::distance(before + line * (along / length), corner) <= distance;
}

/// Leaves straight corners out wherever all faces agree about them.
class Straightened {
public:
    Straightened(const std::vector<Vec3>& vertices, std::vector<FlatFace>& faces, double distance)
        : vertices_(vertices), distance_(distance) {
        for (FlatFace& face : faces) {
            loops_.push_back(&face.loop);
            for (std::vector<int>& hole : face.holes) loops_.push_back(&hole);
        }
        for (std::size_t k = 0; k < loops_.size(); ++k)
            for (const int vertex : *loops_[k]) users_[vertex].push_back(k);
    }

    void run() {
        for (const auto& [vertex, users] : users_)
            if (is_needless(vertex, users))
                for (const std::size_t k : users) loops_[k]->erase(place_in(k, vertex));
    }

private:
    std::vector<int>::iterator place_in(std::size_t loop, int vertex) {
        return std::find(loops_[loop]->begin(), loops_[loop]->end(), vertex);
    }

    bool is_needless(int vertex, const std::vector<std::size_t>& users) {
        int from = -1, to = -1;
        for (const std::size_t k : users) {
            const std::vector<int>& loop = *loops_[k];
            if (loop.size() <= 3) return false;
            const auto at = static_cast<std::size_t>(place_in(k, vertex) - loop.begin());
            const int before = loop[(at + loop.size() - 1) % loop.size()];
            const int after = loop[(at + 1) % loop.size()];
            if (k != users.front() && (before != to || after != from)) return false;
            from = before;
            to = after;
            const auto place = [&](int v) { return vertices_[static_cast<std::size_t>(v)]; };
            if (!is_straight(place(before), place(vertex), place(after), distance_)) return false;
        }
        return users.size() <= 2;
    }

    const std::vector<Vec3>& vertices_;
    double distance_;
    std::vector<std::vector<int>*> loops_;
    std::map<int, std::vector<std::size_t>> users_;
};

}  // namespace

Polygon polygon_of(const std::vector<Vec3>& vertices, const std::vector<int>& loop) {
    Polygon polygon;
    for (const int vertex : loop) polygon.push_back(vertices[static_cast<std::size_t>(vertex)]);
    return polygon;
}

std::vector<Vec2> flattened(const Polygon& polygon, const Vec3& normal) {
    const Vec3 start = std::abs(normal.x) < 0.9 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
    const Vec3 right = glm::normalize(start - glm::dot(start, normal) * normal);
    const Vec3 up = glm::cross(normal, right);
    std::vector<Vec2> flat;
    for (const Vec3& point : polygon)
        flat.emplace_back(glm::dot(point - polygon[0], right), glm::dot(point - polygon[0], up));
    return flat;
}

std::vector<FlatFace> flat_faces(const TriangleShell& shell, const FlatFaceRules& rules) {
    std::vector<FlatFace> faces;
    CoplanarRegions regions(shell, rules.keep_labels);
    while (const auto region = regions.next()) {
        std::vector<FlatFace> joined = rules.holes ? regions.with_holes(*region) : std::vector<FlatFace>{};
        if (joined.empty()) joined = regions.without_holes(*region);
        for (FlatFace& face : joined) faces.push_back(std::move(face));
    }
    std::vector<FlatFace> straight = faces;
    Straightened(shell.vertices, straight, rules.distance).run();
    const bool sound = std::all_of(straight.begin(), straight.end(),
                                   [&](const FlatFace& face) { return is_sound_face(shell.vertices, face); });
    return sound ? straight : faces;
}

}  // namespace hanei
