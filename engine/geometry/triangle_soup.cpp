#include "engine/geometry/triangle_soup.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <unordered_map>
#include <utility>

namespace hanei {
namespace {

using Place = std::array<std::int64_t, 3>;

struct PlaceHash {
    std::size_t operator()(const Place& cell) const {
        std::uint64_t hash = 0;
        for (const std::int64_t x : cell) hash = (hash ^ static_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15U;
        return static_cast<std::size_t>(hash ^ hash >> 29U);
    }
};

/// The vertices that stand for all others: the first of those that lie together.
class Representatives {
public:
    explicit Representatives(double distance) : distance_(distance) {}

    int of(const Vec3& vertex) {
        const Vec3 scaled = glm::floor(vertex / distance_);
        const Place home{static_cast<std::int64_t>(scaled.x), static_cast<std::int64_t>(scaled.y),
                         static_cast<std::int64_t>(scaled.z)};
        for (int k = 0; k < 27; ++k) {
            const auto cell = cells_.find({home[0] + k % 3 - 1, home[1] + k / 3 % 3 - 1, home[2] + k / 9 - 1});
            if (cell == cells_.end()) continue;
            for (const int known : cell->second)
                if (glm::distance(vertices[static_cast<std::size_t>(known)], vertex) <= distance_) return known;
        }
        const int number = static_cast<int>(vertices.size());
        vertices.push_back(vertex);
        cells_[home].push_back(number);
        return number;
    }

    std::vector<Vec3> vertices;

private:
    double distance_;
    std::unordered_map<Place, std::vector<int>, PlaceHash> cells_;
};

bool is_thin(const std::vector<Vec3>& vertices, const Triangle& triangle, double distance) {
    const auto& [a, b, c] = triangle.corner;
    if (a == b || b == c || c == a) return true;
    const auto side = [&](int from, int to) {
        return glm::distance(vertices[static_cast<std::size_t>(from)], vertices[static_cast<std::size_t>(to)]);
    };
    const double longest = std::max({side(a, b), side(b, c), side(c, a)});
    return 2.0 * glm::length(vector_area(vertices, triangle)) <= distance * longest;
}

/// The smallest number first; which way round is kept.
std::array<int, 3> rotated(std::array<int, 3> corner) {
    std::rotate(corner.begin(), std::min_element(corner.begin(), corner.end()), corner.end());
    return corner;
}

using Edge = std::pair<int, int>;

Edge edge_of(const Triangle& triangle, int k) {
    return {triangle.corner[static_cast<std::size_t>(k)], triangle.corner[static_cast<std::size_t>((k + 1) % 3)]};
}

/// Edges that one triangle alone has, the smaller vertex first; in order.
std::vector<Edge> open_edges(const std::vector<Triangle>& triangles) {
    std::vector<Edge> all;
    for (const Triangle& triangle : triangles)
        for (int k = 0; k < 3; ++k)
            all.emplace_back(std::minmax(edge_of(triangle, k).first, edge_of(triangle, k).second));
    std::sort(all.begin(), all.end());
    std::vector<Edge> open;
    for (std::size_t k = 0; k < all.size();) {
        std::size_t end = k;
        while (end < all.size() && all[end] == all[k]) ++end;
        if (end == k + 1) open.push_back(all[k]);
        k = end;
    }
    return open;
}

/// Vertices of open edges along x, to ask which of them lie on an edge.
class OpenVertices {
public:
    OpenVertices(const std::vector<Vec3>& vertices, const std::vector<Edge>& edges, double distance)
        : vertices_(vertices), distance_(distance) {
        for (const auto& [a, b] : edges) numbers_.insert(numbers_.end(), {a, b});
        const auto before = [&](int a, int b) { return std::pair{at(a).x, a} < std::pair{at(b).x, b}; };
        std::sort(numbers_.begin(), numbers_.end(), before);
        numbers_.erase(std::unique(numbers_.begin(), numbers_.end()), numbers_.end());
    }

    std::size_t count() const { return numbers_.size(); }

