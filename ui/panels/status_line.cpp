#include "engine/edit/several.h"
#include "ui/panels/elided.h"
#include "ui/panels/form.h"
#include "ui/panels/icon.h"
#include "ui/panels/language.h"
#include "ui/panels/panel_frame.h"
#include "ui/panels/probe.h"
#include "ui/panels/style.h"
#include "ui/panels/workbench.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

constexpr float greatest_right_share = 0.4F;  // of the line, where the state has too little room beside it

struct Status {
    Icon icon = Icon::stale;
    ImU32 ink = style::quiet_text;
    std::string text = tr("Nothing computed yet");
};

std::string bound_of(const Solution& solution) {
    return say("iteration error ≤ {} lx", short_figure(solution.iteration_bound));
}

/// "0.3 s old"; so that it does not flicker, in steps that grow with it.
std::string age_text(double seconds) {
    if (seconds < 10.0) return say("{:.1f} s old", seconds);
    if (seconds < 120.0) return say("{:.0f} s old", seconds);
    return say("{:.0f} min old", seconds / 60.0);
}

Status answered(const Solution& solution) {
    const bool as_set = !solution.converged && solution.bounces >= solution.settings.bounces;
    const std::string_view end = solution.converged ? "Converged"
                                 : as_set           ? "Ended after the bounces that are set"
                                                    : "Not converged";
    const std::string text = say("{} · {} interreflections · {}", tr(end), solution.bounces, bound_of(solution));
    if (solution.converged || as_set) return {Icon::done, style::good, text};
    return {Icon::warning, style::warning, text};
}

/// What is being worked out, how far it is, and what the values on the screen are worth meanwhile.
Status under_way(const LiveStudy& study, bool timed, bool stops_on_escape) {
    Status status{Icon::busy, style::accent, tr("Computing")};
    const Stage stage = study.progress().stage();
    if (stage != Stage::idle && stage != Stage::done) status.text += fmt::format(" · {}", tr(name_of(stage)));
    const double share = static_cast<double>(study.progress().fraction());
    if (share > 0.0) status.text += fmt::format(" {:.0f} %", 100.0 * share);
    if (study.answer()) {
        status.text +=
            timed ? say(" · values {}", age_text(study.answer_age())) : std::string(tr(" · values of before"));
        status.text += " · " + bound_of(*study.answer());
    }
    if (stops_on_escape && study.is_cancellable()) status.text += tr(" · Esc stops");
    return status;
}

Status status_of(const LiveStudy& study, bool timed, bool stops_on_escape) {
    if (study.fault() != nullptr) return {Icon::error, style::error, study.fault()->message};
    if (study.fresh()) return answered(*study.solution());
    if (study.is_cancelled())
        return {Icon::stopped, style::warning,
                tr("Stopped · the values are those of before · any change computes anew")};
    if (study.busy()) return under_way(study, timed, stops_on_escape);
    return {};
}

}  // namespace

void Workbench::status_line(const ScreenRect& area) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12.0F * style::scale(), 6.0F * style::scale()});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, style::ground);
    begin_panel("##status", area);
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
    const Status status = status_of(study_, !how_.repeatable, !selection_.primary());
    icon_item(status.icon, status.ink);
    std::string right =
        viewport_.tool() != nullptr ? viewport_.tool()->hint() : std::string(tr(std::string_view(message_)));
    const Scene& scene = *document_.shown();
    if (const auto place = middle_of(scene, selection_.ids())) {
        const std::string what = selection_.ids().size() > 1 ? phrase(words_for(scene, selection_.ids()))
                                                             : display_name(scene, selection_.primary());
        right += fmt::format("{}{}  x {:.2f}  y {:.2f}  z {:.2f} m", right.empty() ? "" : "     ", what, place->x,
                             place->y, place->z);
    }
    right += "     " + text_of(snap_);
    const std::optional<Task> task = running_task();
    const std::string errors = messages_.unread_errors() == 0   ? std::string()
                               : messages_.unread_errors() == 1 ? std::string(tr("1 error"))
                                                                : say("{} errors", messages_.unread_errors());
    if (task) right.clear();
    float width = task ? task_bar_width * style::scale() : ImGui::CalcTextSize(right.c_str()).x;
    if (!errors.empty()) width += ImGui::CalcTextSize(errors.c_str()).x + icon_size() + 30.0F * style::scale();
    const float margin = 14.0F * style::scale(), whole = area.right - area.left, at = ImGui::GetCursorPosX();
    const float between = 24.0F * style::scale();
    const float least_right = task ? width : std::min(width, greatest_right_share * whole);
    elided_text(status.text, std::max(1.0F, whole - at - least_right - between - margin));
    widgets_.note("status");
    const float begin = ImGui::GetItemRectMax().x - area.left + between;
    ImGui::SameLine(std::max(begin, whole - width - margin));
    if (!errors.empty()) {
        icon_item(Icon::error, style::error);
        ImGui::TextColored(style::colour(style::error), "%s", errors.c_str());
        widgets_.note("status.errors");
        if (ImGui::IsItemClicked()) opens_messages_ = true;
        tooltip("Click for the list of what went wrong");
        ImGui::SameLine(0.0F, 24.0F * style::scale());
    }
    if (task) {
        task_bar(*task, widgets_);
    } else {
        const float room = whole - ImGui::GetCursorPosX() - margin;
        const std::string shown = elided(right, room);
        ImGui::TextColored(style::colour(style::quiet_text), "%s", shown.c_str());
        tooltip(shown.size() == right.size() ? std::string(tr("Click: what moved objects catch at"))
                                             : fmt::format("{}\n{}", right, tr("Click: what moved objects catch at")));
        widgets_.note("status.snap");
        if (ImGui::IsItemClicked()) snap_popup_.open();
    }
    end_panel();
}

}  // namespace hanei
