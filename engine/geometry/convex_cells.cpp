#include "engine/geometry/convex_cells.h"

#include "engine/base/stoppable.h"
#include "engine/base/tolerance.h"
#include "engine/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hanei {

namespace {

/// A convex piece of a face, in the plane of the whole face.
struct Facet {
    Polygon outline;
    Plane plane;
    int face = 0;
};

/// A convex part of space.
using Hull = std::vector<Polygon>;

Polygon loop_of(const std::vector<Vec3>& vertices, const std::vector<int>& face) {
    Polygon loop;
    for (const int vertex : face) loop.push_back(vertices[static_cast<std::size_t>(vertex)]);
    return loop;
}

struct Heights {
    double low = std::numeric_limits<double>::infinity(), high = -low;
};

Heights heights_over(const Plane& plane, const Polygon& points) {
    Heights heights;
    for (const Vec3& point : points) {
        heights.low = std::min(heights.low, plane.height(point));
        heights.high = std::max(heights.high, plane.height(point));
    }
    return heights;
}

Hull box_around(const std::vector<Vec3>& points) {
    Vec3 a = points[0], b = points[0];
    for (const Vec3& point : points) a = glm::min(a, point), b = glm::max(b, point);
    return {{{a.x, a.y, a.z}, {a.x, b.y, a.z}, {b.x, b.y, a.z}, {b.x, a.y, a.z}},
            {{a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}},
            {{a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, a.y, b.z}, {a.x, a.y, b.z}},
            {{a.x, b.y, a.z}, {a.x, b.y, b.z}, {b.x, b.y, b.z}, {b.x, b.y, a.z}},
            {{a.x, a.y, a.z}, {a.x, a.y, b.z}, {a.x, b.y, b.z}, {a.x, b.y, a.z}},
            {{b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}, {b.x, a.y, b.z}}};
}

double volume_of(const Hull& hull) {
    double volume = 0.0;
    for (const Polygon& face : hull) volume += glm::dot(face[0] - hull[0][0], vector_area(face)) / 3.0;
    return volume;
}

Vec3 middle_of(const Hull& hull) {
    Vec3 sum{0.0};
    double count = 0.0;
    for (const Polygon& face : hull) {
        for (const Vec3& point : face) sum += point, count += 1.0;
    }
    return sum / count;
}

class Partition {
public:
    Partition(const std::vector<Vec3>& vertices, const std::vector<std::vector<int>>& faces)
        : thickness_(tolerance::planar * diameter(vertices)) {
        for (std::size_t f = 0; f < faces.size(); ++f) {
            const Polygon loop = loop_of(vertices, faces[f]);
            const Vec3 normal = unit_normal(loop);
            if (normal == Vec3{0.0}) continue;
            for (Polygon& piece : convex_pieces({loop, {}})) {
                facets_.push_back({std::move(piece), {loop[0], normal}, static_cast<int>(f)});
            }
            volume_ += glm::dot(loop[0] - vertices[0], vector_area(loop)) / 3.0;
        }
        split(box_around(vertices), facets_);
    }

    std::vector<ConvexCell> cells() const {
        double filled = 0.0;
        for (const Hull& hull : hulls_) filled += volume_of(hull);
        if (hulls_.size() > most_convex_cells || !(std::abs(filled - volume_) <= 1e-5 * std::abs(volume_))) return {};
        std::vector<ConvexCell> cells;
        for (const Hull& hull : hulls_) cells.push_back(cell_of(hull));
        return cells;
    }

private:
    /// Parts the hull by the planes of the facets inside it, which are dropped when they lie on its skin.
    void split(Hull hull, std::vector<Facet> inside) {
        if (hulls_.size() > most_convex_cells) return;
        std::erase_if(inside, [&](const Facet& facet) { return lies_on_skin(hull, facet); });
        if (inside.empty()) {
            if (is_solid_around(middle_of(hull))) hulls_.push_back(std::move(hull));
            return;
        }
        const Plane plane = best_plane(inside);
        const Plane back{plane.point, -plane.normal};
        std::vector<Facet> in_front, behind;
        for (const Facet& facet : inside) {
            add_clipped(facet, plane, in_front);
            add_clipped(facet, back, behind);
        }
        Hull front_hull = clipped_hull(hull, plane), back_hull = clipped_hull(hull, back);
        if (front_hull.size() < 4 || back_hull.size() < 4) return;  // no progress: the volume will tell
        split(std::move(front_hull), std::move(in_front));
        split(std::move(back_hull), std::move(behind));
    }

    bool lies_on_skin(const Hull& hull, const Facet& facet) const {
        return std::ranges::any_of(hull, [&](const Polygon& face) {
            const Heights heights = heights_over({face[0], unit_normal(face)}, facet.outline);
            return heights.low >= -thickness_;
        });
    }

    /// The plane that cuts the fewest facets; of those, the one with the most facets in it.
    Plane best_plane(const std::vector<Facet>& inside) const {
        const Facet* best = nullptr;
        std::ptrdiff_t best_cost = 0;
        for (const Facet& candidate : inside) {
            stop_if_wished();
            std::ptrdiff_t cost = 0;
            for (const Facet& facet : inside) {
                const Heights heights = heights_over(candidate.plane, facet.outline);
                const bool above = heights.high > thickness_, below = heights.low < -thickness_;
                cost += above && below ? 8 : above || below ? 0 : -1;
            }
            if (best == nullptr || cost < best_cost) best = &candidate, best_cost = cost;
        }
        return best->plane;
    }

