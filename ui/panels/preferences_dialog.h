/// Where the user says how the program shall look and keep work.
#pragma once

#include "ui/panels/form.h"
#include "ui/panels/preferences.h"

namespace hanei {

/// Changes take effect as they are made; there is nothing to confirm.
class PreferencesDialog {
public:
    void open() { open_ = opening_ = true; }
    bool is_open() const { return open_; }

    /// Once a frame, with a form that no other panel has open.
    void draw(Preferences& preferences, Form& form);

private:
    bool open_ = false, opening_ = false;
};

}  // namespace hanei
