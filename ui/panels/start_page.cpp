#include "ui/panels/start_page.h"

#include "ui/panels/dialog_frame.h"
#include "ui/panels/form.h"
#include "ui/panels/icon.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <utility>

namespace hanei {
namespace {

namespace fs = std::filesystem;

Icon icon_of(StartPage::Wish wish) {
    switch (wish) {
        case StartPage::Wish::new_room:
            return Icon::add;
        case StartPage::Wish::open:
            return Icon::open;
        case StartPage::Wish::recover:
            return Icon::undo;
        case StartPage::Wish::example:
            return Icon::room;
        default:
            return Icon::file;
    }
}

bool pressed(ImGuiKey key, bool again) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), again); }

/// One line, cut at the right border.
void line_at(ImVec2 at, float right, ImU32 ink, const std::string& text) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(at, {right, at.y + ImGui::GetTextLineHeight() + 2.0F}, true);
    list.AddText(at, ink, text.c_str());
    list.PopClipRect();
}

}  // namespace

std::string time_of_file(const fs::path& file) {
    std::error_code unknown;
    const fs::file_time_type written = fs::last_write_time(file, unknown);
    if (unknown) return {};
    const auto since = std::chrono::duration_cast<std::chrono::seconds>(fs::file_time_type::clock::now() - written);
    const std::time_t seconds = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now() - since);
    std::tm local{};
    localtime_r(&seconds, &local);
    return fmt::format("{:%Y-%m-%d %H:%M}", local);
}

std::string title_of_example(const fs::path& file) {
    std::string title = file.stem().string();
    std::replace(title.begin(), title.end(), '-', ' ');
    if (!title.empty() && title[0] >= 'a' && title[0] <= 'z') title[0] = static_cast<char>(title[0] - 'a' + 'A');
    return title;
}

std::string short_folder(const fs::path& file) {
    const std::string folder = file.parent_path().string();
    const char* const home = std::getenv("HOME");
    const std::string start = home != nullptr ? home : "";
    if (start.size() > 1 && folder.compare(0, start.size(), start) == 0 &&
        (folder.size() == start.size() || folder[start.size()] == '/'))
        return fmt::format("~{}", folder.substr(start.size()));
    return folder;
}

std::vector<StartPage::Row> StartPage::rows_of(const std::vector<fs::path>& files, Wish wish) {
    std::vector<Row> rows;
    for (const fs::path& file : files) {
        std::error_code unknown;
        const bool there = fs::is_regular_file(file, unknown);
        if (wish == Wish::example) {
            rows.push_back({wish, file, title_of_example(file), {}, there});
            continue;
        }
        const std::string when = there ? time_of_file(file) : std::string();
        rows.push_back({wish, file, file.stem().string(),
                        when.empty() ? short_folder(file) : fmt::format("{}   {}", when, short_folder(file)), there});
    }
    return rows;
}

std::vector<StartPage::Row> StartPage::rows_of_gallery(const std::vector<std::filesystem::path>& examples) {
    std::error_code none;
    if (examples.empty()) return {};
    const std::filesystem::path folder = examples.front().parent_path() / "hard";
    if (!std::filesystem::is_directory(folder, none)) return {};
    return {{Wish::gallery, folder, tr("Hard cases..."), tr("Small scenes that break lighting programs"), true}};
}

void StartPage::open(bool can_recover) {
    columns_[0] = {{Wish::new_room, {}, tr("New room..."), tr("A box, L, T or U of your sizes"), true},
                   {Wish::open, {}, tr("Open..."), tr("A project from the disk"), true}};
    if (can_recover) columns_[0].push_back({Wish::recover, {}, tr("Recover..."), tr("Work that was not saved"), true});
    columns_[1].clear();
    examples_from_ = columns_[0].size();
    column_ = row_ = 0;
    leaves_ = false;
    open_ = opening_ = true;
}

void StartPage::show(std::vector<Row> recent, std::vector<Row> examples) {
    columns_[0].resize(examples_from_);
    std::move(examples.begin(), examples.end(), std::back_inserter(columns_[0]));
    columns_[1] = std::move(recent);
}

const StartPage::Row* StartPage::focus() const {
    const std::vector<Row>& rows = columns_[column_];
    return row_ < rows.size() && rows[row_].possible ? &rows[row_] : nullptr;
}

void StartPage::keys(Outcome& outcome) {
    const std::size_t count = columns_[column_].size();
    const std::size_t before = 100 * column_ + row_;
    if (pressed(ImGuiKey_DownArrow, true) && row_ + 1 < count) ++row_;
    if (pressed(ImGuiKey_UpArrow, true) && row_ > 0) --row_;
    const bool aside =
        pressed(ImGuiKey_Tab, false) || pressed(column_ == 0 ? ImGuiKey_RightArrow : ImGuiKey_LeftArrow, false);
    if (aside && !columns_[1 - column_].empty()) {
        column_ = 1 - column_;
        row_ = std::min(row_, columns_[column_].size() - 1);
    }
    moved_ = before != 100 * column_ + row_;
    if ((pressed(ImGuiKey_Enter, false) || pressed(ImGuiKey_KeyPadEnter, false)) && focus() != nullptr)
        outcome = {focus()->wish, focus()->file};
}

