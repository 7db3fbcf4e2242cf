#include "engine/edit/several.h"
#include "ui/panels/icon.h"
#include "ui/panels/language.h"
#include "ui/panels/panel_frame.h"
#include "ui/panels/style.h"
#include "ui/panels/tool_bar.h"
#include "ui/panels/view_bar.h"
#include "ui/panels/workbench.h"

#include <fmt/format.h>
#include <imgui_internal.h>

namespace hanei {
namespace {

constexpr double passage_seconds = 0.25;

}  // namespace

/// Beside the views: what is done in them.
void Workbench::view_bar_tools() {
    for (const CommandId id : {CommandId::walk_through, CommandId::measure_distance}) {
        const Command& entry = command(id);
        ImGui::SameLine(0.0F, 2.0F * style::scale());
        flow_in_view_bar(ImGui::GetFrameHeight());
        const std::string help = fmt::format("{}  {}\n{}", tr(entry.label), to_text(entry.chord), tr(entry.help));
        const std::string name = fmt::format("bar.{}", entry.name);
        if (icon_button(name.c_str(), icon_of(entry.name), help, is_on(id), widgets_)) carry_out(id);
    }
    end_view_bar();
}

void Workbench::centre(const ScreenRect& area, const ViewPainter& paint) {
    const float scale = style::scale();
    const float bar = view_bar_height();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8.0F * scale, 6.0F * scale});
    begin_panel("##bar", {area.left, area.top, area.right, area.top + bar});
    ImGui::PopStyleVar();
    if (auto edit = view_bar(viewport_.state, *document_.shown(), study_.solution(), widgets_))
        propose(std::move(edit->scene), std::move(edit->step));
    view_bar_tools();
    end_panel();
    const float strip = tool_bar_width();
    tool_bar({area.left, area.top + bar, area.left + strip, area.bottom});
    const ScreenRect view{area.left + strip, area.top + bar, area.right, area.bottom};
    ImGui::PushStyleColor(ImGuiCol_WindowBg, style::ground);
    begin_panel("##view", view, false);
    viewport_.right_margin = legend_margin();
    viewport_.passage_seconds = preferences_.glides && !how_.repeatable ? passage_seconds : 0.0;
    const SolutionSnapshot kept = readings_.snapshots.follow(study_.answer(), is_flipped());
    Viewport::Input input{document_.shown(),
                          kept ? kept : study_.solution(),
                          kept ? kept : study_.answer(),
                          selection_,
                          snap_,
                          !kept && !study_.fresh(),
                          overlays_};
    readings_.labels.others = &furnishing_;
    readings_.labels.snap = snap_;
    readings_.labels.dragged =
        viewport_.dragging() ? middle_of(*document_.shown(), selection_.ids()) : std::optional<Vec3>();
    input.grips = &readings_.labels;
    if (kept) input.painted = kept->scene;
    if (readings_.snapshots.shows_difference())
        input.difference = readings_.snapshots.range_of(viewport_.state.options.part);
    readings_.labels.difference = input.difference;
    const Viewport::Outcome outcome = viewport_.draw(input, paint, widgets_);
    if (viewport_.shown_options(input).shadow_classes)
        class_legend(viewport_.shown_options(input), study_.solution(), view, widgets_);
    else if (input.difference)
        difference_legend(readings_.snapshots, viewport_.state.options.part, view, widgets_);
    else
        legend(viewport_.state, document_.shown()->colour_scale.has_value(), view, widgets_);
    end_panel();
    take_scale_wishes();
    pin_at_double_click();
    ImGui::PopStyleColor();
    const Selection before = selection_;
    if (outcome.chosen) selection_ = *outcome.chosen;
    if (outcome.chosen && outcome.chosen->empty()) {
        const std::optional<Ray> ray = viewport_.pointed(*document_.shown(), ImGui::GetIO().MousePos).ray;
        const auto found = ray ? furnishing_.clicked(*document_.shown(), before, *ray) : std::nullopt;
        if (found) selection_ = *found;
    }
    if (outcome.moved) {
        gesture_item_ = ImGui::GetCurrentContext()->ActiveId;
        document_.propose(*outcome.moved, outcome.step);
    }
    if (outcome.given_up) document_.abandon();
    if (outcome.released) document_.settle();
    if (outcome.menu_wished) open_context_menu(selection_);
}

}  // namespace hanei
