/// Several buttons in one row of a form, wrapped where the panel ends.
#pragma once

#include "ui/panels/form.h"

#include <span>
#include <string>

namespace hanei {

struct ButtonText {
    std::string name;  ///< for scripts: "room.add.door"
    std::string label;
    std::string help;
};

/// The number of the button that was pressed, or -1.
int button_row(const char* label, std::span<const ButtonText> buttons, Form& form);

}  // namespace hanei
