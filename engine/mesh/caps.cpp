#include "engine/mesh/caps.h"

#include "engine/geometry/polygon.h"
#include "engine/mesh/pieces.h"
#include "engine/mesh/place_index.h"
#include "engine/scene/placement.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>

namespace hanei {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// The free surfaces that may be part of a cap: convex and without holes, with welded corners.
struct Candidates {
    std::vector<std::size_t> faces;                   ///< into the faces of the scene
    std::vector<std::vector<std::uint32_t>> corners;  ///< one loop a candidate, into places
    std::vector<Vec3> places;
};

Candidates candidates_of(const Scene& scene, std::span<const Face> faces, double same_place) {
    std::set<ObjectId> free;
    for (const FreeSurface& surface : scene.surfaces) free.insert(surface.id);
    Candidates found;
    PlaceIndex index(same_place);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const Region& region = faces[f].region;
        if (!free.contains(faces[f].ref.object) || !region.holes.empty()) continue;
        if (!is_convex(region.outline, faces[f].normal)) continue;
        std::vector<std::uint32_t> loop;
        for (const Vec3& corner : region.outline) loop.push_back(index.number_of(corner));
        found.faces.push_back(f);
        found.corners.push_back(std::move(loop));
    }
    found.places.assign(index.places().begin(), index.places().end());
    return found;
}

/// Greatest height of the loop's corners over the plane of a face.
double greatest_height(const Candidates& all, const std::vector<std::uint32_t>& loop, const Plane& plane) {
    double greatest = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t corner : loop) greatest = std::max(greatest, plane.height(all.places[corner]));
    return greatest;
}

Plane plane_of(const Face& face) { return {face.region.outline.front(), face.normal}; }

