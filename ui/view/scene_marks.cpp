#include "engine/geometry/polygon.h"
#include "engine/scene/colour.h"
#include "engine/scene/dimmers.h"
#include "engine/scene/faces.h"
#include "engine/scene/suspension.h"
#include "ui/view/drawn_about.h"
#include "ui/view/luminaire_shape.h"
#include "ui/view/marks.h"
#include "ui/view/tone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace hanei {
namespace {

constexpr double same_corner = 1e-5;  // m: corners of faces that meet, after rotation

void append_convex(std::vector<SolidVertex>& vertices, const Polygon& convex, const Vec3& normal,
                   const glm::vec4& colour) {
    for (std::size_t k = 1; k + 1 < convex.size(); ++k) {
        for (const std::size_t corner : {std::size_t{0}, k, k + 1}) {
            vertices.push_back({drawn(convex[corner]), glm::vec3(normal), colour});
        }
    }
}

/// As a surface of this material looks beside white paper (sRGB of the reflectance), a little paler.
glm::vec4 plain_colour(const Scene& scene, ObjectId material) {
    const Material* found = find_material(scene, material);
    glm::vec3 colour(0.0F);
    for (int b = 0; b < colour_bands; ++b) {
        const double reflectance = found != nullptr ? band_reflectances(*found)[b] : 0.5;
        colour[b] = 0.25F + 0.75F * static_cast<float>(std::pow(reflectance, 1.0 / 2.2));
    }
    return {0.985F * colour.x, 0.99F * colour.y, colour.z, 1.0F};
}

/// A shining opening in the colour of its light: a warm white for neutral light.
glm::vec4 lamp_colour(const Luminaire& luminaire, const Scene& scene) {
    const glm::vec3 light(band_output(luminaire, scene));
    const glm::vec3 colour = encoded_srgb(light / std::max({light.x, light.y, light.z}));
    constexpr float depth = 0.6F;  // an opening is so bright that eye and film see little of its colour
    return glm::vec4(glm::vec3(1.0F, 0.992F, 0.94F) * glm::mix(glm::vec3(1.0F), colour, depth), 1.0F);
}

using EdgeKey = std::array<long long, 6>;

EdgeKey key_of(const Vec3& a, const Vec3& b) {
    const auto cell = [](const Vec3& p) {
        return std::array<long long, 3>{std::llround(p.x / same_corner), std::llround(p.y / same_corner),
                                        std::llround(p.z / same_corner)};
    };
    std::array<long long, 3> low = cell(a), high = cell(b);
    if (high < low) std::swap(low, high);
    return {low[0], low[1], low[2], high[0], high[1], high[2]};
}

/// Collects edges, joining those that two faces share.
class EdgeList {
public:
    void add_loop(const Polygon& loop, const Vec3& normal, const glm::vec4& colour, float width) {
        for (std::size_t k = 0; k < loop.size(); ++k) add(loop[k], loop[(k + 1) % loop.size()], normal, colour, width);
    }
    std::vector<LineMark> lines;

private:
    void add(const Vec3& from, const Vec3& to, const Vec3& normal, const glm::vec4& colour, float width) {
        const auto [place, is_new] = seen_.emplace(key_of(from, to), lines.size());
        if (is_new) {
            lines.push_back({from, to, colour, width, normal, normal});
        } else {
            lines[place->second].normal_b = normal;
        }
    }
    std::map<EdgeKey, std::size_t> seen_;
};

void add_region(EdgeList& edges, const Region& region, const Vec3& normal, const glm::vec4& colour, float width) {
    edges.add_loop(region.outline, normal, colour, width);
    for (const Polygon& hole : region.holes) edges.add_loop(hole, normal, colour, width);
}

}  // namespace

