#include "ui/view/shadow_marks.h"

#include "engine/scene/faces.h"
#include "ui/view/drawn_about.h"

#include <algorithm>

namespace hanei {
namespace {

constexpr glm::vec4 line_ink{0.10F, 0.07F, 0.16F, 1.0F};
constexpr glm::vec4 line_halo{1.0F, 1.0F, 1.0F, 0.78F};
constexpr float umbra_width = 2.0F;  // pixels of a picture 900 high
constexpr float penumbra_width = 1.5F;
constexpr float halo_width = 2.2F;
constexpr double dashes_across = 130.0;  // of the scene's diameter: 8 cm in a 10 m room
constexpr double dash_share = 0.6;       // of a dash and the gap after it

/// Cuts a line into dashes, from its beginning.
std::vector<std::pair<Vec3, Vec3>> dashes_of(const Polygon& line, double period) {
    std::vector<std::pair<Vec3, Vec3>> dashes;
    double at = 0.0;  // within the period
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        const double length = glm::distance(line[k], line[k + 1]);
        for (double done = 0.0; done < length;) {
            const bool drawn = at < dash_share * period;
            const double rest = (drawn ? dash_share * period : period) - at;
            const double step = std::min(rest, length - done);
            const auto place = [&](double s) { return glm::mix(line[k], line[k + 1], s / length); };
            if (drawn) dashes.emplace_back(place(done), place(done + step));
            done += step;
            at = step < rest ? at + step : drawn ? dash_share * period : 0.0;
        }
    }
    return dashes;
}

std::vector<std::pair<Vec3, Vec3>> sides_of(const Polygon& line) {
    std::vector<std::pair<Vec3, Vec3>> sides;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) sides.emplace_back(line[k], line[k + 1]);
    return sides;
}

}  // namespace

std::vector<SolidVertex> class_marks(const Solution& solution, ObjectId of) {
    const Mesh& mesh = *solution.mesh;
    const std::vector<LightClass> classes = patch_classes(*solution.shadows, of, mesh.patches.size());
    std::vector<SolidVertex> vertices;
    for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
        const Patch& patch = mesh.patches[p];
        const glm::vec4 colour(class_colours[static_cast<std::size_t>(classes[p])],
                               classes[p] == LightClass::partly ? 0.0F : 1.0F);
        const glm::vec3 normal(mesh.faces[patch.face].face.normal);
        for (std::size_t k = 1; k + 1 < patch.outline.size(); ++k) {
            for (const std::size_t corner : {std::size_t{0}, k, k + 1})
                vertices.push_back({drawn(patch.outline[corner]), normal, colour});
        }
    }
    return vertices;
}

std::vector<LineMark> shadow_lines(const Solution& solution, ObjectId of) {
    const bool one = holds(*solution.shadows, of);
    const double period = bounds_of(*solution.scene).diameter() / dashes_across;
    std::vector<LineMark> halos, lines;
    for (const LuminaireShadows& luminaire : solution.shadows->luminaires) {
        if (one && luminaire.luminaire != of) continue;
        for (const ShadowLine& line : luminaire.lines) {
            const Vec3& normal = solution.mesh->faces[line.face].face.normal;
            const float width = line.umbra ? umbra_width : penumbra_width;
            for (const auto& [from, to] : line.umbra ? sides_of(line.places) : dashes_of(line.places, period)) {
                halos.push_back({from, to, line_halo, width + halo_width, normal, normal});
                lines.push_back({from, to, line_ink, width, normal, normal});
            }
        }
    }
    halos.insert(halos.end(), lines.begin(), lines.end());
    return halos;
}

}  // namespace hanei
