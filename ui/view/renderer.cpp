#include "ui/view/renderer.h"

#include "engine/base/check.h"
#include "engine/scene/faces.h"
#include "ui/view/drawn_about.h"
#include "ui/view/layers.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

constexpr float edge_lift = 2.0F;  // pixels towards the eye: edges stand clear of the faces they border
constexpr float mark_lift = 4.0F;  // and outlines of openings and of what is selected, clear of the edges
constexpr double usual_height = 900.0;

Bounds joined(const Bounds& a, const Bounds& b) { return {glm::min(a.low, b.low), glm::max(a.high, b.high)}; }

glm::vec4 packed(const std::optional<Cut>& plane, const Vec3& origin) {
    if (!plane) return glm::vec4(0.0F);
    return {glm::vec3(plane->normal), static_cast<float>(plane->offset - glm::dot(plane->normal, origin))};
}

/// What is drawn between is cut at a plane; `which` counts as in Pass::cuts.
class Clipped {
public:
    Clipped(bool on, GLenum which) : on_(on), which_(GL_CLIP_DISTANCE0 + which) {
        if (on_) glEnable(which_);
    }
    ~Clipped() {
        if (on_) glDisable(which_);
    }
    Clipped(const Clipped&) = delete;
    Clipped& operator=(const Clipped&) = delete;

private:
    bool on_;
    GLenum which_;
};

Pass pass_of(Camera camera, PixelSize size, Bounds bounds, const CutPlanes& planes, const Vec3& origin) {
    for (Vec3* place : {&camera.eye, &camera.target, &bounds.low, &bounds.high}) *place -= origin;
    Pass pass;
    pass.to_clip = glm::mat4(view_projection(camera, size.aspect(), bounds));
    pass.eye = camera.orthographic ? glm::vec4(-axes_of(camera).forward, 0.0F) : glm::vec4(camera.eye, 1.0F);
    pass.size = glm::vec2(size.width, size.height);
    pass.pixel_scale = static_cast<float>(std::max(0.6, size.height / usual_height));
    pass.cuts = {packed(planes.cut, origin), packed(planes.ceiling, origin)};
    const double distance = camera.orthographic ? glm::length(camera.target - camera.eye) : 1.0;
    pass.pixels_per_metre = static_cast<float>(size.height / (2.0 * distance * std::tan(0.5 * camera.field_of_view)));
    return pass;
}

void blend(bool on) {
    if (on) {
        glEnable(GL_BLEND);
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    } else {
        glDisable(GL_BLEND);
    }
    glDepthMask(on ? GL_FALSE : GL_TRUE);
}

std::vector<SolidVertex> faded(std::vector<SolidVertex> vertices, float opacity) {
    for (SolidVertex& vertex : vertices) vertex.colour.a = opacity;
    return vertices;
}

}  // namespace

struct Renderer::Buffers {
    SceneSnapshot scene;
    SolutionSnapshot solution;
    Bounds bounds;
    float edge_scale = 0.0F;  ///< pixel scale that the standing lines were made for
    float sections_scale = 0.0F;
    bool mesh_loaded = false;
    CutPlanes planes;              ///< of the picture that is drawn
    CutPlanes sections_of_planes;  ///< that the sections were made for
    SceneSnapshot sections_of_scene;
    Background background;
    CellLayer cells;
    ShadowLayer shadows;
    PictureLayer picture;
    SolidLayer plain, sub_areas, openings, opening_backs;
    LineLayer edges, mesh, outlines, tubes, highlight_lines;
    DotLayer luminaire_dots, calculation, highlight_dots;
    SectionLayer sections;
    Vec3 origin{0.0};  ///< what is drawn is loaded about

    void find_bounds() {
        bounds = scene != nullptr ? bounds_of(*scene) : Bounds{};
        if (solution != nullptr)
            bounds = scene != nullptr ? joined(bounds, bounds_of(*solution->scene)) : bounds_of(*solution->scene);
        const Vec3 better = drawing_origin(bounds);
        if (better == origin) return;
        origin = better;
        load_scene(), load_solution();
    }

