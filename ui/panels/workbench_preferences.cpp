#include "ui/panels/checks.h"
#include "ui/panels/workbench.h"

#include <imgui.h>

namespace hanei {

void Workbench::read_preferences() {
    UserDoor::Opened opened = keeper_.open();
    preferences_ = std::move(opened.preferences);
    messages_.note("Preferences", opened.findings);
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
    return dialogs_.kind() != Dialogs::Kind::none || browser_.is_open() || preferences_dialog_.is_open() ||
           recovery_.is_open() || furnishing_.is_asking() || export_dialog_.is_open() || model_import_.is_open() ||
           start_layout_.is_open() || start_page_.is_open() || checks_->is_open();
}

}  // namespace hanei
