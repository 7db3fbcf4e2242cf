/// The view of the room: looking around, choosing and moving things, reading the light.
#pragma once

#include "ui/panels/handles.h"
#include "ui/panels/pane_set.h"
#include "ui/panels/probe.h"
#include "ui/panels/view_painter.h"
#include "ui/panels/view_tool.h"
#include "ui/panels/widget_registry.h"
#include "ui/view/isolux_labels.h"

#include <imgui.h>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace hanei {

/// What of the room is looked at, and how: kept by the window, not by the project.
struct ViewState {
    Camera camera;        ///< of the active picture
    ViewOptions options;  ///< of all pictures, the part of the light of the active one
    PaneSet panes;
    bool photometric_body = false;              ///< of the chosen luminaire, as wire
    bool fit_asked = false;                     ///< of the scale, to the values
    bool keep_asked = false;                    ///< of the scale, with the project
    bool automatic_asked = false;               ///< of the scale: no longer kept with the project
    std::optional<std::string> levels_typed{};  ///< isolux levels that are being typed
    bool axes = true, scale_bar = true;         ///< over every picture
    bool distances = true;                      ///< of what is chosen to the walls, in plans
    std::optional<Camera> came_from{};          ///< the picture glides from there to `camera`

    /// Looks from there; the picture glides to it, while all else takes it for there already.
    void go_to(const Camera& there) {
        came_from = camera;
        camera = there;
    }

    PaneSet::Present present() { return {camera, options.part}; }
    void choose(PaneLayout layout, const Scene& scene) { panes.choose(layout, present(), bounds_of(scene)); }
    void toggle(PaneLayout layout, const Scene& scene) { panes.toggle(layout, present(), bounds_of(scene)); }
    /// One part of the light in the active picture; where all four parts were shown, that one alone.
    void show(LightPart part, const Scene& scene);
    void toggle_shadow_classes(const Scene& scene);  ///< where all four parts were shown: instead of them
};

/// Mouse: left chooses (Shift or Ctrl: joins or leaves), and drags what is chosen; on the room it turns
/// the view, with Shift it draws a box that chooses. Right turns, middle (or Shift+right) shifts, the
/// wheel goes towards what is under it.
class Viewport {
public:
    ViewState state;

    struct Input {
        SceneSnapshot scene;
        SolutionSnapshot solution;  ///< what is drawn
        SolutionSnapshot answer;    ///< what values are read from: the last complete one
        Selection selection;
        SnapSettings snap;
        bool stale = false;
        std::span<ViewOverlay* const> overlays{};
        SceneSnapshot painted{};             ///< drawn in place of `scene`, which is still what is edited
        std::optional<double> difference{};  ///< lx: the solution is a difference, coloured from - to + this
        ViewGrips* grips = nullptr;
    };
    struct Outcome {
        std::optional<Selection> chosen;  ///< by a click or a tool
        std::optional<Scene> moved;       ///< the scene with what is dragged where it is
        bool released = false;            ///< the drag is over
        bool given_up = false;            ///< the drag is over and was never meant
        std::string step{};               ///< what is done
        bool menu_wished = false;         ///< a click of the right button, on what is chosen by then
    };

    /// Draws into the rest of the present ImGui window.
    Outcome draw(const Input& input, const ViewPainter& paint, WidgetRegistry& widgets);

    /// What the (first) picture shows: the state with what follows from the selection.
    ViewOptions shown_options(const Input& input) const { return options_of(input, 0); }

    /// A tool in hand takes the left button; null lays it down.
    void take_up(std::unique_ptr<ViewTool> tool) { tool_ = std::move(tool); }
    const ViewTool* tool() const { return tool_.get(); }

    bool dragging() const { return drag_.has_value(); }
    std::string drag_text() const { return drag_ && drag_->begun ? drag_->gesture.readout() : std::string(); }
    bool moving() const { return drag_.has_value() || turning_ || goes_on(); }
    /// Something moves without input: frames are due.
    bool goes_on() const { return passage_.has_value() || (tool_ && tool_->is_moving()); }
    const std::optional<Probe>& probe() const { return probe_; }