    void load_scene() {
        const DrawnAbout about(origin);
        const PlainFaces faces = scene != nullptr ? plain_faces(*scene) : PlainFaces{};
        plain.set(faces.faces);
        sub_areas.set(faces.sub_areas);
        edge_scale = 0.0F;
    }

    void load_solution() {
        const DrawnAbout about(origin);
        mesh_loaded = false;
        if (solution != nullptr) cells.set(solution);
        shadows.set(solution);
        if (scene == nullptr) edge_scale = 0.0F;
        sections_of_scene = nullptr;
    }

    const Scene* shown_scene() const {
        return scene != nullptr ? scene.get() : solution != nullptr ? solution->scene.get() : nullptr;
    }

    void load_lines(float pixel_scale) {
        edge_scale = pixel_scale;
        mesh_loaded = false;
        const Scene* shown = shown_scene();
        edges.set(shown != nullptr ? face_edges(*shown) : std::vector<LineMark>{}, pixel_scale);
        const LuminaireMarks marks = shown != nullptr ? luminaire_marks(*shown) : LuminaireMarks{};
        openings.set(marks.openings);
        opening_backs.set(faded(marks.openings, 0.14F));
        outlines.set(marks.outlines, pixel_scale);
        tubes.set(marks.tubes, pixel_scale);
        luminaire_dots.set(marks.dots);
    }

    void load_mesh(float pixel_scale) {
        if (mesh_loaded) return;
        mesh.set(
            solution != nullptr && solution->mesh != nullptr ? patch_edges(*solution->mesh) : std::vector<LineMark>{},
            pixel_scale);
        mesh_loaded = true;
    }

    void draw_sections(const Pass& pass) {
        if (!planes.any()) return;
        const Scene* shown = shown_scene();
        const SceneSnapshot of = scene != nullptr ? scene : solution != nullptr ? solution->scene : nullptr;
        if (!(sections_of_planes == planes) || sections_of_scene != of || sections_scale != pass.pixel_scale)
            sections.set(shown, planes, pass.pixel_scale);
        sections_of_planes = planes;
        sections_of_scene = of;
        sections_scale = pass.pixel_scale;
        sections.draw(pass);
    }

    /// The picture, and the surfaces' depth alone for what is drawn over it.
    void draw_room(const Pass& pass, const ViewOptions& look, const Image& room) {
        glDisable(GL_DEPTH_TEST);
        blend(true);
        picture.draw(room);
        blend(false);
        glEnable(GL_DEPTH_TEST);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        draw_surfaces(pass, look);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }

    void draw_surfaces(const Pass& pass, const ViewOptions& look) {
        const Clipped open(planes.ceiling.has_value(), 1);
        glEnable(GL_CULL_FACE);
        glCullFace(GL_BACK);
        if (look.shadow_classes && shadows.has_any()) {
            shadows.draw_patches(pass, look.shadows_of);
        } else if (!look.shadow_classes && solution != nullptr && has_part(*solution, look.part)) {
            cells.draw(pass, look);
        } else {
            plain.draw(pass, 1.0F);
            glEnable(GL_POLYGON_OFFSET_FILL);
            glPolygonOffset(-1.0F, -1.0F);
            sub_areas.draw(pass, 1.0F);
            glDisable(GL_POLYGON_OFFSET_FILL);
        }
        glDisable(GL_CULL_FACE);
    }

    void draw_luminaires(const Pass& pass, bool outlined) const {
        glEnable(GL_CULL_FACE);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(-2.0F, -2.0F);
        openings.draw(pass, 0.0F);
        blend(true);
        glCullFace(GL_FRONT);  // from behind: glassy, so that the room is seen through them
        opening_backs.draw(pass, 0.0F);
        glDisable(GL_POLYGON_OFFSET_FILL);
        glDisable(GL_CULL_FACE);
        if (outlined) outlines.draw(pass, mark_lift);
        tubes.draw(pass, mark_lift);
        luminaire_dots.draw(pass);
        blend(false);
    }

