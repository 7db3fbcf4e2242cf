#include "ui/view/band_light.h"
#include "ui/view/cell_field.h"
#include "ui/view/colour_scale.h"
#include "ui/view/drawn_about.h"
#include "ui/view/layers.h"
#include "ui/view/tone.h"

#include <algorithm>
#include <cmath>
#include <shaders.h>

namespace hanei {
namespace {

constexpr std::size_t most_lines = 64;  // as the shader's arrays
constexpr float isolux_width = 1.5F;    // pixels of a picture 900 high

// Share by which cells are drawn too large: where a corner of one lies on an edge of another, their
// borders differ by the graphics' rounding, and the background would sparkle through.
constexpr double overlap = 2e-4;

struct CellVertex {
    glm::vec3 position;
    glm::vec2 flat;
    glm::vec4 sides;
    glm::vec2 corner;
    glm::vec3 reflectance;
};

/// Illuminance at the four corners, band by band.
struct CellBands {
    glm::vec4 red, green, blue;
};

void append_cell(std::vector<CellVertex>& vertices, std::vector<GLuint>& indices, const Solution& solution,
                 const DisplayCell& cell, const Vec3& reflectance) {
    const CellFrame frame = frame_of(solution, cell);
    const GLuint first = static_cast<GLuint>(vertices.size());
    Vec3 centre(0.0);
    for (const std::uint32_t corner : cell.corner) centre += 0.25 * solution.display->vertices[corner].position;
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3& corner = solution.display->vertices[cell.corner[k]].position;
        const Vec3 place = corner + overlap * (corner - centre);
        const Vec2 flat = frame.flat(place);
        vertices.push_back({drawn(place), glm::vec2(flat), glm::vec4(frame.corner[1], frame.corner[3]),
                            glm::vec2(frame.corner[2]), glm::vec3(reflectance)});
    }
    indices.insert(indices.end(), {first, first + 1, first + 2});
    if (!frame.triangle) indices.insert(indices.end(), {first, first + 2, first + 3});
}

std::vector<float> shader_array(const std::vector<double>& values) {
    std::vector<float> array;
    for (const double value : values) {
        if (array.size() < most_lines) array.push_back(static_cast<float>(value));
    }
    return array;
}

/// Whether only the light differs: the same cells of the same materials.
bool same_shape(const Solution& a, const Solution& b) {
    const auto same_cell = [](const DisplayCell& x, const DisplayCell& y) {
        return std::equal(x.corner, x.corner + 4, y.corner) && x.face == y.face && x.patch == y.patch;
    };
    const auto same_place = [](const DisplayVertex& x, const DisplayVertex& y) { return x.position == y.position; };
    return a.mesh == b.mesh && a.scene->materials == b.scene->materials &&
           std::equal(a.display->cells.begin(), a.display->cells.end(), b.display->cells.begin(),
                      b.display->cells.end(), same_cell) &&
           std::equal(a.display->vertices.begin(), a.display->vertices.end(), b.display->vertices.begin(),
                      b.display->vertices.end(), same_place);
}

}  // namespace

