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
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

/// Where words find no room, drawings stand for them.
bool is_narrow = false;

std::string help_of(const Command& entry) {
    const std::string chord = to_text(entry.chord);
    return fmt::format("{}{}{}{}", tr(entry.help), chord.empty() ? "" : "  (", chord, chord.empty() ? "" : ")");
}

/// One of a row of buttons of which one is on.
bool segment(const char* label, bool on, CommandId id, WidgetRegistry& widgets, Icon icon = Icon::none) {
    const Command& entry = command(id);
    if (is_narrow && icon != Icon::none) {
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
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight();
    ImGui::GetWindowDrawList()->AddLine({at.x, at.y + 4.0F}, {at.x, at.y + height - 4.0F},
                                        ImGui::GetColorU32(ImGuiCol_Separator));
    ImGui::Dummy({1.0F, height});
    ImGui::SameLine(0.0F, 5.0F * style::scale());
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
    const float arrow = ImGui::GetFrameHeight();
    if (is_narrow) ImGui::SetNextItemWidth(ImGui::CalcTextSize(tr("Interreflected")).x + arrow);
    if (is_narrow && ImGui::BeginCombo("##part", tr(present))) {
        for (const Choice& choice : choices) {
            if (ImGui::Selectable(tr(choice.label), is_on(choice))) state.show(choice.part, scene);
        }
        ImGui::EndCombo();
    }
    if (is_narrow) {
        widgets.note("view.part");
        tooltip("Which light is shown");
        ImGui::SameLine(0.0F, 2.0F * style::scale());
    }
    for (const Choice& choice : choices) {
        if (!is_narrow && segment(choice.label, is_on(choice), choice.command, widgets)) state.show(choice.part, scene);
    }
    if (segment("Four", four, CommandId::four_up, widgets, Icon::four)) {
        state.toggle(PaneLayout::four_parts, scene);
        state.options.shadow_classes = false;
    }
}

/// A word, or its drawing, that opens a menu.
bool opener(const char* label, const char* name, Icon icon, const char* help, WidgetRegistry& widgets) {
    if (is_narrow) return icon_button(name, icon, tr(help), false, widgets);
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

/// Of the whole bar with its words.
float width_of_words() {
    const float padding = 2.0F * ImGui::GetStyle().FramePadding.x + 2.0F * style::scale();
    float width = 3.0F * 12.0F * style::scale();                        // the gaps
    width += 2.0F * (ImGui::GetFrameHeight() + 2.0F * style::scale());  // tools
    for (const char* word : {"Total", "Direct", "Interreflected", "Unshadowed", "Four", "False colour", "Photo",
                             "Shadows", "Outlines", "Scale", "Views"})
        width += ImGui::CalcTextSize(tr(word)).x + padding;
    return width;
}

}  // namespace

std::optional<ViewEdit> view_bar(ViewState& state, const Scene& scene, const SolutionSnapshot& solution,
                                 WidgetRegistry& widgets) {
    is_narrow = ImGui::GetContentRegionAvail().x < width_of_words();
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

}  // namespace hanei
