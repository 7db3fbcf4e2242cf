#include "ui/panels/file_browser.h"

#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace hanei {

namespace fs = std::filesystem;

void FileBrowser::open(Purpose purpose, std::function<void(fs::path)> done) {
    purpose_ = std::move(purpose);
    done_ = std::move(done);
    open_ = just_opened_ = true;
    std::error_code fault;
    const fs::path wished = purpose_.folder.empty() ? fs::current_path(fault) : purpose_.folder;
    enter(fs::is_directory(wished, fault) ? wished : fs::path("/"));
}

void FileBrowser::enter(const fs::path& folder) {
    std::error_code fault;
    const fs::path whole = fs::canonical(folder, fault);
    folder_ = fault ? folder : whole;
    entries_.clear();
    fault_.clear();
    fs::directory_iterator each(folder_, fs::directory_options::skip_permission_denied, fault);
    if (fault) fault_ = say("This folder cannot be read: {}", fault.message());
    for (; !fault && each != fs::directory_iterator(); each.increment(fault)) {
        const std::string name = each->path().filename().string();
        std::error_code unknown;
        const bool is_folder = each->is_directory(unknown);
        std::string ending = each->path().extension().string();
        std::transform(ending.begin(), ending.end(), ending.begin(),
                       [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
        const auto& wanted = purpose_.endings;
        const bool shown =
            is_folder || wanted.empty() || std::find(wanted.begin(), wanted.end(), ending) != wanted.end();
        if (!shown || name.front() == '.') continue;
        style::needs(name);
        entries_.push_back({name, is_folder});
    }
    std::sort(entries_.begin(), entries_.end(),
              [](const Entry& a, const Entry& b) { return a.folder != b.folder ? a.folder : a.name < b.name; });
}

fs::path FileBrowser::chosen() const {
    fs::path file = folder_ / purpose_.name;
    if (purpose_.writing && !purpose_.endings.empty() && !file.has_extension()) file += purpose_.endings.front();
    return file;
}

void FileBrowser::accept() {
    if (purpose_.name.empty()) return;
    std::error_code fault;
    const fs::path file = chosen();
    if (fs::is_directory(file, fault)) {
        enter(file);
        purpose_.name.clear();
        return;
    }
    if (!purpose_.writing && !fs::exists(file, fault)) {
        fault_ = "There is no file of this name here.";
        return;
    }
    open_ = false;
    ImGui::CloseCurrentPopup();
    done_(file);
}

void FileBrowser::list(WidgetRegistry& widgets) {
    const float below = 3.0F * ImGui::GetFrameHeightWithSpacing() + 8.0F * style::scale();
    ImGui::PushStyleColor(ImGuiCol_ChildBg, style::ground);
    ImGui::BeginChild("files", {0.0F, -below}, true);
    fs::path next;
    for (const Entry& entry : entries_) {
        const std::string label = (entry.folder ? "▸  " : "     ") + entry.name;
        if (ImGui::Selectable(label.c_str(), entry.name == purpose_.name,
                              ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups)) {
            purpose_.name = entry.folder ? purpose_.name : entry.name;
            if (entry.folder)
                next = folder_ / entry.name;
            else if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
                accept();
        }
        widgets.note("file." + entry.name);
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
    if (!next.empty()) enter(next);
}

void FileBrowser::draw(WidgetRegistry& widgets) {
    if (!open_) return;
    const std::string title = std::string(tr(purpose_.title.c_str())) + "###file browser";
    if (just_opened_) ImGui::OpenPopup(title.c_str());
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize(
        {std::min(620.0F * style::scale(), screen.x - 40.0F), std::min(460.0F * style::scale(), screen.y - 40.0F)});
    bool stay = true;
    if (!ImGui::BeginPopupModal(title.c_str(), &stay, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
        open_ = just_opened_;
        return;
    }
    if (ImGui::Button(tr("Up"))) enter(folder_.parent_path());
    widgets.note("browser.up");
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(style::colour(style::quiet_text), "%s", folder_.c_str());
    list(widgets);
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (just_opened_) ImGui::SetKeyboardFocusHere();
    bool accepted =
        ImGui::InputTextWithHint("##name", tr("File name"), &purpose_.name, ImGuiInputTextFlags_EnterReturnsTrue);
    widgets.note("browser.name");
    std::error_code unknown;
    const bool replaces = purpose_.writing && !purpose_.name.empty() && fs::is_regular_file(chosen(), unknown);
    const std::string remark = !fault_.empty() ? fault_
                               : replaces
                                   ? say("{} is there already and will be replaced.", chosen().filename().string())
                                   : "";
    ImGui::TextColored(style::colour(style::warning), "%s", remark.c_str());
    const float width = 110.0F * style::scale();
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 2.0F * width - ImGui::GetStyle().ItemSpacing.x);
    if (ImGui::Button(tr("Cancel"), {width, 0.0F}) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)))
        stay = false;
    widgets.note("browser.cancel");
    ImGui::SameLine();
    accepted |= ImGui::Button(tr(replaces ? "Replace" : purpose_.action.c_str()), {width, 0.0F});
    widgets.note("browser.accept");
    just_opened_ = false;
    if (accepted) accept();
    if (!stay) {
        open_ = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace hanei
