#include "ui/view/drawn_about.h"
#include "ui/view/layers.h"

#include <shaders.h>

namespace hanei {
namespace {

struct LineVertex {
    glm::vec3 from, to;
    glm::vec3 normal_a, normal_b;
    glm::vec4 colour;
    glm::vec3 corner_and_width;
};

}  // namespace

SolidLayer::SolidLayer() : program_(shaders::solid_vert, shaders::solid_frag) {
    vertices_.layout(sizeof(SolidVertex), {{0, 3, offsetof(SolidVertex, position)},
                                           {1, 3, offsetof(SolidVertex, normal)},
                                           {2, 4, offsetof(SolidVertex, colour)}});
}

void SolidLayer::draw(const Pass& pass, float shading) const {
    program_.use();
    program_.set("to_clip", pass.to_clip);
    program_.set("cuts", std::span<const glm::vec4>(pass.cuts));
    program_.set("shading", shading);
    vertices_.draw_triangles();
}

LineLayer::LineLayer() : program_(shaders::line_vert, shaders::line_frag) {
    vertices_.layout(sizeof(LineVertex), {{0, 3, offsetof(LineVertex, from)},
                                          {1, 3, offsetof(LineVertex, to)},
                                          {2, 3, offsetof(LineVertex, normal_a)},
                                          {3, 3, offsetof(LineVertex, normal_b)},
                                          {4, 4, offsetof(LineVertex, colour)},
                                          {5, 3, offsetof(LineVertex, corner_and_width)}});
}

void LineLayer::set(const std::vector<LineMark>& lines, float pixel_scale) {
    std::vector<LineVertex> vertices;
    std::vector<GLuint> indices;
    vertices.reserve(4 * lines.size());
    for (const LineMark& line : lines) {
        const GLuint first = static_cast<GLuint>(vertices.size());
        for (const glm::vec2 corner : {glm::vec2(0, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(0, 1)}) {
            vertices.push_back({drawn(line.from), drawn(line.to), glm::vec3(line.normal_a), glm::vec3(line.normal_b),
                                line.colour, glm::vec3(corner, line.width * pixel_scale)});
        }
        indices.insert(indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    }
    vertices_.fill(vertices);
    vertices_.fill_indices(indices);
}

void LineLayer::draw(const Pass& pass, float lift) const {
    program_.use();
    program_.set("to_clip", pass.to_clip);
    program_.set("cuts", std::span<const glm::vec4>(pass.cuts));
    program_.set("picture_size", pass.size);
    program_.set("eye", pass.eye);
    program_.set("pixels_per_metre", pass.pixels_per_metre);
    program_.set("lift", lift * pass.pixel_scale);
    vertices_.draw_triangles();
}

DotLayer::DotLayer() : program_(shaders::dot_vert, shaders::dot_frag) {
    vertices_.layout(sizeof(DotMark), {{0, 3, offsetof(DotMark, place)},
                                       {1, 4, offsetof(DotMark, fill)},
                                       {2, 4, offsetof(DotMark, ring)},
                                       {3, 2, offsetof(DotMark, radius)},
                                       {4, 3, offsetof(DotMark, normal)}});
}

void DotLayer::draw(const Pass& pass) const {
    program_.use();
    program_.set("to_clip", pass.to_clip);
    program_.set("cuts", std::span<const glm::vec4>(pass.cuts));
    program_.set("pixels_per_metre", pass.pixels_per_metre);
    program_.set("pixel_scale", pass.pixel_scale);
    program_.set("eye", pass.eye);
    vertices_.draw_points();
}

PictureLayer::PictureLayer() : program_(shaders::picture_vert, shaders::picture_frag) {
    corners_.fill(std::vector<glm::vec3>(3));
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
}

PictureLayer::~PictureLayer() { glDeleteTextures(1, &texture_); }

void PictureLayer::draw(const Image& picture) {
    program_.use();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture.width, picture.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 picture.rgba.data());
    program_.set("picture", 0);
    corners_.draw_triangles();
    glBindTexture(GL_TEXTURE_2D, 0);
}

Background::Background() : program_(shaders::background_vert, shaders::background_frag) {
    vertices_.fill(std::vector<glm::vec3>(3));
}

void Background::draw(bool dark) const {
    program_.use();
    program_.set("low", dark ? glm::vec3(0.135F, 0.145F, 0.16F) : glm::vec3(0.855F, 0.865F, 0.875F));
    program_.set("high", dark ? glm::vec3(0.235F, 0.25F, 0.27F) : glm::vec3(0.935F, 0.94F, 0.945F));
    vertices_.draw_triangles();
}

}  // namespace hanei
