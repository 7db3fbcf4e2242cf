#include "engine/scene/hard_pairs.h"

#include "engine/geometry/polygon.h"
#include "engine/scene/faces.h"
#include "engine/scene/scene_findings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace hanei {
namespace {

constexpr double near_by = 1e-3;  // m: what programs set rays off a surface by

struct Extent {
    Vec3 low{INFINITY}, high{-INFINITY};
    std::size_t index = 0;  ///< of the object
    void include(const Vec3& place) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
};

/// How far apart two boxes are: the greatest of their distances along the axes; below 0 they share space.
double gap(const Extent& a, const Extent& b) {
    const Vec3 apart = glm::max(a.low - b.high, b.low - a.high);
    return std::max({apart.x, apart.y, apart.z});
}

std::vector<Extent> bodies_of(const Scene& scene) {
    std::vector<Extent> bodies;
    std::map<ObjectId, std::size_t> index;
    for (std::size_t i = 0; i < scene.furniture.size(); ++i) index[scene.furniture[i].id] = i;
    for (const Shell& shell : shells_of(scene)) {
        Extent extent;
        for (const Vec3& vertex : shell.vertices) extent.include(vertex);
        extent.index = index.at(shell.object);
        bodies.push_back(extent);
    }
    std::stable_sort(bodies.begin(), bodies.end(), [](const Extent& a, const Extent& b) { return a.low.x < b.low.x; });
    return bodies;
}

/// Of upright boxes their extents are the boxes themselves; of others they come near before the bodies do.
void look_at_bodies(HardSpots& spots) {
    const std::vector<Extent> bodies = bodies_of(spots.scene);
    std::set<std::size_t> told;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t k = i + 1; k < bodies.size() && bodies[k].low.x <= bodies[i].high.x + near_by; ++k) {
            const double apart = gap(bodies[i], bodies[k]);
            if (bodies[i].index == bodies[k].index || apart > near_by || apart < -spots.thickness) continue;
            if (!told.insert(bodies[i].index).second) break;
            const Furniture& furniture = spots.scene.furniture[bodies[i].index];
            const std::string& other = spots.scene.furniture[bodies[k].index].name;
            spots.note("furniture", bodies[i].index, "furniture", furniture.name, furniture.id, "position",
                       apart > spots.thickness
                           ? "it stands " + figure(1000.0 * apart) + " mm from \"" + other +
                                 "\"; form factors from point to point burst in such a gap and rays slip through it. "
                                 "Those of whole patches stay below 1 here; nothing needs to be done"
                           : "it stands against another body; a ray in the plane of contact may slip between them and "
                             "draw a line of light. Contact is opaque here; nothing needs to be done");
            break;
        }
}

bool is_among(const Vec3& corner, const Polygon& others, double same_place) {
    return std::any_of(others.begin(), others.end(),
                       [&](const Vec3& other) { return glm::distance(corner, other) <= same_place; });
}

/// Each corner of either has one of the other: a sliver's corners may be near each other.
bool same_outline(const Region& a, const Region& b, double same_place) {
    const auto all_among = [&](const Polygon& these, const Polygon& those) {
        return std::all_of(these.begin(), these.end(),
                           [&](const Vec3& corner) { return is_among(corner, those, same_place); });
    };
    return a.outline.size() == b.outline.size() && all_among(a.outline, b.outline) && all_among(b.outline, a.outline);
}

/// Does a line along an edge of one part the two, in their common plane?
bool parted_by_an_edge(const Polygon& of, const Polygon& other, const Vec3& normal, double same_place) {
    for (std::size_t k = 0; k < of.size(); ++k) {
        const Vec3 along = of[(k + 1) % of.size()] - of[k];
        const Vec3 outward = glm::normalize(glm::cross(along, normal));
        if (std::all_of(other.begin(), other.end(),
                        [&](const Vec3& corner) { return glm::dot(corner - of[k], outward) >= -same_place; }))
            return true;
    }
    return false;
}

/// Sheets that are not convex may be told of when they only come near each other.
bool overlap_in_one_plane(const Region& a, const Region& b, double same_place) {
    const Vec3 normal = unit_normal(a.outline);
    const Plane plane{a.outline.front(), normal};
    const bool one_plane = std::all_of(b.outline.begin(), b.outline.end(), [&](const Vec3& corner) {
        return std::abs(plane.height(corner)) <= same_place;
    });
    return one_plane && !parted_by_an_edge(a.outline, b.outline, normal, same_place) &&
           !parted_by_an_edge(b.outline, a.outline, unit_normal(b.outline), same_place);
}

constexpr double sharp = 0.9962;  // cosine of 5 degrees

/// Do they share an edge, and face each other across a sharp angle?
bool meet_sharply(const Region& a, const Region& b, double same_place) {
    const Vec3 mine = unit_normal(a.outline), its = unit_normal(b.outline);
    if (glm::dot(mine, its) > -sharp) return false;
    const auto shared = std::count_if(a.outline.begin(), a.outline.end(),
                                      [&](const Vec3& corner) { return is_among(corner, b.outline, same_place); });
    return shared == 2 && glm::dot(centroid(b.outline) - centroid(a.outline), mine) > same_place;
}

void look_at_sheets(HardSpots& spots) {
    const std::vector<FreeSurface>& sheets = spots.scene.surfaces;
    std::vector<Extent> extents(sheets.size());
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        for (const Vec3& corner : sheets[i].region.outline) extents[i].include(corner);
        extents[i].index = i;
    }
    std::stable_sort(extents.begin(), extents.end(),
                     [](const Extent& a, const Extent& b) { return a.low.x < b.low.x; });
    std::set<std::size_t> told;
    for (std::size_t i = 0; i < extents.size(); ++i)
        for (std::size_t k = i + 1; k < extents.size() && extents[k].low.x <= extents[i].high.x; ++k) {
            if (gap(extents[i], extents[k]) > spots.thickness) continue;
            const auto [first, second] = std::minmax(extents[i].index, extents[k].index);
            const Region &a = sheets[first].region, &b = sheets[second].region;
            if (meet_sharply(a, b, spots.thickness))
                spots.note("surfaces", second, "surface", sheets[second].name, sheets[second].id, "outline",
                           "it meets \"" + sheets[first].name +
                               "\" at less than 5 degrees and faces it; form factors from point to point burst in such "
                               "a corner. Those of whole patches stay below 1 here; nothing needs to be done");
            const bool twice = same_outline(a, b, spots.thickness);
            if (!twice && !overlap_in_one_plane(a, b, spots.thickness)) continue;
            if (!told.insert(second).second) continue;
            spots.note("surfaces", second, "surface", sheets[second].name, sheets[second].id, "outline",
                       (twice ? "it is where \"" + sheets[first].name + "\" is"
                              : "it overlaps \"" + sheets[first].name + "\" in one plane") +
                           std::string("; both would be lit, and shine, on the same area. One of them is seen there "
                                       "here, as if they were one sheet; remove what was left over"));
        }
}

}  // namespace

void look_at_pairs(HardSpots& spots) {
    look_at_bodies(spots);
    look_at_sheets(spots);
}

}  // namespace hanei
