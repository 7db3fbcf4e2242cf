#include "engine/edit/edit.h"
#include "ui/panels/workbench.h"

#include <imgui.h>

namespace hanei {

void Workbench::read_preferences() {
    UserDoor::Opened opened = keeper_.open();
    preferences_ = std::move(opened.preferences);
    messages_.note("Preferences", opened.findings);
    if (!opened.findings.empty()) message_ = "Preferences could not be read whole";
    if (!document_.file().empty()) keeper_.remember_project(preferences_, document_.file());
}

/// A panel's edge that is being dragged is kept when it is let go.
void Workbench::keep_preferences() {
    if (ImGui::IsAnyItemActive()) return;
    if (const auto fault = keeper_.keep(preferences_)) {
        messages_.note("Preferences", *fault);
        message_ = "Preferences could not be kept";
    }
}

bool Workbench::is_asking() const {
    return dialogs_.kind() != Dialogs::Kind::none || browser_.is_open() || preferences_dialog_.is_open();
}

void Workbench::start_anew() {
    document_ = Document({empty_room(), {}});
    selection_.clear();
    viewport_.state.range_fitted = false;
    shows_overview_ = true;
    message_ = "A new room";
}

}  // namespace hanei