PlainFaces plain_faces(const Scene& scene) {
    PlainFaces plain;
    for (const Face& face : faces_of(scene)) {
        const glm::vec4 colour = plain_colour(scene, face.material);
        for (const Polygon& piece : convex_pieces(face.region)) append_convex(plain.faces, piece, face.normal, colour);
        for (const FaceArea& area : face.areas) {
            append_convex(plain.sub_areas, area.outline, face.normal, plain_colour(scene, area.material));
        }
    }
    return plain;
}

std::vector<LineMark> face_edges(const Scene& scene) {
    EdgeList edges;
    for (const Face& face : faces_of(scene)) {
        add_region(edges, face.region, face.normal, ink::edge, 1.3F);
        for (const FaceArea& area : face.areas) {
            edges.add_loop(area.outline, face.normal, glm::vec4(glm::vec3(ink::edge), 0.22F), 1.0F);
        }
    }
    return edges.lines;
}

std::vector<LineMark> patch_edges(const Mesh& mesh) {
    EdgeList edges;
    for (const Patch& patch : mesh.patches) {
        edges.add_loop(patch.outline, mesh.faces[patch.face].face.normal, ink::mesh, 1.0F);
    }
    return edges.lines;
}

LuminaireMarks luminaire_marks(const Scene& scene) {
    LuminaireMarks marks;
    for (const Luminaire& luminaire : scene.luminaires) {
        const LuminaireShape shape = shape_of(luminaire, scene);
        const float on = dimming_of(scene, luminaire) > 0.0 ? 1.0F : 0.0F;
        const glm::vec4 light = glm::mix(glm::vec4(0.45F, 0.46F, 0.48F, 1.0F), lamp_colour(luminaire, scene), on);
        for (const Polygon& opening : shape.shining)
            append_convex(marks.openings, opening, unit_normal(opening), light);
        for (const auto& [from, to] : shape.outline) marks.outlines.push_back({from, to, ink::luminaire, 1.3F});
        if (shape.tube) {
            marks.tubes.push_back({shape.tube->first, shape.tube->second, ink::luminaire, 7.0F});
            marks.tubes.push_back({shape.tube->first, shape.tube->second, light, 4.6F});
        }
        if (const auto cord = suspension_of(scene, luminaire))
            marks.outlines.push_back({cord->first, cord->second, ink::luminaire, 1.0F});
        if (shape.point) marks.dots.push_back({drawn(*shape.point), light, ink::luminaire, 6.0F, 0.0F});
    }
    return marks;
}

OutlineMarks outline_of(const Scene& scene, ObjectId object, const glm::vec4& colour, float width) {
    OutlineMarks marks;
    if (!object) return marks;
    EdgeList edges;
    for (const Face& face : faces_of(scene)) {
        if (face.ref.object == object) add_region(edges, face.region, face.normal, colour, width);
        for (const FaceArea& area : face.areas) {
            if (area.sub_area == object) edges.add_loop(area.outline, face.normal, colour, width);
        }
    }
    marks.lines = std::move(edges.lines);
    for (const Luminaire& luminaire : scene.luminaires) {
        if (luminaire.id != object) continue;
        const LuminaireShape shape = shape_of(luminaire, scene);
        for (const auto& [from, to] : shape.outline) marks.lines.push_back({from, to, colour, width});
        if (shape.tube) marks.lines.push_back({shape.tube->first, shape.tube->second, colour, width + 3.0F});
        if (shape.point) marks.dots.push_back({drawn(*shape.point), colour, colour, 7.5F, 0.0F});
    }
    for (const CalculationGrid& grid : scene.grids) {
        if (grid.id != object) continue;
        const Polygon loop{grid.corner, grid.corner + grid.along, grid.corner + grid.along + grid.across,
                           grid.corner + grid.across};
        for (std::size_t k = 0; k < 4; ++k) marks.lines.push_back({loop[k], loop[(k + 1) % 4], colour, width});
    }
    for (const CalculationPoint& point : scene.points) {
        if (point.id == object) marks.dots.push_back({drawn(point.position), colour, colour, 7.0F, 0.0F});
    }
    return marks;
}

}  // namespace hanei
