#include "ui/panels/view_bar.h"

#include "engine/edit/edit.h"
#include "ui/panels/command.h"
#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/section.h"
#include "ui/panels/style.h"

#include <array>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

/// One of a row of buttons of which one is on.
bool segment(const char* label, bool on, CommandId id, WidgetRegistry& widgets) {
    ImGui::PushStyleColor(ImGuiCol_Button, on ? ImU32(style::chosen) : style::none);
    ImGui::PushStyleColor(ImGuiCol_Text, on ? style::accent : style::text);
    const bool pressed = ImGui::Button(label);
    ImGui::PopStyleColor(2);
    const Command& entry = command(id);
    widgets.note(std::string(entry.name));
    const std::string chord = to_text(entry.chord);
    tooltip(std::string(entry.help) + (chord.empty() ? "" : "  (" + chord + ")"));
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
    for (const Choice& choice : choices) {
        const bool on = !four && !state.options.shadow_classes && state.options.part == choice.part;
        if (segment(choice.label, on, choice.command, widgets)) state.show(choice.part, scene);
    }
    if (segment("Four", four, CommandId::four_up, widgets)) {
        state.toggle(PaneLayout::four_parts, scene);
        state.options.shadow_classes = false;
    }
}

void scale_menu(ViewState& state, const SolutionSnapshot& solution, WidgetRegistry& widgets) {
    if (ImGui::Button("Scale")) ImGui::OpenPopup("scale");
    widgets.note("view.scale");
    tooltip("Steps of the colour scale, isolux lines, exposure");
    if (!ImGui::BeginPopup("scale")) return;
    for (const ColourSteps steps : {ColourSteps::logarithmic, ColourSteps::linear, ColourSteps::standard_steps}) {
        std::string label(name_of(steps));
        if (label[0] >= 'a' && label[0] <= 'z') label[0] = static_cast<char>(label[0] - 'a' + 'A');
        if (ImGui::MenuItem(label.c_str(), nullptr, state.options.steps == steps)) state.options.steps = steps;
        widgets.note("scale." + std::string(name_of(steps)));
    }
    ImGui::Separator();
    if (ImGui::MenuItem("Fit to the values", "R", false, solution != nullptr)) {
        state.fit_asked = true;
    }
    widgets.note("scale.fit");
    ImGui::MenuItem("Isolux lines", "I", &state.options.isolux);
    widgets.note("scale.isolux");
    ImGui::MenuItem("Patches", "M", &state.options.mesh_lines);
    ImGui::MenuItem("Calculation points", "N", &state.options.grids);
    ImGui::MenuItem("Luminaires", nullptr, &state.options.luminaires);
    ImGui::Separator();
    auto exposure = static_cast<float>(state.options.exposure);
    ImGui::SetNextItemWidth(130.0F * style::scale());
    if (ImGui::SliderFloat("Exposure", &exposure, -5.0F, 5.0F, "%+.1f stops")) state.options.exposure = exposure;
    widgets.note("scale.exposure");
    tooltip("Of the photo-like picture, added to the automatic exposure");
    ImGui::EndPopup();
}

void shadows(ViewState& state, const Scene& scene, WidgetRegistry& widgets) {
    bool& outlines = state.options.shadow_outlines;
    const bool classes = state.options.shadow_classes && !state.panes.shows_parts();
    if (segment("Shadows", classes, CommandId::toggle_shadow_classes, widgets)) state.toggle_shadow_classes(scene);
    if (segment("Outlines", outlines, CommandId::toggle_shadow_outlines, widgets)) outlines = !outlines;
}

std::optional<ViewEdit> views_menu(ViewState& state, const Scene& scene, WidgetRegistry& widgets) {
    if (ImGui::Button(tr("Views"))) ImGui::OpenPopup("views");
    widgets.note("view.views");
    tooltip(tr("Ceiling, section plane, and cameras kept with the project. Ctrl+K keeps the present one"));
    if (!ImGui::BeginPopup("views")) return std::nullopt;
    section_rows(state.camera, bounds_of(scene), widgets);
    ImGui::Separator();
    std::optional<ViewEdit> edit = saved_view_rows(state, scene, widgets);
    ImGui::EndPopup();
    return edit;
}

}  // namespace

std::optional<ViewEdit> view_bar(ViewState& state, const Scene& scene, const SolutionSnapshot& solution,
                                 WidgetRegistry& widgets) {
    ImGui::PushStyleColor(ImGuiCol_Button, style::none);
    parts(state, scene, widgets);
    gap();
    const bool photo = state.options.scale == Scale::photo;
    const bool light = state.panes.shows_parts() || !state.options.shadow_classes;
    const auto choose = [&](const char* label, Scale scale, bool on) {
        if (!segment(label, light && on, CommandId::toggle_photo, widgets)) return;
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
