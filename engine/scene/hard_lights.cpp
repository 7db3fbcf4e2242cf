#include "engine/geometry/polygon.h"
#include "engine/scene/dimmers.h"
#include "engine/scene/faces.h"
#include "engine/scene/hard_pairs.h"
#include "engine/scene/placement.h"
#include "engine/scene/scene_findings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

constexpr double near_by = 1e-3;         // m: what programs set rays off a surface by
constexpr double narrow_exponent = 500;  // a beam 6 degrees wide
constexpr double as_a_point = 1e-4;      // size of an opening, of the scene's

class LightSpots {
public:
    LightSpots(HardSpots& spots, std::size_t index)
        : spots_(spots), index_(index), light_(spots.scene.luminaires[index]), placed_(placement(light_)) {}

    void look_at_itself() const {
        if (light_.opaque)
            note(
                "it is opaque and hides what lies behind it; openings are no surfaces, and programs let light pass "
                "through them. Light that meets it is held back and counted; nothing needs to be done");
        if (const auto* const power = std::get_if<CosinePower>(&light_.distribution);
            power != nullptr && power->exponent > narrow_exponent)
            note("half of its light falls within " +
                 figure(360.0 / std::numbers::pi * std::acos(std::pow(0.5, 1.0 / (power->exponent + 1.0)))) +
                 " degrees; a patch that the beam falls into is lit as if it were spread over all of it, in "
                 "interreflection. Direct light at points is exact; make patches narrower where the beam falls");
        if (const auto* const polygon = std::get_if<PolygonOpening>(&light_.opening)) look_at_outline(polygon->region);
    }

    /// Points: faces and edges that they see end on. Openings: bodies right before them.
    void look_at_body(const Shell& shell, const std::string& name) const {
        if (std::holds_alternative<PointOpening>(light_.opening) && is_in_a_face(shell))
            note("it lies in the plane of a face of \"" + name +
                 "\", which it sees end on; whether that face is lit would be a matter of rounding. It is told 0 lx "
                 "from it; nothing needs to be done");
        const auto* const polygon = std::get_if<PolygonOpening>(&light_.opening);
        if (polygon == nullptr) return;
        const Region opening = placed_.region(polygon->region);
        const Plane plane{opening.outline.front(), unit_normal(opening.outline)};
        double nearest = HUGE_VAL;
        for (const Vec3& corner : shell.vertices) nearest = std::min(nearest, plane.height(corner));
        if (nearest >= 0.0 && nearest < near_by && reaches_over(shell, plane, opening.outline))
            note("\"" + name + "\" stands " + figure(1000.0 * nearest) +
                 " mm before it; a ray that is set off the opening by more starts behind it. What it covers is cut out "
                 "exactly here; look whether it should hang there");
    }

    void look_at_other(const Luminaire& other) const {
        const auto* const mine = std::get_if<PolygonOpening>(&light_.opening);
        const auto* const its = std::get_if<PolygonOpening>(&other.opening);
        if (mine == nullptr || its == nullptr) return;
        if (glm::distance(light_.position, other.position) > reach(mine->region) + reach(its->region)) return;
        const Polygon a = placed_.region(mine->region).outline, b = placement(other).region(its->region).outline;
        for (std::size_t i = 0; i < a.size(); ++i)
            for (std::size_t k = 0; k < b.size(); ++k)
                if (same_edge(a[i], a[(i + 1) % a.size()], b[k], b[(k + 1) % b.size()]))
                    return note(
                        "it shares an edge with \"" + other.name +
                        "\"; on it either would count twice or not at all where edges are a matter of rounding. "
                        "Both add up to the whole here; nothing needs to be done");
    }

private:
    /// How far from the luminaire's place the opening reaches.
    double reach(const Region& opening) const {
        double farthest = 0.0;
        for (const Vec3& corner : opening.outline) farthest = std::max(farthest, glm::length(corner));
        return farthest + spots_.thickness;
    }