void StartPage::row(std::size_t which, std::size_t k, WidgetRegistry& widgets, Outcome& outcome) {
    const Row& row = columns_[which][k];
    const float scale = style::scale(), line = ImGui::GetTextLineHeight();
    const bool two_lines = !row.note.empty();
    const float height = (two_lines ? 2.0F * line + 2.0F * scale : line) + 10.0F * scale;
    const bool focused = column_ == which && row_ == k;
    ImGui::BeginDisabled(!row.possible);
    const bool chosen = ImGui::Selectable(fmt::format("##{}.{}", which, k).c_str(), focused,
                                          ImGuiSelectableFlags_DontClosePopups, {0.0F, height});
    ImGui::EndDisabled();
    if (focused && moved_) ImGui::SetScrollHereY();
    const std::string name = !row.file.empty() ? row.file.stem().string()
                                               : std::string(row.wish == Wish::new_room ? "new"
                                                             : row.wish == Wish::open   ? "open"
                                                                                        : "recover");
    widgets.note("start." + name);
    if (row.wish == Wish::project)
        tooltip(row.possible ? row.file.string() : fmt::format(fmt::runtime(tr("{} is gone")), row.file.string()));
    else
        tooltip(row.wish == Wish::example ? tr("Begin with a copy of this room") : row.note.c_str());
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float share = row.possible ? 1.0F : 0.5F;
    const float size = icon_size(), x = low.x + 8.0F * scale, y = low.y + 5.0F * scale;
    draw_icon(*ImGui::GetWindowDrawList(), icon_of(row.wish), {x, y + 0.5F * (line - size)}, size,
              style::faded(style::accent, share));
    const float text_x = x + size + 9.0F * scale;
    style::needs(row.name);
    style::needs(row.note);
    line_at({text_x, y}, high.x, style::faded(style::text, share), row.name);
    if (two_lines) {
        ImGui::PushFont(style::fonts().small);
        line_at({text_x, y + line + 2.0F * scale}, high.x, style::faded(style::quiet_text, share), row.note);
        ImGui::PopFont();
    }
    if (!chosen) return;
    column_ = which;
    row_ = k;
    outcome = {row.wish, row.file};
}

void StartPage::column(std::size_t which, WidgetRegistry& widgets, Outcome& outcome) {
    const auto heading = [](const char* text) {
        ImGui::PushFont(style::fonts().strong);
        ImGui::TextUnformatted(tr(text));
        ImGui::PopFont();
        ImGui::Dummy({0.0F, 2.0F * style::scale()});
    };
    heading(which == 0 ? "Begin" : "Projects of before");
    if (which == 1 && columns_[1].empty())
        ImGui::TextColored(style::colour(style::quiet_text), "%s", tr("No project was opened yet"));
    for (std::size_t k = 0; k < columns_[which].size(); ++k) {
        if (which == 0 && k == examples_from_) {
            ImGui::Dummy({0.0F, 8.0F * style::scale()});
            heading("Examples");
        }
        row(which, k, widgets, outcome);
    }
}

StartPage::Outcome StartPage::draw(bool& at_start, WidgetRegistry& widgets) {
    Outcome outcome;
    if (!open_) return outcome;
    const std::string label = fmt::format("{}###start", tr("Welcome to Hanei"));
    if (!begin_dialog(label, 760.0F, opening_, open_)) return outcome;
    const float scale = style::scale();
    const float height = std::min(400.0F * scale, ImGui::GetIO().DisplaySize.y - 180.0F * scale);
    const float left = 0.4F * ImGui::GetContentRegionAvail().x;
    keys(outcome);
    for (std::size_t which = 0; which < 2; ++which) {
        if (which == 1) ImGui::SameLine(0.0F, 16.0F * scale);
        ImGui::BeginChild(which == 0 ? "begin" : "recent", {which == 0 ? left : 0.0F, height});
        column(which, widgets, outcome);
        ImGui::EndChild();
    }
    moved_ = false;
    const float top = ImGui::GetCursorPosY();
    ImGui::SetCursorPosY(top + 11.0F * scale);
    ImGui::Checkbox(fmt::format("{}###at start", tr("Show this at every start")).c_str(), &at_start);
    widgets.note("start.always");
    tooltip("Without it the program starts in its start room at once; Edit > Preferences brings it back");
    ImGui::SetCursorPosY(top);
    buttons_from_right(1);
    const bool leaves = dialog_button("Close", "start.close", widgets) || escape_pressed();
    tooltip("Go on with the room that is shown");
    if (leaves || std::exchange(leaves_, false) || outcome.wish != Wish::none) open_ = false;
    if (!open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return outcome;
}

}  // namespace hanei
