#include "ui/panels/legend_scale.h"

#include "ui/panels/form.h"
#include "ui/panels/illuminance_text.h"
#include "ui/panels/language.h"
#include "ui/panels/project_scale.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace hanei {
namespace {

constexpr double least_lux = 0.1, greatest_lux = 1e6;

double rounded(double lux, IlluminanceUnit unit) {
    const double shown = lux / lux_in(unit);
    if (!(shown > 0.0)) return lux;
    const double step = std::pow(10.0, std::floor(std::log10(shown)) - 1.0);
    return step * std::round(shown / step) * lux_in(unit);
}

struct StepsChoice {
    ColourSteps steps;
    const char* button;
    const char* label;
    const char* name;
    const char* help;
};
constexpr std::array choices{
    StepsChoice{ColourSteps::logarithmic, "Log", "Logarithmic", "log", "Equal ratios look alike: for whole rooms"},
    StepsChoice{ColourSteps::linear, "Linear", "Linear", "linear", "Equal differences look alike: for one task area"},
    StepsChoice{ColourSteps::standard_steps, "EN steps", "Steps of EN 12464-1", "en",
                "One colour from each step of the standard to the next: 20 30 50 75 100 150 ... lx"}};

/// The user's own levels of isolux lines. What was typed is taken when the field is left.
void levels_field(ViewState& state, WidgetRegistry& widgets) {
    ViewOptions& look = state.options;
    if (!state.levels_typed) state.levels_typed = levels_text(look.isolux_levels, look.unit);
    ImGui::SetNextItemWidth(170.0F * style::scale());
    ImGui::InputTextWithHint("##levels", tr("as the steps"), &*state.levels_typed);
    widgets.note("legend.levels");
    tooltip(tr("Levels of the isolux lines, such as 100 300 500; empty: the steps of the scale"));
    const auto levels = levels_in(*state.levels_typed, look.unit);
    if (ImGui::IsItemDeactivatedAfterEdit() && levels) look.isolux_levels = *levels;
    if (!ImGui::IsItemActive() && levels) state.levels_typed.reset();
    ImGui::SameLine();
    ImGui::TextUnformatted(illuminance_unit_name());
    if (!levels)
        ImGui::TextColored(style::colour(style::warning), "%s", tr("Write figures above 0, 64 at most: 100 300 500"));
}

}  // namespace

LuxRange range_dragged(const ViewOptions& look, bool top, double share) {
    LuxRange range = look.range;
    double& end = top ? range.high : range.low;
    if (look.steps == ColourSteps::linear) {
        end += share * (look.range.high - look.range.low);
    } else {
        end *= std::pow(look.range.high / std::max(look.range.low, least_lux), share);
    }
    end = rounded(std::clamp(end, least_lux, greatest_lux), look.unit);
    if (top)
        range.high = std::max(range.high, 1.01 * range.low + 0.01);
    else
        range.low = std::min(range.low, range.high / 1.01);
    return range;
}

void legend_menu(ViewState& state, bool of_project, float width, WidgetRegistry& widgets) {
    ViewOptions& look = state.options;
    const auto chosen = std::find_if(choices.begin(), choices.end(),
                                     [&](const StepsChoice& choice) { return choice.steps == look.steps; });
    if (ImGui::Button(fmt::format("{}###legend steps", tr(chosen->button)).c_str(), {width, 0.0F}))
        ImGui::OpenPopup("legend menu");
    widgets.note("legend.steps");
    tooltip(tr("Steps, isolux levels and what lies outside the scale"));
    if (!ImGui::BeginPopup("legend menu")) {
        state.levels_typed.reset();
        return;
    }
    for (const StepsChoice& choice : choices) {
        if (ImGui::MenuItem(tr(choice.label), nullptr, look.steps == choice.steps)) look.steps = choice.steps;
        widgets.note(fmt::format("legend.{}", choice.name));
        tooltip(tr(choice.help));
    }
    ImGui::Separator();
    ImGui::MenuItem(tr("Hatch what lies outside"), nullptr, &look.marks_clipped);
    widgets.note("legend.clipped");
    tooltip(tr("Stripes where there is less light than the scale shows, crossed stripes where there is more"));
    ImGui::MenuItem(tr("Isolux lines"), "I", &look.isolux);
    widgets.note("legend.isolux");
    tooltip(tr("Lines of equal illuminance"));
    levels_field(state, widgets);
    ImGui::Separator();
    if (ImGui::MenuItem(tr("Fit to the values"), "R")) state.fit_asked = true;
    widgets.note("legend.fit");
    tooltip(tr("Round ends about what the surfaces of the room show"));
    if (ImGui::MenuItem(tr("Kept with the project"), nullptr, of_project)) {
        state.automatic_asked = of_project;
        state.keep_asked = !of_project;
    }
    widgets.note("legend.kept");
    tooltip(
        tr("Every picture of the project has this scale. Otherwise it is fitted to the light when the project is "
           "opened. A change of the scale keeps it"));
    ImGui::EndPopup();
}

}  // namespace hanei