    /// What lies at a place of the screen.
    struct Pointed {
        std::optional<Ray> ray;  ///< empty beside the pictures
        ObjectId object;
    };
    Pointed pointed(const Scene& scene, ImVec2 at) const;
    float right_edge() const { return right_edge_; }

    /// Where a place of the room is on the screen, in the (first) picture. Empty behind the eye.
    std::optional<ImVec2> on_screen(const Vec3& place) const { return state.panes.pane(0).on_screen(place); }

    /// Width over height of the active picture, as drawn last.
    double aspect() const { return state.panes.active_pane().aspect(); }

    /// Pixels at the right that the scale stands in: presets keep the room clear of it.
    float right_margin = 0.0F;

    /// s that the picture takes to glide to another place; 0: it is there at once.
    double passage_seconds = 0.0;

    void look_from(Standpoint standpoint, const Scene& scene);
    void frame(const Bounds& bounds);  ///< all of it as large as can be, from the present direction

private:
    struct Drag {
        ObjectDrag gesture;
        bool begun = false;  ///< the mouse went far enough to mean it, or something was typed
        bool over = false;   ///< ended by a key; waits for the button to be let go
    };

    void draw_isolux_labels(const Input& input, const Pane& pane, int k);
    void paint_panes(const Input& input, const ViewPainter& paint);
    void follow_passage();
    Camera present_camera() const;  ///< as the active picture shows it
    void draw_aids(const Input& input, int k, WidgetRegistry& widgets);
    float covered() const { return state.panes.layout() == PaneLayout::single ? right_margin : 0.0F; }
    void choose_pane(bool hovered);
    void look_around(const Pane& pane);
    void draw_pane_frames(const Input& input, const ScreenRect& all, WidgetRegistry& widgets);
    void draw_pane_title(const Input& input, int k, WidgetRegistry& widgets);
    void pane_menu(const Input& input, int k, WidgetRegistry& widgets);
    void draw_section(const Input& input, int k, WidgetRegistry& widgets);
    void draw_dividers(const ScreenRect& all, WidgetRegistry& widgets);
    Outcome handle_mouse(const Input& input, bool hovered);
    Outcome handle_press(const Input& input, const Pane& pane);
    Outcome handle_drag(const Pane& pane);
    void read_light(const Input& input, const Pane& pane, bool hovered);
    void draw_handles(const Input& input, const Pane& pane, WidgetRegistry& widgets);
    void draw_planes(const Input& input, const Pane& pane, WidgetRegistry& widgets) const;
    void draw_body(const Luminaire& luminaire, const Photometry& photometry, double peak_length,
                   const Pane& pane) const;
    void draw_line(const Pane& pane, const std::vector<Vec3>& places, ImU32 colour, float width) const;
    ViewOptions options_of(const Input& input, int k) const;
    void draw_title(const Pane& pane, const std::string& text) const;
    void draw_readout(const Input& input, const ScreenRect& all) const;
    std::optional<HandleSight> handles_of(const Input& input, const Pane& pane) const;
    PaneSight sight_of(const Input& input, int k, bool hovered) const;
    Outcome handle_tool(const Input& input, bool hovered);

    int under_pointer_ = 0;  ///< the picture that the pointer is in, or was in when a button went down
    float right_edge_ = 0.0F;
    std::optional<Drag> drag_;
    std::unique_ptr<ViewTool> tool_;
    struct Passage {
        Camera from;
        double share = 0.0;  ///< of its time that is over
        PaneLayout layout = PaneLayout::single;
        int active = 0;  ///< the picture that glides
    };
    std::optional<Passage> passage_;
    bool turning_ = false;
    bool pressed_twice_ = false;
    ImVec2 pressed_at_{0.0F, 0.0F};
    std::optional<Probe> probe_;
    ObjectId hovered_;
    struct ProbeKey {
        ImVec2 at{-1.0F, -1.0F};
        Camera camera;
        SolutionSnapshot solution;
        SceneSnapshot scene;
    } probed_;
    struct Labels {
        std::vector<IsoluxLabel> labels;
        SolutionSnapshot solution;
        Camera camera;
        ViewOptions options;
        PixelSize size;
        bool thinned = false;  ///< while something was dragged
    } labels_[4];
};

}  // namespace hanei
