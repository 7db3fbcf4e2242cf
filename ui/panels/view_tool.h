/// A mode of the view in which the left mouse button means something of its own: drawing a plan,
/// aiming a luminaire, laying a profile line.
#pragma once

#include "engine/scene/scene.h"
#include "engine/solution/solution.h"
#include "ui/panels/key.h"
#include "ui/panels/pane.h"
#include "ui/panels/selection.h"
#include "ui/panels/widget_registry.h"

#include <memory>
#include <optional>
#include <string>

namespace hanei {

/// What a tool or an overlay sees of one frame.
struct PaneSight {
    const Pane& pane;  ///< the picture the pointer is in, or the one to draw over
    int number = 0;    ///< of the pane; widgets are noted for pane 0
    SceneSnapshot scene;
    SolutionSnapshot answer;  ///< the last complete one; may be null or of an older scene
    const Selection& selection;
    double raster = 0.1;   ///< m; 0 is none
    bool hovered = false;  ///< the pointer is over the picture and nothing covers it
};

class ViewTool {
public:
    struct Outcome {
        std::optional<Scene> scene;  ///< the scene it would rather have; a gesture until `settles`
        std::string step;            ///< its name in the history
        bool settles = false;        ///< the gesture is over: one step
        std::optional<Selection> chosen;
        bool finished = false;  ///< the tool lays itself down
    };

    virtual ~ViewTool() = default;

    /// Once a frame while it is the view's tool, before anything is drawn. Right and middle button
    /// and the wheel still move the view; Escape lays the tool down without asking it.
    virtual Outcome handle(const PaneSight& sight) = 0;

    /// Over each picture.
    virtual void draw(const PaneSight& sight, WidgetRegistry& widgets) const = 0;

    /// Whether the tool means this chord for itself; commands do not get it then.
    virtual bool takes(const Chord&) const { return false; }

    /// Mouse buttons and the wheel turn the view as the tool says, not as they otherwise do.
    virtual bool turns_view() const { return false; }

    /// Goes on by itself: frames are due without input.
    virtual bool is_moving() const { return false; }

    /// What to do next, for the status line: "Click the next corner; Enter closes the plan".
    virtual std::string hint() const = 0;
};

/// Handles of its own in the pictures: asked on a press of the left button, before objects are.
class ViewGrips {
public:
    virtual ~ViewGrips() = default;
    /// A tool that holds what lies under the pointer until the button is let go; null when nothing does.
    virtual std::unique_ptr<ViewTool> take(const PaneSight& sight) = 0;
};

/// Something drawn over every picture: pins, labels, a line.
class ViewOverlay {
public:
    virtual ~ViewOverlay() = default;
    virtual void draw(const PaneSight& sight, WidgetRegistry& widgets) = 0;
};

}  // namespace hanei
