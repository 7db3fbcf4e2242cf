#include "ui/panels/validation_dialog.h"

#include "ui/panels/dialog_frame.h"
#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

std::string percent(double share) { return fmt::format("{:.2g} %", 100.0 * share); }

void right_text(const std::string& text) {
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, ImGui::GetContentRegionAvail().x - width));
    ImGui::TextUnformatted(text.c_str());
}

void grade_cell(Grade grade) {
    const char* const words = grade == Grade::top    ? "very good"
                              : grade == Grade::pass ? "good"
                              : grade == Grade::fail ? "fails"
                                                     : "not computed";
    const style::Colour& colour = grade == Grade::fail ? style::error : grade == Grade::top ? style::good : style::text;
    ImGui::TextColored(style::colour(colour), "%s", tr(words));
}

void row_cells(const ValidationRow& row) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(row.name.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(tr(row.proves.c_str()));
    if (!row.fault.empty()) tooltip(row.fault);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(tr(row.source.c_str()));
    ImGui::TableNextColumn();
    right_text(std::to_string(row.points));
    for (const double share : {row.worst, row.allowed, row.mean}) {
        ImGui::TableNextColumn();
        right_text(percent(share));
    }
    ImGui::TableNextColumn();
    grade_cell(row.grade);
}

struct Column {
    const char* name;
    const char* help;
    float width;           ///< at scale 1; 0: what the others leave
    bool figures = false;  ///< set right
};
constexpr std::array columns{
    Column{"Case", "", 104.0F},
    Column{"Proves", "", 0.0F},
    Column{"Expected by", "Closed form: on paper. CIE 171: the geometry of that test. Own reference: other solvers",
           110.0F},
    Column{"Points", "", 50.0F, true},
    Column{"Worst", "Error where most of what is allowed is used, a share of the expected value", 78.0F, true},
    Column{"Allowed", "There", 78.0F, true},
    Column{"Mean error", "Over all points", 78.0F, true},
    Column{"Grade", "", 84.0F}};

void table(const std::vector<ValidationRow>& rows, bool follows) {
    const float height = std::min(26.0F * ImGui::GetTextLineHeightWithSpacing(), 0.62F * ImGui::GetIO().DisplaySize.y);
    constexpr ImGuiTableFlags flags =
        ImGuiTableFlags_ScrollY | ImGuiTableFlags_ScrollX | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit;
    // Where the frame is narrower than its columns they scroll, and keep their words.
    const float inner = std::max(ImGui::GetContentRegionAvail().x, 1040.0F * style::scale());
    if (!ImGui::BeginTable("cases", static_cast<int>(columns.size()), flags, {0.0F, height},
                           inner > ImGui::GetContentRegionAvail().x ? inner : 0.0F))
        return;
    ImGui::TableSetupScrollFreeze(0, 1);
    for (const Column& column : columns)
        ImGui::TableSetupColumn(
            column.name, column.width > 0.0F ? ImGuiTableColumnFlags_WidthFixed : ImGuiTableColumnFlags_WidthStretch,
            column.width > 0.0F ? column.width * style::scale() : 1.0F);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (const Column& column : columns) {
        ImGui::TableNextColumn();
        ImGui::PushStyleColor(ImGuiCol_Text, style::colour(style::quiet_text));
        if (column.figures)
            right_text(tr(column.name));
        else
            ImGui::TextUnformatted(tr(column.name));
        ImGui::PopStyleColor();
        if (*column.help != '\0') tooltip(tr(column.help));
    }
    for (const ValidationRow& row : rows) row_cells(row);
    if (follows) ImGui::SetScrollHereY(1.0F);
    ImGui::EndTable();
}

}  // namespace

ValidationDialog::ValidationDialog(std::function<void()> wake, double patience)
    : wake_(wake), work_(std::move(wake), patience, [this](const std::string& fault) { fault_ = fault; }) {}