/// Groups candidates that share an edge over which both bend backwards. An edge of more than two
/// candidates joins nobody: which of them belong together cannot be told.
std::vector<std::vector<std::size_t>> joined_backwards(const Candidates& all, std::span<const Face> faces,
                                                       double same_place) {
    std::map<Edge, std::vector<std::size_t>> users;
    for (std::size_t k = 0; k < all.faces.size(); ++k) {
        const auto& loop = all.corners[k];
        for (std::size_t e = 0; e < loop.size(); ++e) users[{loop[e], loop[(e + 1) % loop.size()]}].push_back(k);
    }
    std::vector<std::size_t> group(all.faces.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    const auto head = [&group](std::size_t k) {
        while (group[k] != k) k = group[k] = group[group[k]];
        return k;
    };
    for (const auto& [edge, owners] : users) {
        const auto back = users.find({edge.second, edge.first});
        if (back == users.end() || owners.size() != 1 || back->second.size() != 1) continue;
        const std::size_t a = owners.front();
        const std::size_t b = back->second.front();
        if (greatest_height(all, all.corners[b], plane_of(faces[all.faces[a]])) > same_place) continue;
        if (greatest_height(all, all.corners[a], plane_of(faces[all.faces[b]])) > same_place) continue;
        group[head(b)] = head(a);
    }
    std::map<std::size_t, std::vector<std::size_t>> groups;
    for (std::size_t k = 0; k < group.size(); ++k) groups[head(k)].push_back(k);
    std::vector<std::vector<std::size_t>> result;
    for (auto& [first, members] : groups) {
        if (members.size() >= 3) result.push_back(std::move(members));
    }
    return result;
}

/// Loops that close the surface of a group; nothing when its open edges form no simple loops.
std::optional<std::vector<std::vector<std::uint32_t>>> missing_loops(const Candidates& all,
                                                                     const std::vector<std::size_t>& members) {
    std::set<Edge> edges;
    for (const std::size_t k : members) {
        const auto& loop = all.corners[k];
        for (std::size_t e = 0; e < loop.size(); ++e) {
            if (!edges.insert({loop[e], loop[(e + 1) % loop.size()]}).second) return std::nullopt;
        }
    }
    std::map<std::uint32_t, std::uint32_t> next;
    for (const auto& [from, to] : edges) {
        if (edges.contains({to, from})) continue;
        if (!next.emplace(to, from).second) return std::nullopt;
    }
    std::vector<std::vector<std::uint32_t>> loops;
    while (!next.empty()) {
        std::vector<std::uint32_t> loop;
        std::uint32_t at = next.begin()->first;
        for (auto link = next.find(at); link != next.end(); link = next.find(at)) {
            loop.push_back(at);
            at = link->second;
            next.erase(link);
        }
        if (at != loop.front()) return std::nullopt;
        loops.push_back(std::move(loop));
    }
    return loops;
}

/// What is left of a convex polygon after all faces lying in its plane are taken away.
bool is_covered(const Polygon& opening, const Vec3& normal, std::span<const Face> faces,
                const std::vector<std::size_t>& own, double same_place) {
    std::vector<Polygon> left{opening};
    const Plane plane{opening.front(), normal};
    for (std::size_t f = 0; f < faces.size() && !left.empty(); ++f) {
        if (std::binary_search(own.begin(), own.end(), f)) continue;
        const bool in_plane = std::all_of(faces[f].region.outline.begin(), faces[f].region.outline.end(),
                                          [&](const Vec3& p) { return std::abs(plane.height(p)) <= same_place; });
        if (!in_plane) continue;
        for (const Polygon& cover : pieces_of(faces[f].region, faces[f].normal)) {
            std::vector<Polygon> rest;
            for (const Polygon& piece : left) {
                for (Polygon& part : subtracted(piece, cover, same_place)) rest.push_back(std::move(part));
            }
            left = std::move(rest);
        }
    }
    return left.empty();
}

/// True when part of the convex polygon (or line, or point) lies inside all planes by more than
/// `same_place`.
bool enters(Polygon polygon, const std::vector<Plane>& planes, double same_place) {
    for (const Plane& plane : planes) {
        if (polygon.size() < 3) {
            Polygon inside;  // a line or point: cut by hand, clipped() is for polygons
            for (std::size_t k = 0; k < polygon.size(); ++k) {
                const Vec3& a = polygon[k];
                const Vec3& b = polygon[(k + 1) % polygon.size()];
                const double ha = plane.height(a) + same_place;
                const double hb = plane.height(b) + same_place;
                if (ha < 0.0) inside.push_back(a);
                if (k + 1 < polygon.size() && (ha < 0.0) != (hb < 0.0)) inside.push_back(a + ha / (ha - hb) * (b - a));
            }
            polygon = std::move(inside);
        } else {
            polygon =
                clipped(polygon, {plane.point - 2.0 * same_place * plane.normal, -plane.normal}, 0.5 * same_place);
        }
        if (polygon.empty()) return false;
    }
    return true;
}

/// Something of the scene that a solid must not enclose.
struct Other {
    Polygon polygon;
    Box box;
    std::optional<std::size_t> face;  ///< that it is part of

    Other(Polygon of, std::optional<std::size_t> part_of)
        : polygon(std::move(of)), box(box_of(polygon)), face(part_of) {}

    static Box box_of(std::span<const Vec3> points) {
        Box box{points.front(), points.front()};
        for (const Vec3& point : points) box.include(point);
        return box;
    }
    bool is_beside(const Box& b) const {
        return glm::any(glm::greaterThan(box.low, b.high)) || glm::any(glm::lessThan(box.high, b.low));
    }
};

/// Everything of a scene that has a place, but its faces: each a polygon, a line or a point.
std::vector<Polygon> places_besides_faces(const Scene& scene) {
    std::vector<Polygon> found;
    for (const Luminaire& luminaire : scene.luminaires) {
        const Placement placed = placement(luminaire);
        found.push_back({placed.position});
        if (const auto* line = std::get_if<LineOpening>(&luminaire.opening)) {
            found.push_back({placed.point(line->from), placed.point(line->to)});
        } else if (const auto* flat = std::get_if<PolygonOpening>(&luminaire.opening)) {
            for (Polygon& piece : convex_pieces(placed.region(flat->region))) found.push_back(std::move(piece));
        } else if (const auto* solid = std::get_if<PolyhedronOpening>(&luminaire.opening)) {
            for (const auto& face : solid->faces) {
                Polygon polygon;
                for (const int v : face) polygon.push_back(placed.point(solid->vertices[static_cast<std::size_t>(v)]));
                found.push_back(std::move(polygon));
            }
        }
    }
    for (const CalculationPoint& point : scene.points) found.push_back({point.position});
    for (const CalculationGrid& grid : scene.grids) {
        found.push_back(
            {grid.corner, grid.corner + grid.along, grid.corner + grid.along + grid.across, grid.corner + grid.across});
    }
    return found;
}

std::vector<Other> others_of(const Scene& scene, std::span<const Face> faces) {
    std::vector<Other> others;
    for (Polygon& place : places_besides_faces(scene)) others.emplace_back(std::move(place), std::nullopt);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (Polygon& piece : pieces_of(faces[f].region, faces[f].normal)) others.emplace_back(std::move(piece), f);
    }
    return others;
}

