/// Rows of labelled fields with units, aligned: label, field, unit.
///
/// A dragged number changes on every frame; a typed one when it is finished (Enter, Tab, a click
/// elsewhere), so that no half-typed figure is ever solved. Escape gives a typed one up. Figures are
/// shown in the units of the preferences (units.h) and calculated when typed (expression.h); one that
/// cannot be read is framed with the reason, and the old value stays.
#pragma once

#include "engine/base/vector.h"
#include "ui/panels/row_values.h"
#include "ui/panels/widget_registry.h"

#include <imgui.h>
#include <span>
#include <string>

namespace hanei {

struct NumberField {
    const char* name;  ///< for scripts: "luminaire.x"
    const char* label;
    const char* unit;  ///< in which the value is kept
    const char* help;
    double low, high;
    double step;  ///< change a pixel of dragging
    int decimals;
};

class Form {
public:
    explicit Form(WidgetRegistry& widgets) : widgets_(widgets) {}

    void begin(const char* id);
    void end();
    void heading(const char* text);

    /// All return true when the value changed.
    bool number(const NumberField& field, double& value);
    bool text(const char* name, const char* label, const char* help, std::string& value);
    bool toggle(const char* name, const char* label, const char* help, bool& value);
    /// `marks`, one a name when there are any, stand before the names as dots.
    bool choice(const char* name, const char* label, const char* help, std::span<const std::string> names, int& chosen,
                std::span<const ImU32> marks = {});
    /// Encoded sRGB, 0 to 1: a patch of it that opens a picker, and its six hexadecimal digits.
    bool colour(const char* name, const char* label, const char* help, Vec3& srgb);
    void fact(const char* label, const std::string& value, const char* unit = "");  ///< not for editing
    bool button(const char* name, const char* label, const char* help);
    void remark(const std::string& text, bool warning);  ///< over the whole width

    /// A value changed in this frame by typing or choosing: the gesture is over at once.
    bool finished() const { return finished_; }
    void begin_frame();

    WidgetRegistry& widgets() { return widgets_; }

    /// For panels that stand for several objects (several_panel.h).
    RowValues& shared() { return shared_; }

private:
    void label(const char* text, const char* help);
    void unit(const char* text);
    bool accept_typed(bool edited, bool typing);
    bool typed(const char* name, const char* help, std::string& value, bool mixed);

    WidgetRegistry& widgets_;
    bool finished_ = false;
    unsigned typing_ = 0;  ///< the ImGui item text is being typed into
    std::string typed_text_, typed_figure_;
    struct Refused {
        unsigned item = 0;
        std::string fault{};
    };
    Refused refused_;  ///< the field whose text could not be read, until something else is done
    RowValues shared_;
    Vec3 picked_{0.0};  ///< what the open picker points at, which a surface may be unable to show
};

/// Shows the text when the last item is hovered.
void tooltip(const char* text);
void tooltip(const std::string& text);

}  // namespace hanei
