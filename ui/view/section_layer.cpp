#include "ui/view/class_colours.h"
#include "ui/view/drawn_about.h"
#include "ui/view/layers.h"

#include <shaders.h>

namespace hanei {
namespace {

constexpr glm::vec4 cut_colour{0.30F, 0.31F, 0.33F, 0.0F};  // alpha 0: hatched
constexpr glm::vec3 cut_hatching{0.62F, 0.64F, 0.67F};
constexpr glm::vec4 cut_line{0.04F, 0.05F, 0.06F, 1.0F};
constexpr float room_width = 3.2F, section_width = 2.0F;  // pixels of a picture 900 high
constexpr float line_lift = 4.0F;

void append(std::vector<SolidVertex>& vertices, std::vector<LineMark>& lines, const Polygon& section,
            const Vec3& normal) {
    for (std::size_t k = 1; k + 1 < section.size(); ++k) {
        for (const std::size_t corner : {std::size_t{0}, k, k + 1})
            vertices.push_back({drawn(section[corner]), glm::vec3(normal), cut_colour});
    }
    for (std::size_t k = 0; k < section.size(); ++k)
        lines.push_back({section[k], section[(k + 1) % section.size()], cut_line, section_width, normal, normal});
}

}  // namespace

SectionLayer::SectionLayer() : program_(shaders::patch_class_vert, shaders::patch_class_frag) {
    sections_.layout(sizeof(SolidVertex), {{0, 3, offsetof(SolidVertex, position)},
                                           {1, 3, offsetof(SolidVertex, normal)},
                                           {2, 4, offsetof(SolidVertex, colour)}});
}

void SectionLayer::set(const Scene* scene, const CutPlanes& planes, float pixel_scale) {
    std::vector<SolidVertex> vertices;
    std::vector<LineMark> lines;
    for (const std::optional<Cut>& plane : {planes.cut, planes.ceiling}) {
        if (!plane || scene == nullptr) continue;
        for (const Polygon& section : sections_of(*scene, *plane)) append(vertices, lines, section, plane->normal);
    }
    if (planes.cut && scene != nullptr) {
        for (const auto& [from, to] : cut_lines_of(*scene, *planes.cut))
            lines.push_back({from, to, cut_line, room_width, {}, {}});
    }
    sections_.fill(vertices);
    lines_.set(lines, pixel_scale);
}

void SectionLayer::draw(const Pass& pass) const {
    program_.use();
    program_.set("to_clip", pass.to_clip);
    program_.set("spacing", static_cast<float>(hatching_px) * pass.pixel_scale);
    program_.set("hatching", cut_hatching);
    sections_.draw_triangles();
}

void SectionLayer::draw_lines(const Pass& pass) const { lines_.draw(pass, line_lift); }

}  // namespace hanei