    void look_at_outline(const Region& opening) const {
        if (!opening.holes.empty())
            note(
                "its opening has a hole; whoever takes its middle for it takes a place that does not shine. The hole "
                "is cut out exactly here; nothing needs to be done");
        if (const double size = diameter(opening.outline); size < as_a_point * spots_.size)
            note("its opening is " + figure(1000.0 * size) +
                 " mm wide, a ten thousandth of the scene or less; formulas that subtract directions lose their digits "
                 "on it. The contour formula used here keeps them; make it a point if it is one");
    }

    bool is_in_a_face(const Shell& shell) const {
        return std::any_of(shell.faces.begin(), shell.faces.end(), [&](const std::vector<int>& face) {
            Polygon loop;
            for (const int vertex : face) loop.push_back(shell.vertices[static_cast<std::size_t>(vertex)]);
            return std::abs(glm::dot(light_.position - loop.front(), unit_normal(loop))) <= spots_.thickness;
        });
    }

    /// Is a part of the opening before the body's extent, seen along the normal?
    static bool reaches_over(const Shell& shell, const Plane& plane, const Polygon& outline) {
        const Vec3 x = glm::normalize(outline[1] - outline[0]), y = glm::cross(plane.normal, x);
        for (const Vec3& axis : {x, y}) {
            double low = HUGE_VAL, high = -HUGE_VAL, least = HUGE_VAL, most = -HUGE_VAL;
            for (const Vec3& corner : shell.vertices) {
                low = std::min(low, glm::dot(corner, axis));
                high = std::max(high, glm::dot(corner, axis));
            }
            for (const Vec3& corner : outline) {
                least = std::min(least, glm::dot(corner, axis));
                most = std::max(most, glm::dot(corner, axis));
            }
            if (low >= most || high <= least) return false;
        }
        return true;
    }

    bool same_edge(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
        const auto same = [&](const Vec3& p, const Vec3& q) { return glm::distance(p, q) <= spots_.thickness; };
        return (same(a, c) && same(b, d)) || (same(a, d) && same(b, c));
    }

    void note(const std::string& message) const {
        spots_.note("luminaires", index_, "luminaire", light_.name, light_.id, "opening", message);
    }

    HardSpots& spots_;
    std::size_t index_;
    const Luminaire& light_;
    Placement placed_;
};

bool shines(const Scene& scene, const Luminaire& luminaire) {
    const auto* const flux = std::get_if<LuminousFlux>(&luminaire.output);
    const auto* const luminance = std::get_if<Luminance>(&luminaire.output);
    if ((flux != nullptr && flux->value <= 0.0) || (luminance != nullptr && luminance->value <= 0.0)) return false;
    return dimming_of(scene, luminaire) > 0.0;
}

bool anything_shines(const Scene& scene) {
    return std::any_of(scene.luminaires.begin(), scene.luminaires.end(),
                       [&](const Luminaire& luminaire) { return shines(scene, luminaire); }) ||
           std::any_of(scene.surfaces.begin(), scene.surfaces.end(),
                       [](const FreeSurface& surface) { return surface.own_exitance.value > 0.0; });
}

}  // namespace

void look_at_lights(HardSpots& spots) {
    const Scene& scene = spots.scene;
    if (!anything_shines(scene))
        spots.note_whole(
            "luminaires",
            "nothing shines; uniformities and relative errors would be 0 / 0. They are told as 0 here; add "
            "a luminaire or turn up its dimmer");
    const std::vector<Shell> shells = shells_of(scene);
    std::map<ObjectId, std::string> names;
    for (const Furniture& furniture : scene.furniture) names[furniture.id] = furniture.name;
    for (std::size_t i = 0; i < scene.luminaires.size(); ++i) {
        const LightSpots light(spots, i);
        light.look_at_itself();
        for (const Shell& shell : shells) light.look_at_body(shell, names[shell.object]);
        for (std::size_t k = 0; k < i; ++k) light.look_at_other(scene.luminaires[k]);
    }
}

}  // namespace hanei
