/// The layers of a picture on the graphics side, each with its program and its buffers. Private to
/// the room; all need a current context.
#pragma once

#include "ui/view/gl_objects.h"
#include "ui/view/image.h"
#include "ui/view/left_out.h"
#include "ui/view/marks.h"

#include <array>
#include <optional>

namespace hanei {

/// One drawing of the room: camera and size as the programs want them.
struct Pass {
    glm::mat4 to_clip{1.0F};
    glm::vec4 eye{0.0F};  ///< w 1: a place; w 0: the direction towards the eye
    glm::vec2 size{1.0F};
    float pixel_scale = 1.0F;
    float pixels_per_metre = 1.0F;    ///< at depth 1
    std::array<glm::vec4, 2> cuts{};  ///< normals and offsets; clip distances 0 and 1 are on while they count
};

/// The light: cells interpolated bilinearly.
class CellLayer {
public:
    CellLayer();
    ~CellLayer();
    CellLayer(const CellLayer&) = delete;
    CellLayer& operator=(const CellLayer&) = delete;

    void set(SolutionSnapshot solution);
    void draw(const Pass& pass, const ViewOptions& look);

private:
    void load_values(LightPart part);
    void load_bands(LightPart part);
    void set_scale(const ViewOptions& look) const;
    void set_difference(const ViewOptions& look) const;
    gl::Program program_;
    gl::Vertices cells_;
    GLuint colours_ = 0;
    SolutionSnapshot solution_;
    glm::vec3 loaded_about_{0.0F};  ///< where the scene's own origin is among the cells that are loaded
    LightPart loaded_ = LightPart::total;
    std::optional<double> automatic_exposure_;  ///< worked out when a photo is drawn
};

/// A finished picture of the room in place of its cells.
class PictureLayer {
public:
    PictureLayer();
    ~PictureLayer();
    PictureLayer(const PictureLayer&) = delete;
    PictureLayer& operator=(const PictureLayer&) = delete;

    void draw(const Image& picture);

private:
    gl::Program program_;
    gl::Vertices corners_;
    GLuint texture_ = 0;
};

/// Plain surfaces.
class SolidLayer {
public:
    SolidLayer();
    void set(const std::vector<SolidVertex>& vertices) { vertices_.fill(vertices); }
    void draw(const Pass& pass, float shading) const;

private:
    gl::Program program_;
    gl::Vertices vertices_;
};

class LineLayer {
public:
    LineLayer();
    void set(const std::vector<LineMark>& lines, float pixel_scale);
    /// `lift` towards the eye, in pixels of a picture 900 high.
    void draw(const Pass& pass, float lift) const;

private:
    gl::Program program_;
    gl::Vertices vertices_;
};

/// Classes of patches, and outlines of shadows.
class ShadowLayer {
public:
    ShadowLayer();
    void set(SolutionSnapshot solution);  ///< null, or without shadows: nothing to draw
    bool has_any() const { return solution_ != nullptr; }
    /// Need      has_any(). `of`: a luminaire, else all together.
    void draw_patches(const Pass& pass, ObjectId of);
    void draw_lines(const Pass& pass, ObjectId of, float lift);

private:
    void choose(ObjectId of);
    gl::Program program_;
    gl::Vertices patches_;
    LineLayer lines_;
    SolutionSnapshot solution_;
    ObjectId of_;
    bool patches_loaded_ = false, lines_loaded_ = false;
    float lines_scale_ = 0.0F;
};

/// Furniture where it is cut: dark and hatched, as in drawings; and the cut room as lines.
class SectionLayer {
public:
    SectionLayer();
    void set(const Scene* scene, const CutPlanes& planes, float pixel_scale);
    void draw(const Pass& pass) const;
    void draw_lines(const Pass& pass) const;

private:
    gl::Program program_;
    gl::Vertices sections_;
    LineLayer lines_;
};

class DotLayer {
public:
    DotLayer();
    void set(const std::vector<DotMark>& dots) { vertices_.fill(dots); }
    void draw(const Pass& pass) const;

private:
    gl::Program program_;
    gl::Vertices vertices_;
};

class Background {
public:
    Background();
    void draw(bool dark) const;

private:
    gl::Program program_;
    gl::Vertices vertices_;
};

}  // namespace hanei
