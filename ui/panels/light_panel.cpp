#include "ui/panels/light_panel.h"

#include "engine/edit/arrangements.h"
#include "ui/panels/elided.h"
#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/panel_frame.h"
#include "ui/panels/property_rows.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace hanei {
namespace {

constexpr float small_button = 44.0F;  // pixels at scale 1: "Alone" in small letters
constexpr std::size_t scenes_by_key = 9;

/// Of a button in small letters.
float small_width(const char* label) {
    ImGui::PushFont(style::fonts().small);
    const float words = ImGui::CalcTextSize(tr(label)).x + 2.0F * ImGui::GetStyle().FramePadding.x;
    ImGui::PopFont();
    return std::max(small_button * style::scale(), words);
}

bool small(const char* label, const std::string& name, const char* help, bool pressed_in, WidgetRegistry& widgets) {
    const float width = small_width(label);
    ImGui::PushFont(style::fonts().small);
    if (pressed_in) {
        ImGui::PushStyleColor(ImGuiCol_Button, style::accent);
        ImGui::PushStyleColor(ImGuiCol_Text, style::ground);
    }
    const bool pressed = ImGui::Button(fmt::format("{}##{}", tr(label), name).c_str(), {width, 0.0F});
    if (pressed_in) ImGui::PopStyleColor(2);
    ImGui::PopFont();
    widgets.note(name);
    tooltip(help);
    return pressed;
}

bool wide(const char* label, const char* name, const char* help, WidgetRegistry& widgets) {
    const bool pressed = ImGui::Button(fmt::format("{}##{}", tr(label), name).c_str(), {-FLT_MIN, 0.0F});
    widgets.note(name);
    tooltip(help);
    return pressed;
}

}  // namespace

std::string recall_step(const LightScene& light_scene) { return "Switch to " + light_scene.name; }

bool is_alone(const Scene& scene, ObjectId group) {
    return scene.control_groups.size() > 1 &&
           std::all_of(scene.control_groups.begin(), scene.control_groups.end(),
                       [&](const ControlGroup& each) { return (each.dimming > 0.0) == (each.id == group); });
}

LightPanel::Outcome LightPanel::switched(const Scene& scene, const ControlGroup& group) {
    if (group.dimming > 0.0) {
        level_before_off_[group.id] = group.dimming;
        return {dimmed(scene, group.id, 0.0), "Switch off " + group.name, true, {}};
    }
    const auto before = level_before_off_.find(group.id);
    const double level = before == level_before_off_.end() ? 1.0 : before->second;
    return {dimmed(scene, group.id, level), "Switch on " + group.name, true, {}};
}

LightPanel::Outcome LightPanel::soloed(const Scene& scene, const ControlGroup& group) {
    if (is_alone(scene, group.id) && solo_ && solo_->group == group.id) {
        const std::vector<LightScene::Level> before = std::move(solo_->before);
        solo_.reset();
        return {with_levels(scene, before), "All groups again", true, {}};
    }
    if (!solo_ || !is_alone(scene, solo_->group))
        solo_ = Solo{group.id, present_levels(scene)};
    else
        solo_->group = group.id;  // from one alone to another: all come back as they were before the first
    return {alone(scene, group.id), group.name + " alone", true, {}};
}

void LightPanel::dimmer(const Scene& scene, const ControlGroup& group, WidgetRegistry& widgets, Outcome& outcome) {
    double percent = 100.0 * group.dimming;
    constexpr double off = 0.0, full = 100.0;
    const float figure = 58.0F * style::scale();
    ImGui::SetNextItemWidth(
        std::max(40.0F * style::scale(), ImGui::GetContentRegionAvail().x - figure - ImGui::GetStyle().ItemSpacing.x));
    const std::string name = "light.dimmer." + group.name, level = "light.level." + group.name;
    bool moved = ImGui::SliderScalar(("##" + name).c_str(), ImGuiDataType_Double, &percent, &off, &full, "",
                                     ImGuiSliderFlags_AlwaysClamp);
    widgets.note(name);
    tooltip("Dimmer of the group: drag it, all light follows");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-FLT_MIN);
    moved |= ImGui::DragScalar(("##" + level).c_str(), ImGuiDataType_Double, &percent, 0.5F, &off, &full, "%.0f %%",
                               ImGuiSliderFlags_AlwaysClamp);
    widgets.note(level);
    tooltip("Dimmer of the group: drag it, or double-click to type");
    if (!moved || !std::isfinite(percent)) return;
    outcome = {dimmed(scene, group.id, percent / 100.0), "Dim " + group.name, false, {}};
}

