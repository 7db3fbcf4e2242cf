/// What the program is checked by: cases of its own, and values of others.
#pragma once

#include "ui/panels/measured_dialog.h"
#include "ui/panels/trust_dialog.h"
#include "ui/panels/validation_dialog.h"

namespace hanei {

struct Checks {
    /// As BackgroundWork.
    Checks(std::function<void()> wake, double patience)
        : validation(wake, patience), trust(std::move(wake), patience) {}
    ValidationDialog validation;
    TrustDialog trust;
    MeasuredDialog measured{};
    bool is_open() const { return validation.is_open() || trust.is_open() || measured.is_open(); }
    void draw(WidgetRegistry& widgets) {
        validation.draw(widgets);
        trust.draw(widgets);
        measured.draw(widgets);
    }
};

}  // namespace hanei