/// The group closed to a solid, or nothing when its hull is no faithful stand-in.
std::optional<SolidBody> closed(const Candidates& all, const std::vector<std::size_t>& members,
                                std::span<const Face> faces, const std::vector<Other>& others, double same_place) {
    SolidBody solid;
    std::vector<Plane> planes;
    std::vector<std::vector<std::uint32_t>> loops;
    for (const std::size_t k : members) {
        solid.faces.push_back(all.faces[k]);
        planes.push_back(plane_of(faces[all.faces[k]]));
        loops.push_back(all.corners[k]);
    }
    std::sort(solid.faces.begin(), solid.faces.end());
    const auto missing = missing_loops(all, members);
    if (!missing) return std::nullopt;
    int open = 0;
    for (const auto& loop : *missing) {
        Polygon polygon;
        for (const std::uint32_t corner : loop) polygon.push_back(all.places[corner]);
        const Vec3 normal = unit_normal(polygon);
        if (normal == Vec3(0.0) || !is_convex(polygon, normal)) return std::nullopt;
        if (!is_covered(polygon, normal, faces, solid.faces, same_place) && ++open > 1) return std::nullopt;
        planes.push_back({polygon.front(), normal});
        loops.push_back(loop);
    }
    for (const Plane& plane : planes) {
        for (const auto& loop : loops) {
            if (greatest_height(all, loop, plane) > same_place) return std::nullopt;
        }
    }
    Box box{all.places[loops.front().front()], all.places[loops.front().front()]};
    for (const auto& loop : loops) {
        for (const std::uint32_t corner : loop) box.include(all.places[corner]);
    }
    for (const Other& other : others) {
        if (other.is_beside(box)) continue;
        if (other.face && std::binary_search(solid.faces.begin(), solid.faces.end(), *other.face)) continue;
        if (enters(other.polygon, planes, same_place)) return std::nullopt;
    }
    std::map<std::uint32_t, int> numbers;
    for (const auto& loop : loops) {
        std::vector<int> face;
        for (const std::uint32_t corner : loop) {
            const auto [at, is_new] = numbers.emplace(corner, static_cast<int>(solid.body.vertices.size()));
            if (is_new) solid.body.vertices.push_back(all.places[corner]);
            face.push_back(at->second);
        }
        solid.body.faces.push_back(std::move(face));
    }
    solid.body.owner = faces[solid.faces.front()].ref.object.value;
    return solid;
}

}  // namespace

std::vector<SolidBody> convex_caps(const Scene& scene, std::span<const Face> faces, double same_place) {
    const Candidates all = candidates_of(scene, faces, same_place);
    const std::vector<std::vector<std::size_t>> groups = joined_backwards(all, faces, same_place);
    std::vector<SolidBody> caps;
    if (groups.empty()) return caps;
    const std::vector<Other> others = others_of(scene, faces);
    for (const auto& members : groups) {
        if (auto solid = closed(all, members, faces, others, same_place)) caps.push_back(std::move(*solid));
    }
    return caps;
}

}  // namespace hanei
