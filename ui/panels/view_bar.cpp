#include "ui/panels/view_bar.h"

#include "engine/edit/edit.h"
#include "ui/panels/command.h"
#include "ui/panels/form.h"
#include "ui/panels/icon.h"
#include "ui/panels/language.h"
#include "ui/panels/section.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

/// Where words find no room, the parts of the light become a list, then drawings stand for words, and
/// what is left goes to a second row.
enum class Fit { words, list, drawings };
Fit fit = Fit::words;
bool is_narrow() { return fit == Fit::drawings; }

/// Goes to the next row when an item of this width has no room in this one.
void flow(float width) {
    if (ImGui::GetCursorPosX() + width > ImGui::GetContentRegionMax().x) ImGui::NewLine();
}

float width_of_button(const char* word) {
    return ImGui::CalcTextSize(tr(word)).x + 2.0F * ImGui::GetStyle().FramePadding.x;
}

std::string help_of(const Command& entry) {
    const std::string chord = to_text(entry.chord);
    return fmt::format("{}{}{}{}", tr(entry.help), chord.empty() ? "" : "  (", chord, chord.empty() ? "" : ")");
}

/// One of a row of buttons of which one is on.
bool segment(const char* label, bool on, CommandId id, WidgetRegistry& widgets, Icon icon = Icon::none) {
    const Command& entry = command(id);
    flow(is_narrow() && icon != Icon::none ? ImGui::GetFrameHeight() : width_of_button(label));
    if (is_narrow() && icon != Icon::none) {
        const bool chosen = icon_button(std::string(entry.name).c_str(), icon, help_of(entry), on, widgets);
        ImGui::SameLine(0.0F, 2.0F * style::scale());
        return chosen;
    }
    ImGui::PushStyleColor(ImGuiCol_Button, on ? ImU32(style::chosen) : style::none);
    ImGui::PushStyleColor(ImGuiCol_Text, on ? style::accent : style::text);
    const bool pressed = ImGui::Button(fmt::format("{}##{}", tr(label), label).c_str());
    ImGui::PopStyleColor(2);
    widgets.note(std::string(entry.name));
    tooltip(help_of(entry));
    ImGui::SameLine(0.0F, 2.0F * style::scale());
    return pressed;
}

void gap() {
    ImGui::SameLine(0.0F, 6.0F * style::scale());
    if (ImGui::GetCursorPosX() + ImGui::GetFrameHeight() > ImGui::GetContentRegionMax().x) return;  // a row's end
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight();
    ImGui::GetWindowDrawList()->AddLine({at.x, at.y + 4.0F}, {at.x, at.y + height - 4.0F},
                                        ImGui::GetColorU32(ImGuiCol_Separator));
    ImGui::Dummy({1.0F, height});
    ImGui::SameLine(0.0F, 5.0F * style::scale());
}

/// Of the list of the parts of the light.
float width_of_list() {
    float widest = 0.0F;
    for (const char* word : {"Total", "Direct", "Interreflected", "Unshadowed", "Four"})
        widest = std::max(widest, ImGui::CalcTextSize(tr(word)).x);
    return widest + 2.0F * ImGui::GetStyle().FramePadding.x + ImGui::GetFrameHeight();
}

void parts(ViewState& state, const Scene& scene, WidgetRegistry& widgets) {
    struct Choice {
        const char* label;
        LightPart part;
        CommandId command;
    };
    constexpr std::array choices{
        Choice{"Total", LightPart::total, CommandId::part_total},
        Choice{"Direct", LightPart::direct, CommandId::part_direct},
        Choice{"Interreflected", LightPart::interreflected, CommandId::part_interreflected},
        Choice{"Unshadowed", LightPart::unshadowed, CommandId::part_unshadowed},
    };
    const bool four = state.panes.shows_parts();
    const auto is_on = [&](const Choice& choice) {
        return !four && !state.options.shadow_classes && state.options.part == choice.part;
    };
    const auto found = std::find_if(choices.begin(), choices.end(), is_on);
    const char* const present = found == choices.end() ? "Four" : found->label;
    if (fit == Fit::words) {
        for (const Choice& choice : choices)
            if (segment(choice.label, is_on(choice), choice.command, widgets)) state.show(choice.part, scene);
    } else {
        ImGui::SetNextItemWidth(width_of_list());
        if (ImGui::BeginCombo("##part", tr(present))) {
            for (const Choice& choice : choices) {
                if (ImGui::Selectable(tr(choice.label), is_on(choice))) state.show(choice.part, scene);
                widgets.note(fmt::format("view.part.{}", choice.label));
            }
            ImGui::EndCombo();
        }
        widgets.note("view.part");
        tooltip("Which light is shown");
        ImGui::SameLine(0.0F, 2.0F * style::scale());
    }
    if (segment("Four", four, CommandId::four_up, widgets, Icon::four)) {
        state.toggle(PaneLayout::four_parts, scene);
        state.options.shadow_classes = false;
    }
}

/// A word, or its drawing, that opens a menu.
bool opener(const char* label, const char* name, Icon icon, const char* help, WidgetRegistry& widgets) {
    flow(is_narrow() ? ImGui::GetFrameHeight() : width_of_button(label));
    if (is_narrow()) return icon_button(name, icon, tr(help), false, widgets);
    const bool pressed = ImGui::Button(fmt::format("{}##{}", tr(label), label).c_str());
    widgets.note(name);
    tooltip(help);
    return pressed;
}