    void add_clipped(const Facet& facet, const Plane& plane, std::vector<Facet>& to) const {
        Polygon kept = clipped(facet.outline, plane, thickness_);
        if (!kept.empty()) to.push_back({std::move(kept), facet.plane, facet.face});
    }

    /// What of the hull lies in front of the plane, with a face in the plane.
    Hull clipped_hull(const Hull& hull, const Plane& plane) const {
        Hull kept;
        for (const Polygon& face : hull) {
            Polygon part = clipped(face, plane, thickness_);
            if (!part.empty()) kept.push_back(std::move(part));
        }
        const Vec3 helper = std::abs(plane.normal.x) < 0.7 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
        const Vec3 x = glm::normalize(glm::cross(helper, plane.normal)), y = glm::cross(x, plane.normal);
        const Vec3 middle = middle_of(hull);
        double reach = 0.0;
        for (const Polygon& face : hull) {
            for (const Vec3& point : face) reach = std::max(reach, glm::length(point - middle));
        }
        const Vec3 foot = middle - plane.height(middle) * plane.normal;
        Polygon cut = {foot + 2.0 * reach * (-x - y), foot + 2.0 * reach * (x - y), foot + 2.0 * reach * (x + y),
                       foot + 2.0 * reach * (y - x)};
        for (const Polygon& face : hull) {
            if (!cut.empty()) cut = clipped(cut, {face[0], -unit_normal(face)}, 0.0);
        }
        if (unit_normal(cut) != Vec3{0.0}) kept.push_back(std::move(cut));
        return kept;
    }

    /// The solid's angle seen from a place off its surface is 4 pi inside and 0 outside (triangles by
    /// Van Oosterom and Strackee 1983).
    bool is_solid_around(const Vec3& place) const {
        double angle = 0.0;
        for (const Facet& facet : facets_) {
            for (std::size_t k = 2; k < facet.outline.size(); ++k) {
                const Vec3 a = facet.outline[0] - place, b = facet.outline[k - 1] - place, c = facet.outline[k] - place;
                const double p = glm::length(a), q = glm::length(b), r = glm::length(c);
                angle += 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)),
                                          p * q * r + glm::dot(a, b) * r + glm::dot(b, c) * p + glm::dot(c, a) * q);
            }
        }
        return angle > 2.0 * std::numbers::pi;
    }

    ConvexCell cell_of(const Hull& hull) const {
        ConvexCell cell;
        for (const Polygon& face : hull) {
            std::vector<int> loop;
            for (const Vec3& point : face) {
                const int vertex = vertex_at(cell.vertices, point);
                if (loop.empty() || (loop.back() != vertex && loop.front() != vertex)) loop.push_back(vertex);
            }
            if (loop.size() >= 3) cell.faces.push_back(std::move(loop));
        }
        for (const Facet& facet : facets_) {
            const bool known = !cell.surface.empty() && cell.surface.back() == facet.face;
            if (!known && touches(hull, facet)) cell.surface.push_back(facet.face);
        }
        return cell;
    }

    int vertex_at(std::vector<Vec3>& vertices, const Vec3& point) const {
        const auto known = std::ranges::find_if(
            vertices, [&](const Vec3& vertex) { return glm::distance(vertex, point) <= thickness_; });
        if (known != vertices.end()) return static_cast<int>(known - vertices.begin());
        vertices.push_back(point);
        return static_cast<int>(vertices.size()) - 1;
    }

    /// True when part of the facet is skin of the hull, looking the same way.
    bool touches(const Hull& hull, const Facet& facet) const {
        const auto lies_along = [&](const Polygon& face) {
            const Heights heights = heights_over(facet.plane, face);
            return heights.low >= -2.0 * thickness_ && heights.high <= 2.0 * thickness_ &&
                   glm::dot(unit_normal(face), facet.plane.normal) > 0.0;
        };
        if (std::ranges::none_of(hull, lies_along)) return false;
        Polygon left = facet.outline;
        for (const Polygon& face : hull) {
            const Vec3 normal = unit_normal(face);
            if (left.empty() || lies_along(face)) continue;
            left = clipped(left, {face[0], -normal}, thickness_);
        }
        return unit_normal(left) != Vec3{0.0};
    }

    double thickness_;
    double volume_ = 0.0;
    std::vector<Facet> facets_;
    std::vector<Hull> hulls_;
};

bool is_convex_solid(const std::vector<Vec3>& vertices, const std::vector<std::vector<int>>& faces) {
    const double thickness = tolerance::planar * diameter(vertices);
    return std::ranges::all_of(faces, [&](const std::vector<int>& face) {
        const Polygon loop = loop_of(vertices, face);
        const Plane plane{loop[0], unit_normal(loop)};
        return heights_over(plane, vertices).high <= thickness;
    });
}

}  // namespace

std::vector<ConvexCell> convex_cells(const std::vector<Vec3>& vertices, const std::vector<std::vector<int>>& faces) {
    const auto is_loop = [&](const std::vector<int>& face) {
        return face.size() >= 3 && std::ranges::all_of(face, [&](int vertex) {
                   return vertex >= 0 && static_cast<std::size_t>(vertex) < vertices.size();
               });
    };
    if (faces.empty() || !std::ranges::all_of(faces, is_loop)) return {};
    if (!is_convex_solid(vertices, faces)) return Partition(vertices, faces).cells();
    ConvexCell whole{vertices, faces, {}};
    for (std::size_t f = 0; f < faces.size(); ++f) whole.surface.push_back(static_cast<int>(f));
    return {std::move(whole)};
}

}  // namespace hanei
