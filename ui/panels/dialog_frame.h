/// What all dialogs share: a frame in the middle of the window, and buttons at its right end.
#pragma once

#include "ui/panels/widget_registry.h"

#include <string>

namespace hanei {

/// Opens the frame in the frame in which `opening` is set, which it clears; `width` at scale 1, the height
/// follows from the content. `stays` is cleared when the user closed it. Call ImGui::EndPopup() when true.
bool begin_dialog(const std::string& label, float width, bool& opening, bool& stays);

/// Room above, and the cursor where `count` buttons end at the right border.
void buttons_from_right(int count);

/// One of them, with a translated label.
bool dialog_button(const char* label, const char* name, WidgetRegistry& widgets);

/// The key that says no, while no text is typed.
bool escape_pressed();

}  // namespace hanei
