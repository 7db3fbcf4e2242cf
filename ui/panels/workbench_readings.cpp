#include "engine/base/whole_file.h"
#include "engine/report/profile_report.h"
#include "ui/panels/language.h"
#include "ui/panels/panel_frame.h"
#include "ui/panels/workbench.h"

#include <imgui.h>
#include <utility>

namespace hanei {
namespace {

// What their fields and figures need, at scale 1.
constexpr float compare_width = 680.0F, profile_width = 560.0F, histogram_width = 520.0F, study_width = 640.0F;

}  // namespace

void Workbench::follow_readings() {
    readings_.why.follow(*document_.shown(), selection_.primary(), study_);
    readings_.study.follow();
    readings_.effects.begin_frame();
}

/// Tabs of the bottom panel that read the light.
void Workbench::readings_tabs() {
    const std::string front = std::exchange(readings_.front_tab, {});
    if (begin_tab("Why", widgets_, 0, front == "Why")) {
        if (const auto clicked = readings_.why.table(*document_.shown(), widgets_)) selection_.choose(*clicked);
        ImGui::EndTabItem();
    }
    if (begin_tab("Compare", widgets_, 0, front == "Compare")) {
        begin_wide("compare", compare_width);
        compare_tab();
        end_wide();
        ImGui::EndTabItem();
    }
    readings_.profile.begin_frame();
    if (begin_tab("Profile", widgets_, 0, front == "Profile")) {
        begin_wide("profile", profile_width);
        profile_tab();
        end_wide();
        ImGui::EndTabItem();
    }
    if (begin_tab("Histogram", widgets_, 0, front == "Histogram")) {
        begin_wide("histogram", histogram_width);
        readings_.histogram.table(study_.answer(), selection_.primary(), viewport_.state.options, widgets_);
        end_wide();
        ImGui::EndTabItem();
    }
    if (begin_tab("Study", widgets_, 0, front == "Study")) {
        begin_wide("study", study_width);
        const StudyPanel::Outcome outcome =
            readings_.study.table(document_.shown(), document_.settings(), !how_.repeatable, widgets_);
        end_wide();
        if (outcome.starts) readings_.study.start(document_.shown(), document_.settings());
        if (outcome.use) document_.set_settings(*outcome.use);
        ImGui::EndTabItem();
    }
}

bool Workbench::is_flipped() const {
    constexpr int grave_accent = 96;
    return !ImGui::GetIO().WantTextInput && ImGui::IsKeyDown(grave_accent);
}

void Workbench::keep_state(bool as_a) {
    const ColourScale scale = scale_of(viewport_.state.options);
    Snapshots& snapshots = readings_.snapshots;
    as_a ? snapshots.keep_as_a(study_.answer(), scale) : snapshots.keep_as_b(study_.answer(), scale);
    message_ = as_a ? "Kept as A" : "Kept as B";
    readings_.front_tab = "Compare";
}

void Workbench::compare_tab() {
    const CompareWish wish = compare_panel(readings_.snapshots, study_.answer(), widgets_);
    if (wish.keep_a && study_.answer()) keep_state(true);
    if (wish.keep_b && study_.answer()) keep_state(false);
    if (wish.chosen) selection_.choose(*wish.chosen);
    if (!wish.use_scale) return;
    Scene wished = *document_.shown();
    wished.colour_scale = *wish.use_scale;
    document_.settle();
    document_.commit(std::move(wished), "Use the scale of a kept state");
}

void Workbench::profile_tab() {
    const ProfilePanel::Outcome outcome = readings_.profile.table(study_.answer(), widgets_);
    if (readings_.profile.is_busy() && readings_.wake) readings_.wake();
    if (outcome.draws_line) do_results(CommandId::draw_profile);
    if (!outcome.exports) return;
    browser_.open({"Export the profile", "Export", {".csv"}, true, folder(), document_.title() + " profile.csv"},
                  [this, csv = profile_csv(*readings_.profile.sampler())](const std::filesystem::path& file) {
                      if (const auto reason = write_whole_file(file, csv)) {
                          Diagnostic fault;
                          fault.message = file.string() + ": " + *reason;
                          return tell("Export", fault);
                      }
                      message_ = say("Exported {}", file.filename().string());
                  });
}

}  // namespace hanei
