#include "ui/panels/several_panel.h"

#include "engine/edit/excerpt.h"

#include <imgui.h>

namespace hanei {
namespace {

/// Panels that are run without being shown draw here, beside the screen.
class BesideTheScreen {
public:
    explicit BesideTheScreen(Form& form) : form_(form) {
        ImGui::SetNextWindowPos({-4000.0F, -4000.0F});
        ImGui::SetNextWindowSize({300.0F, 300.0F});
        ImGui::Begin("##beside", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav |
                         ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoBringToFrontOnFocus);
        form_.begin("unseen");
    }
    ~BesideTheScreen() {
        form_.shared().end();
        form_.end();
        ImGui::End();
    }
    BesideTheScreen(const BesideTheScreen&) = delete;
    BesideTheScreen& operator=(const BesideTheScreen&) = delete;

private:
    Form& form_;
};

}  // namespace

ObjectIds others_alike(const Scene& scene, const Selection& selection) {
    ObjectIds others;
    for (const ObjectId id : selection.ids())
        if (id != selection.primary() && kind_of(scene, id) == kind_of(scene, selection.primary()))
            others.push_back(id);
    return others;
}

void SeveralPanel::read(const Scene& scene, const ObjectIds& others, Form& form) {
    form.shared().forget();
    if (others.empty()) return;
    const BesideTheScreen beside(form);
    form.shared().begin_reading();
    for (const ObjectId id : others) object_panel(scene, id, form);
}

std::optional<Scene> SeveralPanel::draw(const SceneSnapshot& scene, const Selection& selection, Form& form) {
    const ObjectIds others = others_alike(*scene, selection);
    if (read_scene_ != scene || read_selection_ != selection) {
        read(*scene, others, form);
        read_scene_ = scene;
        read_selection_ = selection;
    }
    std::optional<Scene> wished = object_panel(*scene, selection.primary(), form);
    RowValues& rows = form.shared();
    if (others.empty() || !rows.changed()) return wished;
    if (!wished) wished = *scene;  // the others may still differ from it
    const std::string name = rows.changed_name();
    const RowValues::Value value = rows.changed_value();
    const auto* text = std::get_if<std::string>(&value);
    const bool renamed = text != nullptr && name.ends_with(".name");
    const BesideTheScreen beside(form);
    for (const ObjectId id : others) {
        rows.begin_writing(name, renamed ? RowValues::Value(free_name(*wished, *text)) : value);
        if (std::optional<Scene> after = object_panel(*wished, id, form)) wished = std::move(after);
    }
    return wished;
}

}  // namespace hanei