void scale_menu(ViewState& state, const SolutionSnapshot& solution, WidgetRegistry& widgets) {
    if (opener("Scale", "view.scale", Icon::fit, "Steps of the colour scale, isolux lines, exposure", widgets))
        ImGui::OpenPopup("scale");
    if (!ImGui::BeginPopup("scale")) return;
    for (const ColourSteps steps : {ColourSteps::logarithmic, ColourSteps::linear, ColourSteps::standard_steps}) {
        std::string label(name_of(steps));
        if (label[0] >= 'a' && label[0] <= 'z') label[0] = static_cast<char>(label[0] - 'a' + 'A');
        if (ImGui::MenuItem(tr(label.c_str()), nullptr, state.options.steps == steps)) state.options.steps = steps;
        widgets.note("scale." + std::string(name_of(steps)));
    }
    ImGui::Separator();
    if (ImGui::MenuItem(tr("Fit to the values"), "R", false, solution != nullptr)) {
        state.fit_asked = true;
    }
    widgets.note("scale.fit");
    ImGui::MenuItem(tr("Isolux lines"), "I", &state.options.isolux);
    widgets.note("scale.isolux");
    ImGui::MenuItem(tr("Patches"), "M", &state.options.mesh_lines);
    ImGui::MenuItem(tr("Calculation points"), "N", &state.options.grids);
    ImGui::MenuItem(tr("Luminaires"), nullptr, &state.options.luminaires);
    ImGui::Separator();
    auto exposure = static_cast<float>(state.options.exposure);
    ImGui::SetNextItemWidth(130.0F * style::scale());
    if (ImGui::SliderFloat(tr("Exposure"), &exposure, -5.0F, 5.0F, tr("%+.1f stops")))
        state.options.exposure = exposure;
    widgets.note("scale.exposure");
    tooltip("Of the photo-like picture, added to the automatic exposure");
    ImGui::EndPopup();
}

void shadows(ViewState& state, const Scene& scene, WidgetRegistry& widgets) {
    bool& outlines = state.options.shadow_outlines;
    const bool classes = state.options.shadow_classes && !state.panes.shows_parts();
    if (segment("Shadows", classes, CommandId::toggle_shadow_classes, widgets, Icon::shadows))
        state.toggle_shadow_classes(scene);
    if (segment("Outlines", outlines, CommandId::toggle_shadow_outlines, widgets, Icon::section)) outlines = !outlines;
}

std::optional<ViewEdit> views_menu(ViewState& state, const Scene& scene, WidgetRegistry& widgets) {
    if (opener("Views", "view.views", Icon::view,
               "Ceiling, section plane, and cameras kept with the project. Ctrl+K keeps the present one", widgets))
        ImGui::OpenPopup("views");
    if (!ImGui::BeginPopup("views")) return std::nullopt;
    section_rows(state.camera, bounds_of(scene), "section", widgets);
    ImGui::Separator();
    std::optional<ViewEdit> edit = saved_view_rows(state, scene, widgets);
    ImGui::EndPopup();
    return edit;
}

/// Of the whole bar with its words, the parts of the light side by side or as a list.
float width_of_words(bool with_list) {
    const float gap = 2.0F * style::scale();
    float width = 3.0F * 12.0F * style::scale();      // between groups
    width += 2.0F * (ImGui::GetFrameHeight() + gap);  // tools
    if (with_list)
        width += width_of_list() + gap;
    else
        for (const char* word : {"Total", "Direct", "Interreflected", "Unshadowed"})
            width += width_of_button(word) + gap;
    for (const char* word : {"Four", "False colour", "Photo", "Shadows", "Outlines", "Scale", "Views"})
        width += width_of_button(word) + gap;
    return width;
}

int rows = 1;  ///< of the frame before
float first_row = 0.0F;

}  // namespace

std::optional<ViewEdit> view_bar(ViewState& state, const Scene& scene, const SolutionSnapshot& solution,
                                 WidgetRegistry& widgets) {
    const float room = ImGui::GetContentRegionAvail().x;
    first_row = ImGui::GetCursorPosY();
    fit = room >= width_of_words(false) ? Fit::words : room >= width_of_words(true) ? Fit::list : Fit::drawings;
    ImGui::PushStyleColor(ImGuiCol_Button, style::none);
    parts(state, scene, widgets);
    gap();
    const bool photo = state.options.scale == Scale::photo;
    const bool light = state.panes.shows_parts() || !state.options.shadow_classes;
    const auto choose = [&](const char* label, Scale scale, bool on) {
        const Icon icon = scale == Scale::photo ? Icon::photo : Icon::false_colours;
        if (!segment(label, light && on, CommandId::toggle_photo, widgets, icon)) return;
        state.options.scale = scale;
        state.options.shadow_classes = false;
    };
    choose("False colour", Scale::false_colour, !photo);
    choose("Photo", Scale::photo, photo);
    gap();
    shadows(state, scene, widgets);
    gap();
    scale_menu(state, solution, widgets);
    ImGui::SameLine(0.0F, 2.0F * style::scale());
    std::optional<ViewEdit> edit = views_menu(state, scene, widgets);
    ImGui::PopStyleColor();
    return edit;
}

void flow_in_view_bar(float width) { flow(width); }

void end_view_bar() {
    const float height = ImGui::GetCursorPosY() - first_row;
    rows = std::max(1, static_cast<int>(std::lround(height / ImGui::GetFrameHeightWithSpacing())));
}

float view_bar_height() {
    const float rest = 12.0F * style::scale(), row = ImGui::GetFrameHeightWithSpacing();
    return static_cast<float>(rows) * row - ImGui::GetStyle().ItemSpacing.y + rest;
}

}  // namespace hanei
