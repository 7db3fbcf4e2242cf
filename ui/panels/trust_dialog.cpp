#include "ui/panels/trust_dialog.h"

#include "ui/panels/dialog_frame.h"
#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cctype>
#include <fmt/args.h>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

/// Faces of the room have names in every language; all others are the user's own.
std::string figure_in_words(const std::string& figure) {
    const std::size_t blank = figure.find(' ');
    const bool is_numbered = blank != std::string::npos && blank + 1 < figure.size() &&
                             std::all_of(figure.begin() + static_cast<std::ptrdiff_t>(blank) + 1, figure.end(),
                                         [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
    if (is_numbered && figure.compare(0, blank, "Wall") == 0) return say("Wall {}", figure.substr(blank + 1));
    return figure == "Floor" || figure == "Ceiling" || figure == "no number" ? tr(figure.c_str()) : figure;
}

std::string said(const TrustSentence& sentence) {
    if (sentence.words.empty()) return {};
    fmt::dynamic_format_arg_store<fmt::format_context> figures;
    for (const std::string& figure : sentence.figures) figures.push_back(figure_in_words(figure));
    return fmt::vformat(tr(std::string_view(sentence.words)), figures);
}

void state_cell(const TrustRow& row) {
    const style::Colour& colour = row.state == TrustState::fails   ? style::error
                                  : row.state == TrustState::holds ? style::good
                                                                   : style::quiet_text;
    ImGui::TextUnformatted(tr(row.name));
    const char* const words = row.state == TrustState::fails   ? "fails"
                              : row.state == TrustState::holds ? "holds"
                                                               : "does not apply";
    ImGui::TextColored(style::colour(colour), "%s", tr(words));
}

/// With the word that says what it is in a column of its own.
void line(const char* title, const std::string& text, const style::Colour& colour) {
    if (text.empty()) return;
    const float indent = 78.0F * style::scale();
    const float left = ImGui::GetCursorPosX();
    ImGui::TextColored(style::colour(style::quiet_text), "%s", tr(title));
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + indent);
    ImGui::PushStyleColor(ImGuiCol_Text, style::colour(colour));
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

void row_cells(const TrustRow& row) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    state_cell(row);
    ImGui::TableNextColumn();
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(tr(row.must));
    ImGui::PopTextWrapPos();
    line("Found", said(row.found), style::text);
    line("Allowed", said(row.allowed), style::quiet_text);
    for (const TrustSentence& note : row.notes) line("Note", said(note), style::quiet_text);
    line("To do", said(row.advice), style::warning);
    ImGui::Dummy({0.0F, 4.0F * style::scale()});
}

void table(const std::vector<TrustRow>& rows) {
    const float height = std::min(34.0F * ImGui::GetTextLineHeightWithSpacing(), 0.72F * ImGui::GetIO().DisplaySize.y);
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg;
    if (!ImGui::BeginTable("trust checks", 2, flags, {0.0F, height})) return;
    ImGui::TableSetupColumn("holds", ImGuiTableColumnFlags_WidthFixed, 104.0F * style::scale());
    ImGui::TableSetupColumn("Found", ImGuiTableColumnFlags_WidthStretch);
    for (const TrustRow& row : rows) row_cells(row);
    ImGui::EndTable();
}

}  // namespace

TrustDialog::TrustDialog(std::function<void()> wake, double patience)
    : wake_(wake), work_(std::move(wake), patience, [this](const std::string& fault) { fault_ = fault; }) {}

int TrustDialog::done() const {
    const std::scoped_lock lock(board_->guard);
    return board_->report ? board_->report->done : 0;
}

void TrustDialog::open(SceneSnapshot scene, const Settings& settings) {
    scene_ = std::move(scene);
    settings_ = settings;
    open_ = opening_ = true;
    begin();
}

void TrustDialog::begin() {
    board_ = std::make_shared<Board>();
    report_.reset();
    fault_.clear();
    was_stopped_ = false;
    work_.start(tr("Checking this answer"),
                [this, scene = scene_, settings = settings_, board = board_, wake = wake_](const Work& work) {
                    auto made = trust_in(scene, settings, work, [&](const TrustReport& so_far) {
                        {
                            const std::scoped_lock lock(board->guard);
                            board->report = so_far;
                        }
                        wake();
                    });
                    return [this, made = std::move(made)] { report_ = made; };
                });
}

void TrustDialog::close() {
    work_.cancel();
    open_ = false;
    ImGui::CloseCurrentPopup();
}

void TrustDialog::headline(WidgetRegistry& widgets) {
    if (work_.busy()) {
        Task task = work_.task();
        task.id = "trust";
        task.name = say("Checking this answer: {} of {}", done() + 1, TrustReport::checks);
        task.fraction = static_cast<float>(done()) / static_cast<float>(TrustReport::checks);
        task.cancel = [this] {
            work_.cancel();
            was_stopped_ = true;
        };
        return task_bar(task, widgets);
    }
    if (!fault_.empty()) return ImGui::TextColored(style::colour(style::error), "%s", fault_.c_str());
    if (was_stopped_ || !report_) return ImGui::TextUnformatted(tr("Stopped: this is no verdict."));
    const TrustReport& report = *report_;
    ImGui::TextColored(style::colour(report.holds() ? style::good : style::error), "%s",
                       said(trust_verdict(report)).c_str());
    ImGui::SameLine();
    const Solution& solution = *report.solution;
    const std::string what = say("{}, method {}, patches: {}", solution.scene->title, name_of(solution.settings.method),
                                 solution.mesh->patches.size());
    ImGui::TextColored(style::colour(style::quiet_text), "%s", what.c_str());
    widgets.note("trust.verdict");
}

void TrustDialog::buttons(WidgetRegistry& widgets) {
    const bool whole = report_.has_value();
    const bool again = !whole && !work_.busy();
    buttons_from_right(whole ? 3 : again ? 2 : 1);
    if (whole) {
        if (dialog_button("Copy text", "trust.copy", widgets)) ImGui::SetClipboardText(trust_text(*report_).c_str());
        tooltip(tr("All of it, as text for a report"));
        ImGui::SameLine();
        if (dialog_button("Copy JSON", "trust.json", widgets)) ImGui::SetClipboardText(trust_json(*report_).c_str());
        tooltip(tr("All figures, for programs"));
        ImGui::SameLine();
    }
    if (again) {
        if (dialog_button("Run again", "trust.again", widgets)) begin();
        ImGui::SameLine();
    }
    if (dialog_button("Close", "trust.close", widgets) || escape_pressed()) close();
}

void TrustDialog::draw(WidgetRegistry& widgets) {
    work_.follow();
    if (!open_) return;
    const std::string label = fmt::format("{}###trust", tr("Check this answer"));
    bool stays = true;
    if (!begin_dialog(label, 980.0F, opening_, stays)) {
        work_.cancel();
        open_ = false;
        return;
    }
    headline(widgets);
    std::optional<TrustReport> so_far;
    {
        const std::scoped_lock lock(board_->guard);
        so_far = board_->report;
    }
    table(so_far ? trust_rows(*so_far) : std::vector<TrustRow>());
    buttons(widgets);
    if (!stays) close();
    ImGui::EndPopup();
}

}  // namespace hanei
