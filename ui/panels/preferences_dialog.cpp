#include "ui/panels/preferences_dialog.h"

#include "ui/panels/dialog_frame.h"
#include "ui/panels/language.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

constexpr std::array scales{0.0, 1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0};

template <class T>
void choose(Form& form, const char* name, const char* label, const char* help, const std::vector<std::string>& names,
            T& value) {
    int chosen = static_cast<int>(value);
    if (form.choice(name, label, help, names, chosen)) value = static_cast<T>(chosen);
}

void choose_scale(Form& form, double& scale) {
    std::vector<std::string> names;
    int chosen = 0;
    for (std::size_t k = 0; k < scales.size(); ++k) {
        names.push_back(k == 0 ? tr("As the screen says") : fmt::format("{:.0f} %", 100.0 * scales[k]));
        if (std::abs(scales[k] - scale) < 0.01) chosen = static_cast<int>(k);
    }
    if (form.choice("preferences.scale", "Size", "Of letters, fields and distances in the window", names, chosen))
        scale = scales[static_cast<std::size_t>(chosen)];
}

void look(Preferences& preferences, Form& form) {
    form.heading("Look");
    choose(form, "preferences.language", "Language", "Of everything on the screen; names you gave stay as they are",
           {"English", "日本語"}, preferences.language);
    choose(form, "preferences.theme", "Theme", "Dark beside a dark room on the screen, light in a bright office",
           {tr("Dark"), tr("Bright")}, preferences.theme);
    choose_scale(form, preferences.scale);
    form.toggle("preferences.layout", "Panels", "Panels have the sizes of the last time when the program starts",
                preferences.restores_layout);
    form.toggle("preferences.glides", "Gliding", "The picture glides from one view to another in a quarter of a second",
                preferences.glides);
}

void units(Preferences& preferences, Form& form) {
    form.heading("Units");
    choose(form, "preferences.length", "Lengths", "In fields and on the screen; files stay in metres",
           {tr("Metres"), tr("Centimetres"), tr("Millimetres"), tr("Feet and inches")}, preferences.length);
    choose(form, "preferences.illuminance", "Illuminance", "In tables and on the screen; files stay in lux",
           {tr("Lux"), tr("Foot-candles")}, preferences.illuminance);
}

void keeping(Preferences& preferences, Form& form) {
    form.heading("Files");
    form.number(
        {"preferences.autosave", "Keep work", "s",
         "Unsaved work is kept for recovery after every step, and at least this often during one", 5.0, 600.0, 1.0, 0},
        preferences.autosave);
    form.toggle("preferences.start", "Start page", "What to begin with is asked when no project is named",
                preferences.shows_start_page);
}

}  // namespace

void PreferencesDialog::draw(Preferences& preferences, Form& form) {
    if (!open_) return;
    const std::string label = fmt::format("{}###preferences", tr("Preferences"));
    if (!begin_dialog(label, 720.0F, opening_, open_)) return;
    ImGui::BeginTable("sides", 2, ImGuiTableFlags_SizingStretchSame);
    ImGui::TableNextColumn();
    form.begin("look");
    look(preferences, form);
    form.end();
    ImGui::TableNextColumn();
    form.begin("units");
    units(preferences, form);
    keeping(preferences, form);
    form.end();
    ImGui::EndTable();
    buttons_from_right(2);
    if (dialog_button("Defaults", "preferences.defaults", form.widgets())) {
        Preferences usual;
        usual.recent = preferences.recent;
        usual.unknown = preferences.unknown;
        preferences = usual;
    }
    tooltip("Everything here, and the panels' sizes, as it is at first");
    ImGui::SameLine();
    if (dialog_button("Close", "preferences.close", form.widgets()) || escape_pressed()) open_ = false;
    if (!open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace hanei
