#include "ui/panels/style.h"
#include "ui/panels/workbench.h"

#include <array>
#include <cmath>

namespace hanei {
namespace {

using enum CommandId;

constexpr double scale_step = 0.25;

constexpr std::string_view group = "Letters and colours";

constexpr std::array table{
    Command{switch_theme,
            "view.theme",
            "View",
            "Light colours",
            "A light window instead of a dark one",
            {},
            {},
            true,
            group},
    Command{switch_language,
            "view.language",
            "View",
            "日本語 (Japanese)",
            "The window in Japanese instead of English",
            {},
            {},
            false,
            group},
    Command{larger,
            "view.larger",
            "View",
            "Larger",
            "Larger letters and controls, up to 300 %",
            {Key::plus, true},
            {Key::keypad_plus, true},
            false,
            group},
    Command{smaller,
            "view.smaller",
            "View",
            "Smaller",
            "Smaller letters and controls, down to 100 %",
            {Key::minus, true},
            {Key::keypad_minus, true},
            false,
            group},
    Command{usual_size,
            "view.usual_size",
            "View",
            "Usual size",
            "Letters and controls as large as the screen asks for",
            control('0'),
            {},
            false,
            group},
};

/// The next quarter above or below.
double stepped(double scale, double by) {
    const double steps = scale / scale_step;
    const double next = by > 0.0 ? std::floor(steps + 1e-6) + 1.0 : std::ceil(steps - 1e-6) - 1.0;
    return next * scale_step;
}

constexpr double least = static_cast<double>(style::least_scale), greatest = static_cast<double>(style::greatest_scale);

}  // namespace

std::span<const Command> look_menu() { return table; }

bool Workbench::can_look(CommandId id) const {
    const auto scale = static_cast<double>(style::scale());
    if (id == larger) return scale < greatest;
    if (id == smaller) return scale > least;
    return true;
}

/// What is chosen here is taken up before the next frame.
void Workbench::do_look(CommandId id) {
    const auto scale = static_cast<double>(style::scale());
    switch (id) {
        case switch_theme:
            preferences_.theme = preferences_.theme == Theme::dark ? Theme::light : Theme::dark;
            return;
        case switch_language:
            preferences_.language = preferences_.language == Language::english ? Language::japanese : Language::english;
            if (preferences_.language == Language::japanese && !style::has_japanese())
                message_ = "No Japanese letters are installed: install fonts-morisawa-bizud-gothic.";
            return;
        case larger:
            preferences_.scale = stepped(scale, 1.0);
            return;
        case smaller:
            preferences_.scale = stepped(scale, -1.0);
            return;
        case usual_size:
            preferences_.scale = 0.0;
            return;
        default:
            return;
    }
}

}  // namespace hanei
