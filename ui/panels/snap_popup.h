/// What moved objects catch at, set in a small window.
#pragma once

#include "ui/panels/form.h"
#include "ui/panels/snapping.h"

namespace hanei {

class SnapPopup {
public:
    void open() { opening_ = true; }
    void draw(SnapSettings& settings, Form& form);

private:
    bool opening_ = false;
};

}  // namespace hanei