std::size_t ValidationDialog::rows() const {
    const std::scoped_lock lock(board_->guard);
    return board_->rows.size();
}

void ValidationDialog::open(RunValidation run) {
    run_ = std::move(run);
    open_ = opening_ = true;
    begin();
}

void ValidationDialog::begin() {
    board_ = std::make_shared<Board>();
    validation_.reset();
    fault_.clear();
    was_stopped_ = false;
    work_.start(tr("Computing the reference cases"),
                [this, run = run_, board = board_, wake = wake_](const Work& work) {
                    const auto made = run(work, [&](const ValidationRow& row) {
                        {
                            const std::scoped_lock lock(board->guard);
                            board->rows.push_back(row);
                        }
                        wake();
                    });
                    return [this, made] { validation_ = made; };
                });
}

void ValidationDialog::close() {
    work_.cancel();
    open_ = false;
    ImGui::CloseCurrentPopup();
}

void ValidationDialog::headline(WidgetRegistry& widgets) {
    if (work_.busy()) {
        Task task = work_.task();
        task.id = "validation";
        task.cancel = [this] {
            work_.cancel();
            was_stopped_ = true;
        };
        return task_bar(task, widgets);
    }
    if (!fault_.empty()) return ImGui::TextColored(style::colour(style::error), "%s", fault_.c_str());
    if (was_stopped_ || !validation_) return ImGui::TextUnformatted(tr("Stopped: this is no verdict."));
    const Validation& made = *validation_;
    const std::string verdict = made.holds()
                                    ? say("All {} cases hold.", made.rows.size())
                                    : say("{} of {} cases fail.", made.rows.size() - made.held(), made.rows.size());
    ImGui::TextColored(style::colour(made.holds() ? style::good : style::error), "%s", verdict.c_str());
    ImGui::SameLine();
    const std::string who = say("Hanei {}, {}, method {}, threads: {}, points: {}, {:.1f} s", made.version, made.date,
                                made.methods, made.threads, made.points(), made.seconds);
    ImGui::TextColored(style::colour(style::quiet_text), "%s", who.c_str());
    widgets.note("validation.verdict");
}

void ValidationDialog::buttons(WidgetRegistry& widgets) {
    const bool whole = validation_.has_value();
    const bool again = !whole && !work_.busy();
    buttons_from_right(whole ? 3 : again ? 2 : 1);
    if (whole) {
        if (dialog_button("Copy text", "validation.copy", widgets))
            ImGui::SetClipboardText(validation_text(*validation_).c_str());
        tooltip(tr("The table and its verdict, as text for a report"));
        ImGui::SameLine();
        if (dialog_button("Copy CSV", "validation.csv", widgets))
            ImGui::SetClipboardText(validation_csv(*validation_).c_str());
        tooltip(tr("The table for a spreadsheet"));
        ImGui::SameLine();
    }
    if (again) {
        if (dialog_button("Run again", "validation.again", widgets)) begin();
        ImGui::SameLine();
    }
    if (dialog_button("Close", "validation.close", widgets) || escape_pressed()) close();
}

void ValidationDialog::draw(WidgetRegistry& widgets) {
    work_.follow();
    if (!open_) return;
    const std::string label = fmt::format("{}###validation", tr("Validation"));
    bool stays = true;
    if (!begin_dialog(label, 1100.0F, opening_, stays)) {
        work_.cancel();
        open_ = false;
        return;
    }
    headline(widgets);
    std::vector<ValidationRow> rows;
    {
        const std::scoped_lock lock(board_->guard);
        rows = board_->rows;
    }
    table(rows, work_.busy());
    ImGui::TextColored(
        style::colour(style::quiet_text), "%s",
        tr("Errors are shares of the expected value; of a thousandth of the greatest where it is less."));
    buttons(widgets);
    if (!stays) close();
    ImGui::EndPopup();
}

}  // namespace hanei