    /// From the edge's first vertex to its second.
    std::vector<int> on(const Edge& edge) const {
        const Vec3 a = at(edge.first), b = at(edge.second);
        const double length = glm::distance(a, b);
        const double low = std::min(a.x, b.x) - distance_, high = std::max(a.x, b.x) + distance_;
        const auto left = [&](int vertex, double x) { return at(vertex).x < x; };
        std::vector<std::pair<double, int>> found;
        for (auto k = std::lower_bound(numbers_.begin(), numbers_.end(), low, left);
             k != numbers_.end() && at(*k).x <= high; ++k) {
            const double along = glm::dot(at(*k) - a, b - a) / length;
            if (*k == edge.first || *k == edge.second || !(along > distance_ && along < length - distance_)) continue;
            if (glm::distance(a + (b - a) * (along / length), at(*k)) <= distance_) found.emplace_back(along, *k);
        }
        std::sort(found.begin(), found.end());
        std::vector<int> ordered;
        for (const auto& [along, vertex] : found) ordered.push_back(vertex);
        return ordered;
    }

private:
    const Vec3& at(int vertex) const { return vertices_[static_cast<std::size_t>(vertex)]; }

    const std::vector<Vec3>& vertices_;
    double distance_;
    std::vector<int> numbers_;
};

/// A triangle and the vertices on each of its edges, in the direction it runs.
struct Cut {
    Triangle triangle;
    std::array<std::vector<int>, 3> on;
};

void cut_up(Cut whole, std::vector<Triangle>& pieces) {
    std::vector<Cut> waiting{std::move(whole)};
    while (!waiting.empty()) {
        Cut cut = std::move(waiting.back());
        waiting.pop_back();
        std::size_t k = 0;
        while (k < 3 && cut.on[k].empty()) ++k;
        if (k == 3) {
            pieces.push_back(cut.triangle);
            continue;
        }
        const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
        const int middle = cut.on[k].front();
        Cut rest = cut;  // from the middle vertex on
        rest.triangle.corner[k] = middle;
        rest.on[k].erase(rest.on[k].begin());
        rest.on[last].clear();
        cut.triangle.corner[next] = middle;
        cut.on[k].clear();
        cut.on[next].clear();
        waiting.push_back(std::move(rest));
        waiting.push_back(std::move(cut));
    }
}

std::size_t cut_at_open_corners(TriangleSoup& soup, double distance) {
    constexpr std::size_t most = 20'000;
    const std::vector<Edge> edges = open_edges(soup.triangles);
    const OpenVertices corners(soup.vertices, edges, distance);
    if (corners.count() > most) return 0;
    const std::set<Edge> open(edges.begin(), edges.end());
    std::vector<Triangle> pieces;
    std::size_t split = 0;
    for (const Triangle& triangle : soup.triangles) {
        Cut cut{triangle, {}};
        for (int k = 0; k < 3; ++k) {
            const Edge edge = edge_of(triangle, k);
            if (open.count(std::minmax(edge.first, edge.second)) > 0)
                cut.on[static_cast<std::size_t>(k)] = corners.on(edge);
        }
        const std::size_t before = pieces.size();
        cut_up(std::move(cut), pieces);
        split += pieces.size() > before + 1 ? 1 : 0;
    }
    soup.triangles = std::move(pieces);
    return split;
}

}  // namespace

Vec3 vector_area(const std::vector<Vec3>& vertices, const Triangle& triangle) {
    const Vec3& a = vertices[static_cast<std::size_t>(triangle.corner[0])];
    const Vec3& b = vertices[static_cast<std::size_t>(triangle.corner[1])];
    const Vec3& c = vertices[static_cast<std::size_t>(triangle.corner[2])];
    return 0.5 * glm::cross(b - a, c - a);
}

SoupRepairs weld(TriangleSoup& soup, double distance) {
    SoupRepairs repairs;
    Representatives representatives(distance);
    std::vector<int> stands_for;
    for (const Vec3& vertex : soup.vertices) stands_for.push_back(representatives.of(vertex));
    soup.vertices = std::move(representatives.vertices);
    std::set<std::array<int, 3>> known;
    std::vector<Triangle> kept;
    for (Triangle triangle : soup.triangles) {
        for (int& corner : triangle.corner) corner = stands_for[static_cast<std::size_t>(corner)];
        if (is_thin(soup.vertices, triangle, distance))
            ++repairs.without_area;
        else if (!known.insert(rotated(triangle.corner)).second)
            ++repairs.repeated;
        else
            kept.push_back(triangle);
    }
    soup.triangles = std::move(kept);
    repairs.split = cut_at_open_corners(soup, distance);
    return repairs;
}

}  // namespace hanei