    void draw_highlights(const Pass& pass, const Highlights& highlights) {
        OutlineMarks marks;
        const Scene* shown = shown_scene();
        const auto add = [&](ObjectId object, const glm::vec4& colour, float width) {
            if (shown == nullptr || !object) return;
            OutlineMarks outline = outline_of(*shown, object, colour, width);
            marks.lines.insert(marks.lines.end(), outline.lines.begin(), outline.lines.end());
            marks.dots.insert(marks.dots.end(), outline.dots.begin(), outline.dots.end());
        };
        add(highlights.hovered, ink::hovered, 2.4F);
        for (const ObjectId object : highlights.selected) add(object, ink::selected, 2.8F);
        for (const Highlights::Line& line : highlights.lines)
            marks.lines.push_back({line.from, line.to, line.colour, 2.6F});
        if (marks.lines.empty() && marks.dots.empty()) return;
        highlight_dots.set(marks.dots);
        highlight_lines.set(marks.lines, pass.pixel_scale);
        blend(true);
        highlight_lines.draw(pass, mark_lift);
        highlight_dots.draw(pass);
        for (LineMark& line : marks.lines) line.colour.a *= 0.3F;  // what is behind things shows through faintly
        highlight_lines.set(marks.lines, pass.pixel_scale);
        glDisable(GL_DEPTH_TEST);
        highlight_lines.draw(pass, 0.0F);
        glEnable(GL_DEPTH_TEST);
        blend(false);
    }
};

Renderer::Renderer() : buffers_(std::make_unique<Buffers>()) {}
Renderer::~Renderer() = default;

void Renderer::set_scene(SceneSnapshot scene) {
    buffers_->scene = std::move(scene);
    buffers_->load_scene();
    buffers_->find_bounds();
}

void Renderer::set_solution(SolutionSnapshot solution) {
    const bool drawable =
        solution != nullptr && solution->scene != nullptr && solution->mesh != nullptr && solution->display != nullptr;
    buffers_->solution = drawable ? std::move(solution) : nullptr;
    buffers_->load_solution();
    buffers_->find_bounds();
}

void Renderer::draw(const Camera& camera, const ViewOptions& look, const Highlights& highlights, PixelSize size,
                    const Image* room) {
    Buffers& b = *buffers_;
    HANEI_CHECK(size.width > 0 && size.height > 0);
    glViewport(0, 0, size.width, size.height);
    for (const GLenum state : {GL_SCISSOR_TEST, GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST}) glDisable(state);
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
    b.background.draw(look.dark_background);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glFrontFace(is_mirrored(camera) ? GL_CW : GL_CCW);

    b.planes = CutPlanes(camera.left_out, b.shown_scene());
    const DrawnAbout about(b.origin);
    const Pass pass = pass_of(camera, size, b.bounds, b.planes, b.origin);
    const Clipped cut(b.planes.cut.has_value(), 0);
    if (b.edge_scale != pass.pixel_scale) b.load_lines(pass.pixel_scale);
    if (room != nullptr) {
        HANEI_CHECK(room->width == size.width && room->height == size.height);
        b.draw_room(pass, look, *room);
    } else {
        b.draw_surfaces(pass, look);
    }
    b.draw_sections(pass);
    const bool outlined = room == nullptr || look.scale != Scale::photo;  // an exact photo has no drawn lines
    if (look.luminaires) b.draw_luminaires(pass, outlined);
    blend(true);
    if (outlined) b.edges.draw(pass, edge_lift);
    if (b.planes.any()) b.sections.draw_lines(pass);
    if (look.mesh_lines || look.shadow_classes) {
        const Clipped open(b.planes.ceiling.has_value(), 1);
        b.load_mesh(pass.pixel_scale);
        b.mesh.draw(pass, edge_lift);
    }
    if (look.shadow_outlines && b.shadows.has_any()) {
        const Clipped open(b.planes.ceiling.has_value(), 1);
        b.shadows.draw_lines(pass, look.shadows_of, mark_lift);
    }
    const Scene* shown = b.shown_scene();
    if (look.grids && !look.shadow_classes && look.scale == Scale::false_colour && shown != nullptr) {
        b.calculation.set(calculation_dots(*shown, b.solution.get(), look));
        b.calculation.draw(pass);
    }
    blend(false);
    b.draw_highlights(pass, highlights);
    glFrontFace(GL_CCW);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(0);
    glBindVertexArray(0);
}

}  // namespace hanei
