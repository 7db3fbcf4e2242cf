#include "ui/panels/export_dialog.h"

#include "ui/panels/dialog_frame.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

constexpr std::array all_parts{LightPart::total, LightPart::direct, LightPart::interreflected, LightPart::unshadowed};
constexpr std::array part_labels{"Total", "Direct", "Interreflected", "Unshadowed"};
constexpr std::array part_names{"export.total", "export.direct", "export.interreflected", "export.unshadowed"};

}  // namespace

void ExportDialog::open(const std::filesystem::path& folder, std::string name_template) {
    open_ = opening_ = true;
    std::error_code failure;
    folder_ = (folder.empty() ? std::filesystem::current_path(failure) : folder).string();
    template_ = std::move(name_template);
    opened_at_ = std::chrono::system_clock::now();
}

PixelSize ExportDialog::size(const Context& context) const {
    const auto even = [](double pixels) { return std::clamp(static_cast<int>(std::lround(pixels)), 160, 16384); };
    const double width = std::max(1, context.view_size.width), height = std::max(1, context.view_size.height);
    switch (size_) {
        case 0:
            return {even(width), even(height)};
        case 1:
            return {even(2.0 * width), even(2.0 * height)};
        case 2:
            return {3840, even(3840.0 * height / width)};
        default:
            return {even(own_width_), even(own_height_)};
    }
}

std::vector<PictureJob> ExportDialog::jobs(const Context& context, std::string& fault) const {
    std::vector<PictureJob> jobs;
    const PixelSize pixels = size(context);
    const auto add = [&](LightPart part, bool four) {
        const NameParts parts{
            context.project, context.view,  four ? std::string("four parts") : std::string(name_of(part)),
            pixels.width,    pixels.height, static_cast<int>(jobs.size()) + 1,
            opened_at_};
        const PictureName name = picture_name(template_, parts);
        if (!name.fault.empty()) fault = name.fault;
        jobs.push_back(
            {std::filesystem::path(folder_) / name.name, part, four, pixels, legend_, caption_, scale_bar_, axes_});
    };
    if (what_ == What::view) add(context.part, context.four);
    if (what_ == What::four) add(LightPart::total, true);
    for (std::size_t k = 0; what_ == What::parts && k < all_parts.size(); ++k)
        if (parts_[k]) add(all_parts[k], false);
    for (std::size_t k = 1; fault.empty() && k < jobs.size(); ++k) {
        if (jobs[k].file == jobs[k - 1].file)
            fault = tr("several pictures would have one name: use {part} or {number}");
    }
    std::error_code unknown;
    if (!std::filesystem::is_directory(folder_, unknown)) fault = tr("there is no such folder");
    if (jobs.empty()) fault = tr("no part is chosen");
    return jobs;
}

void ExportDialog::fields(const Context& context, Form& form) {
    int what = static_cast<int>(what_);
    const std::vector<std::string> whats{tr("The view as it is"), tr("Four parts in one picture"),
                                         tr("A picture of each chosen part")};
    if (form.choice("export.what", "What", "Which light is shown", whats, what)) what_ = static_cast<What>(what);
    for (std::size_t k = 0; what_ == What::parts && k < parts_.size(); ++k)
        form.toggle(part_names[k], part_labels[k], "Whether this part of the light is exported", parts_[k]);
    const auto pixels = [](int width, int height) { return fmt::format("{} x {}", width, height); };
    const int w = context.view_size.width, h = context.view_size.height;
    const std::vector<std::string> sizes{fmt::format("{}  {}", tr("As on the screen"), pixels(w, h)),
                                         fmt::format("{}  {}", tr("Twice"), pixels(2 * w, 2 * h)),
                                         fmt::format("4K  {}", pixels(3840, static_cast<int>(3840.0 * h / w))),
                                         tr("Own size")};
    form.choice("export.size", "Size", "Pixels of the picture; lettering grows with it", sizes, size_);
    if (size_ == 3) {
        form.number({"export.width", "Width", "px", "160 to 16384", 160.0, 16384.0, 1.0, 0}, own_width_);
        form.number({"export.height", "Height", "px", "160 to 16384", 160.0, 16384.0, 1.0, 0}, own_height_);
    }
    form.toggle("export.legend", "Legend", "The colour scale with quantity and unit beside the picture", legend_);
    form.toggle("export.caption", "Caption", "Quantity, settings and error under the picture", caption_);
    form.toggle("export.scale_bar", "Scale bar", "In pictures to scale that have a legend or a caption", scale_bar_);
    form.toggle("export.axes", "Axes", "Which way x, y and z run, in the corner of the picture", axes_);
    form.text("export.folder", "Folder", "Where the pictures go", folder_);
    form.text("export.name", "Name",
              "{project} {view} {part} {date} {time} {size} {number} are replaced; the rest stays as it is", template_);
}

/// Returns whether files would be replaced.
bool ExportDialog::preview(const std::vector<PictureJob>& jobs, const std::string& fault,
                           WidgetRegistry& widgets) const {
    const ImU32 loud = style::warning, quiet = style::quiet_text;
    if (!fault.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, loud);
        ImGui::TextWrapped("%s", fault.c_str());
        ImGui::PopStyleColor();
        widgets.note("export.fault");
        return false;
    }
    bool replaces = false;
    for (const PictureJob& job : jobs) {
        std::error_code unknown;
        const bool there = std::filesystem::exists(job.file, unknown);
        replaces |= there;
        const std::string name = job.file.filename().string();
        ImGui::PushStyleColor(ImGuiCol_Text, there ? loud : quiet);
        ImGui::TextWrapped(
            "%s", there ? fmt::format(fmt::runtime(tr("{} is there already and will be replaced")), name).c_str()
                        : name.c_str());
        ImGui::PopStyleColor();
    }
    widgets.note("export.preview");
    return replaces;
}

std::optional<std::vector<PictureJob>> ExportDialog::draw(const Context& context, Form& form) {
    if (!open_) return std::nullopt;
    if (!begin_dialog(fmt::format("{}###export", tr("Export pictures")), 560.0F, opening_, open_)) return std::nullopt;
    form.begin("export");
    fields(context, form);
    form.end();
    std::string fault;
    std::vector<PictureJob> wished = jobs(context, fault);
    const bool replaces = preview(wished, fault, form.widgets());
    buttons_from_right(2);
    if (dialog_button("Cancel", "export.close", form.widgets()) || escape_pressed()) open_ = false;
    ImGui::SameLine();
    const bool enter = !ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false);
    ImGui::BeginDisabled(!fault.empty());
    const bool accepted = dialog_button(replaces ? "Replace" : "Export", "export.accept", form.widgets());
    ImGui::EndDisabled();
    const bool done = fault.empty() && (accepted || (enter && !replaces));
    if (done) open_ = false;
    if (!open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    if (!done) return std::nullopt;
    return wished;
}

}  // namespace hanei