CellLayer::CellLayer() : program_(shaders::cell_vert, shaders::cell_frag) {
    cells_.layout(sizeof(CellVertex), {{0, 3, offsetof(CellVertex, position)},
                                       {1, 2, offsetof(CellVertex, flat)},
                                       {2, 4, offsetof(CellVertex, sides)},
                                       {3, 2, offsetof(CellVertex, corner)},
                                       {5, 3, offsetof(CellVertex, reflectance)}});
    cells_.layout(sizeof(glm::vec4), {{4, 4, 0}}, 1);
    glGenTextures(1, &colours_);
    glBindTexture(GL_TEXTURE_2D, colours_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB16F, 256, 1, 0, GL_RGB, GL_FLOAT, colour_table().data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

CellLayer::~CellLayer() { glDeleteTextures(1, &colours_); }

void CellLayer::set(SolutionSnapshot solution) {
    const glm::vec3 about = drawn(Vec3{0.0});
    const bool is_loaded = solution_ != nullptr && about == loaded_about_ && same_shape(*solution_, *solution);
    loaded_about_ = about;
    solution_ = std::move(solution);
    automatic_exposure_.reset();
    if (is_loaded) return load_values(loaded_);
    std::vector<CellVertex> vertices;
    std::vector<GLuint> indices;
    vertices.reserve(4 * solution_->display->cells.size());
    const std::vector<Vec3> reflectance = patch_colours(*solution_);
    for (const DisplayCell& cell : solution_->display->cells) {
        append_cell(vertices, indices, *solution_, cell, reflectance[cell.patch]);
    }
    cells_.fill(vertices);
    cells_.fill_indices(indices);
    load_values(loaded_);
}

void CellLayer::load_values(LightPart part) {
    std::vector<glm::vec4> values;
    values.reserve(4 * solution_->display->cells.size());
    for (const DisplayCell& cell : solution_->display->cells) {
        const std::array<double, 4> lux = corner_values(*solution_->display, cell, part);
        values.insert(values.end(), 4, glm::vec4(lux[0], lux[1], lux[2], lux[3]));
    }
    cells_.fill(values, 1);
    load_bands(part);
    loaded_ = part;
}

/// Only coloured light needs them: neutral light has the same in every band.
void CellLayer::load_bands(LightPart part) {
    const DisplayMesh& display = *solution_->display;
    if (display.tinted.empty()) return cells_.leave_out({6, 7, 8});
    const auto four = [](const std::array<double, 4>& lux) { return glm::vec4(lux[0], lux[1], lux[2], lux[3]); };
    std::vector<CellBands> values;
    values.reserve(4 * display.cells.size());
    for (const DisplayCell& cell : display.cells) {
        const auto [red, green, blue] = bands_at_corners(display, cell, corner_values(display, cell, part));
        values.insert(values.end(), 4, {four(red), four(green), four(blue)});
    }
    cells_.layout(
        sizeof(CellBands),
        {{6, 4, offsetof(CellBands, red)}, {7, 4, offsetof(CellBands, green)}, {8, 4, offsetof(CellBands, blue)}}, 2);
    cells_.fill(values, 2);
}

void CellLayer::set_scale(const ViewOptions& look) const {
    const LuxRange& range = look.range;
    const bool logarithmic = look.steps == ColourSteps::logarithmic;
    const double low = logarithmic ? std::max(range.low, 1e-6 * range.high) : range.low;
    program_.set("lux_range", glm::vec2(low, range.high));
    program_.set("steps", static_cast<int>(look.steps));
    const std::vector<float> borders = shader_array(band_borders(range));
    program_.set("border_count", static_cast<int>(borders.size()));
    program_.set("borders", borders);
    const std::vector<float> lines = look.isolux ? shader_array(isolux_levels(look)) : std::vector<float>{};
    program_.set("line_count", static_cast<int>(lines.size()));
    program_.set("lines", lines);
}

void CellLayer::set_difference(const ViewOptions& look) const {
    const DifferenceColours& of = difference_colours;
    program_.set("difference", look.difference ? 1 : 0);
    program_.set("of_difference[0]", of.much_less);
    program_.set("of_difference[1]", of.less);
    program_.set("of_difference[2]", of.none);
    program_.set("of_difference[3]", of.more);
    program_.set("of_difference[4]", of.much_more);
    program_.set("of_difference[5]", of.nothing);
    program_.set("shade_of_stripe", shade_of_stripe);
    program_.set("least_striped", static_cast<float>(least_striped_share));
}

void CellLayer::draw(const Pass& pass, const ViewOptions& look) {
    if (look.part != loaded_) load_values(look.part);
    program_.use();
    program_.set("to_clip", pass.to_clip);
    program_.set("cuts", std::span<const glm::vec4>(pass.cuts));
    if (look.scale == Scale::photo && !automatic_exposure_) automatic_exposure_ = automatic_exposure(*solution_);
    program_.set("photo", look.scale == Scale::photo ? 1 : 0);
    set_difference(look);
    program_.set("coloured_light", solution_->display->tinted.empty() ? 0 : 1);
    program_.set("exposure", static_cast<float>(automatic_exposure_.value_or(1.0) * std::exp2(look.exposure)));
    program_.set("colour_below", colour_below);
    program_.set("colour_above", colour_above);
    program_.set("marks_clipped", look.marks_clipped ? 1 : 0);
    program_.set("stripe_below", stripe_below);
    program_.set("stripe_above", stripe_above);
    program_.set("stripes", pass.pixel_scale * glm::vec2(stripe_distance, stripe_width));
    program_.set("line_width", isolux_width * pass.pixel_scale);
    set_scale(look);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, colours_);
    program_.set("colours", 0);
    cells_.draw_triangles();
    glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace hanei
