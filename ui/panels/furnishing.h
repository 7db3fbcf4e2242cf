/// Rooms and furniture in the window: the library, the chosen face of the room, handles of its plan,
/// and the questions asked before something is made.
#pragma once

#include "engine/edit/copies.h"
#include "engine/edit/furniture_library.h"
#include "engine/edit/plan_edits.h"
#include "ui/panels/form.h"
#include "ui/panels/room_panel.h"
#include "ui/panels/view_tool.h"

#include <filesystem>
#include <memory>

namespace hanei {

class Furnishing : public ViewOverlay, public ViewGrips {
public:
    /// What the user wishes, for the workbench to carry out.
    struct Wish {
        std::optional<Scene> scene;  ///< the scene it would rather have
        std::string step;            ///< its name in the history
        bool previews = false;       ///< shown, but not yet a step
        bool settles = false;        ///< what is shown becomes a step
        bool abandons = false;       ///< what is shown is given up
        bool begins_anew = false;    ///< the scene is that of a new project
        ObjectIds chosen;
        std::unique_ptr<ViewTool> tool;
        std::filesystem::path begins_from = {};  ///< an example a new project is a copy of
    };

    RoomFocus room;

    /// The furniture library: a click adds a piece, a drag carries it to its place.
    Wish library(const Scene& scene, ObjectId chosen, WidgetRegistry& widgets);
    /// The library's tab comes to the front with the next frame.
    void show_library() { wants_library_ = true; }
    bool takes_library_wish() { return std::exchange(wants_library_, false); }

    void ask_new_room();
    /// With the plain room and these examples as other things to begin with.
    void ask_new_project(std::vector<std::filesystem::path> examples);
    void ask_array() { ask(Question::array); }
    void ask_circle(const Vec2& middle);
    bool is_asking() const { return question_ != Question::none; }
    /// Draws the open question. `scene` is without what the question previews.
    Wish questions(const Scene& scene, const Selection& selection, Form& form);

    /// A click beside all objects: the sub-area that lies there, or, while the room is chosen, one of its faces.
    std::optional<Selection> clicked(const Scene& scene, const Selection& before, const Ray& ray);

    void draw(const PaneSight& sight, WidgetRegistry& widgets) override;
    std::unique_ptr<ViewTool> take(const PaneSight& sight) override;

private:
    enum class Question { none, new_room, array, circle };
    void ask(Question question);
    bool begin(const char* title, float width);
    void close();
    Wish new_room_question(Form& form);
    Wish array_question(const Scene& scene, const Selection& selection, Form& form);
    Wish circle_question(const Scene& scene, const Selection& selection, Form& form);
    Wish preview(AddedSeveral made, bool changed, std::string step, WidgetRegistry& widgets);

    bool wants_library_ = false;
    std::string search_;
    Question question_ = Question::none;
    bool opening_ = false;
    bool begin_with(Form& form);
    void sizes(Form& form);
    NewRoom new_room_;
    int begins_with_ = 0;  ///< a room of sizes, the plain room, examples
    bool offers_ = false;  ///< the plain room and examples
    std::vector<std::filesystem::path> examples_;
    ArrayWish array_;
    CircleWish circle_;
};

}  // namespace hanei