void LightPanel::group(const Scene& scene, const ControlGroup& group, const std::vector<ObjectId>& luminaires,
                       const Selection& selection, WidgetRegistry& widgets, Outcome& outcome) {
    const float scale = style::scale();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight(), radius = 4.0F * scale;
    const ImU32 mark = group.dimming > 0.0 ? mark_of_light(group.colour_temperature) : style::quiet_text;
    const int members = members_of(scene, group.id);
    const float buttons = small_width("Alone") + small_width("Off") + 2.0F * ImGui::GetStyle().ItemSpacing.x;
    const float room = std::max(40.0F * scale, ImGui::GetContentRegionAvail().x - buttons);
    const std::string words =
        elided(fmt::format("{}   {}", group.name, members), room - ImGui::CalcTextSize("      ").x, Elide::middle);
    const std::string label = fmt::format("      {}###name", words);
    ImGui::AlignTextToFramePadding();
    if (ImGui::Selectable(label.c_str(), selection.primary() == group.id, 0, {room, 0.0F})) outcome.chosen = group.id;
    widgets.note("light.group." + group.name);
    tooltip(say("{}: {} in it. Click to see its name, colour and members", group.name, members));
    ImGui::GetWindowDrawList()->AddCircleFilled({at.x + 2.0F * radius, at.y + 0.5F * height + 3.0F * scale}, radius,
                                                mark);
    ImGui::SameLine();
    if (small("Alone", "light.alone." + group.name, "All other groups off; again: all as they were before",
              is_alone(scene, group.id), widgets))
        outcome = soloed(scene, group);
    ImGui::SameLine();
    const bool is_off = group.dimming <= 0.0;
    if (small("Off", "light.off." + group.name, "Off; again: on as it was before", is_off, widgets))
        outcome = switched(scene, group);
    dimmer(scene, group, widgets, outcome);
    const bool any_other = std::any_of(luminaires.begin(), luminaires.end(), [&](ObjectId id) {
        return std::any_of(scene.luminaires.begin(), scene.luminaires.end(), [&](const Luminaire& luminaire) {
            return luminaire.id == id && luminaire.group != group.id;
        });
    });
    if (any_other) {
        const std::string text = luminaires.size() == 1
                                     ? std::string("Take in the selected luminaire")
                                     : fmt::format("Take in {} selected luminaires", luminaires.size());
        if (wide(text.c_str(), ("light.take." + group.name).c_str(), "They are dimmed with this group from now on",
                 widgets))
            outcome = {with_group_of(scene, luminaires, group.id), "Put luminaires into " + group.name, true, {}};
    }
    ImGui::Dummy({0.0F, 3.0F * scale});
}

