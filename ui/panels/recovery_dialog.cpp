#include "ui/panels/recovery_dialog.h"

#include "ui/panels/dialog_frame.h"
#include "ui/panels/form.h"
#include "ui/panels/language.h"

#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

std::string time_text(std::chrono::system_clock::time_point when) {
    const std::time_t seconds = std::chrono::system_clock::to_time_t(when);
    std::tm local{};
    localtime_r(&seconds, &local);
    return fmt::format("{:%Y-%m-%d %H:%M:%S}", local);
}

}  // namespace

void RecoveryDialog::open(std::vector<Offer> offers) {
    offers_ = std::move(offers);
    chosen_ = 0;
    open_ = opening_ = !offers_.empty();
}

void RecoveryDialog::list(WidgetRegistry& widgets) {
    if (!ImGui::BeginTable("offers", 3, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn(tr("Project"), 0, 2.0F);
    ImGui::TableSetupColumn(tr("Kept"), 0, 1.6F);
    ImGui::TableSetupColumn(tr("Differs from the file"), 0, 3.0F);
    ImGui::TableHeadersRow();
    for (std::size_t k = 0; k < offers_.size(); ++k) {
        const Offer& offer = offers_[k];
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        if (ImGui::Selectable(fmt::format("{}##{}", offer.name, k).c_str(), k == chosen_,
                              ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_DontClosePopups))
            chosen_ = k;
        widgets.note(fmt::format("recovery.{}", k + 1));
        tooltip(offer.work.original.empty() ? std::string(tr("It was never saved")) : offer.work.original.string());
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(time_text(offer.work.kept_at).c_str());
        ImGui::TableNextColumn();
        ImGui::TextWrapped("%s", offer.differs.c_str());
    }
    ImGui::EndTable();
}

RecoveryDialog::Outcome RecoveryDialog::draw(WidgetRegistry& widgets) {
    Outcome outcome;
    if (!open_) return outcome;
    const std::string label = fmt::format("{}###recovery", tr("Unsaved work was found"));
    if (!begin_dialog(label, 720.0F, opening_, open_)) return outcome;
    ImGui::TextWrapped("%s", tr("Hanei ended before this was saved. Recovered work opens as unsaved changes; the "
                                "project's file stays as it is until you save."));
    ImGui::Dummy({0.0F, ImGui::GetStyle().ItemSpacing.y});
    list(widgets);
    buttons_from_right(3);
    if (dialog_button("Discard", "recovery.discard", widgets)) outcome.wish = Wish::discard;
    tooltip("Give the chosen work up for good");
    ImGui::SameLine();
    const bool later = dialog_button("Later", "recovery.later", widgets) || escape_pressed();
    tooltip("Keep it, and ask again at the next start, or by File > Recover unsaved work");
    ImGui::SameLine();
    if (dialog_button("Recover", "recovery.recover", widgets)) outcome.wish = Wish::recover;
    tooltip("Open the chosen work");
    if (outcome.wish != Wish::none) {
        outcome.work = offers_[chosen_].work;
        offers_.erase(offers_.begin() + static_cast<std::ptrdiff_t>(chosen_));
        chosen_ = 0;
    }
    if (later || outcome.wish == Wish::recover || offers_.empty()) open_ = false;
    if (!open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return outcome;
}

}  // namespace hanei