void LightPanel::scene_menu(const Scene& scene, const LightScene& light_scene, WidgetRegistry& widgets,
                            Outcome& outcome) {
    if (!ImGui::BeginPopup("scene menu")) return;
    if (ImGui::IsWindowAppearing()) new_name_ = light_scene.name;
    if (ImGui::MenuItem(tr("Store the present dimmers")))
        outcome = {with_stored_levels(scene, light_scene.id), "Store " + light_scene.name, true, {}};
    widgets.note("light.scene.store");
    if (ImGui::MenuItem(tr("Show its levels"))) outcome.chosen = light_scene.id;
    widgets.note("light.scene.show");
    if (ImGui::MenuItem(tr("Delete")))
        outcome = {removed(scene, light_scene.id), "Delete " + light_scene.name, true, {}};
    widgets.note("light.scene.delete");
    ImGui::Separator();
    ImGui::SetNextItemWidth(180.0F * style::scale());
    const bool entered = ImGui::InputText("##name", &new_name_,
                                          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    widgets.note("light.scene.name");
    tooltip("Name of the light scene; Enter renames");
    if (entered && !new_name_.empty() && new_name_ != light_scene.name) {
        Scene renamed = scene;
        for (LightScene& each : renamed.light_scenes)
            if (each.id == light_scene.id) each.name = new_name_;
        outcome = {std::move(renamed), "Rename light scene", true, {}};
    }
    if (entered) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

void LightPanel::scenes(const Scene& scene, WidgetRegistry& widgets, Outcome& outcome) {
    const float scale = style::scale();
    for (std::size_t k = 0; k < scene.light_scenes.size(); ++k) {
        const LightScene& light_scene = scene.light_scenes[k];
        ImGui::PushID(static_cast<int>(light_scene.id.value));
        const bool active = is_recalled(scene, light_scene);
        if (active) {
            ImGui::PushStyleColor(ImGuiCol_Button, style::accent);
            ImGui::PushStyleColor(ImGuiCol_ButtonHovered, style::accent);
            ImGui::PushStyleColor(ImGuiCol_Text, style::ground);
        }
        const float more = 30.0F * scale;
        const float width = ImGui::GetContentRegionAvail().x - more - ImGui::GetStyle().ItemSpacing.x;
        const std::string key = k < scenes_by_key ? fmt::format("Ctrl+F{}", k + 1) : std::string();
        if (ImGui::Button((light_scene.name + "###recall").c_str(), {std::max(60.0F * scale, width), 34.0F * scale}))
            outcome = {recalled(scene, light_scene.id), recall_step(light_scene), true, {}};
        if (active) ImGui::PopStyleColor(3);
        widgets.note("light.scene." + light_scene.name);
        tooltip(fmt::format("{}{}{}", active ? "The dimmers stand so. " : "Sets the dimmers of its groups. ",
                            key.empty() ? "" : "Key: ", key));
        ImGui::SameLine();
        if (ImGui::Button("...", {more, 34.0F * scale})) ImGui::OpenPopup("scene menu");
        widgets.note("light.scene_menu." + light_scene.name);
        tooltip("Store, rename or delete this light scene");
        scene_menu(scene, light_scene, widgets, outcome);
        ImGui::PopID();
    }
    if (scene.control_groups.empty()) return;
    if (wide("Keep this light as a scene", "light.keep", "A new light scene of all dimmers as they are", widgets)) {
        Added added = with_light_scene(scene);
        outcome = {std::move(added.scene), "Keep light scene", true, {}};
    }
}

LightPanel::Outcome LightPanel::draw(const Scene& scene, const Selection& selection, WidgetRegistry& widgets) {
    Outcome outcome;
    const float scale = style::scale();
    const std::vector<ObjectId> luminaires = luminaires_among(scene, selection.ids());
    ImGui::Dummy({0.0F, 2.0F * scale});
    if (!scene.control_groups.empty()) {
        headline(tr("Light scenes"), "");
        scenes(scene, widgets, outcome);
        ImGui::Dummy({0.0F, 8.0F * scale});
    }
    headline(tr("Control groups"), "");
    for (const ControlGroup& each : scene.control_groups) {
        ImGui::PushID(static_cast<int>(each.id.value));
        group(scene, each, luminaires, selection, widgets, outcome);
        ImGui::PopID();
    }
    if (const int single = members_of(scene, {}); single > 0) {
        ImGui::PushStyleColor(ImGuiCol_Text, style::quiet_text);
        ImGui::TextWrapped("%s",
                           say(single == 1 ? "{} luminaire in no group" : "{} luminaires in no group", single).c_str());
        ImGui::PopStyleColor();
    }
    if (!luminaires.empty() && wide("New group of the selected luminaires", "light.new_group",
                                    "They are dimmed together from now on", widgets)) {
        Added added = with_control_group(scene, luminaires);
        outcome = {std::move(added.scene), "New control group", true, {}};
    } else if (luminaires.empty() && scene.control_groups.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, style::quiet_text);
        ImGui::TextWrapped("%s", tr("Select luminaires and make a group of them: groups have dimmers, and light "
                                    "scenes recall how they stand."));
        ImGui::PopStyleColor();
    }
    return outcome;
}

}  // namespace hanei
