#include "ui/panels/model_import.h"

#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <imgui.h>
#include <utility>

namespace hanei {
namespace {

struct UnitChoice {
    const char* label;
    double metres;
};
constexpr std::array units{
    UnitChoice{"Metres, as glTF says", 1.0},
    UnitChoice{"Centimetres", 0.01},
    UnitChoice{"Millimetres", 0.001},
    UnitChoice{"Inches", 0.0254},
    UnitChoice{"Feet", 0.3048},
    UnitChoice{"Thousands of metres", 1000.0},
};

std::string length_text(double metres) {
    return metres < 0.1 ? fmt::format("{:.3g}", metres) : fmt::format("{:.2f}", metres);
}

std::string size_of(const Vec3& size) {
    return length_text(size.x) + " x " + length_text(size.y) + " x " + length_text(size.z);
}

std::vector<std::string> translated(std::initializer_list<const char*> names) {
    std::vector<std::string> list;
    for (const char* const name : names) list.emplace_back(tr(name));
    return list;
}

bool dialog_button(const char* label, const char* name, WidgetRegistry& widgets) {
    const bool pressed = ImGui::Button(tr(label), {110.0F * style::scale(), 0.0F});
    widgets.note(name);
    return pressed;
}

bool key_pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); }

}  // namespace

void ModelImport::open(const std::filesystem::path& file, Opened<ModelContent> first, Read read, Vec2 place,
                       bool dropped, std::function<void(Taken)> taken) {
    file_ = file;
    opened_ = std::move(first);
    reading_ = read_as_ = {};
    read_ = std::move(read);
    place_ = place;
    dropped_ = dropped;
    taken_ = std::move(taken);
    where_ = dropped ? Where::pointer : Where::middle;
    open_ = just_opened_ = true;
}

std::string ModelImport::summary() const {
    if (!open_) return {};
    if (!opened_.content) return "refused";
    const ModelContent& content = *opened_.content;
    return fmt::format("{} m, {} solids, {} sheets, {} luminaires{}", size_of(content.size), content.solids,
                       content.sheets, content.luminaires, content.scene.room ? ", a room" : "");
}

/// True when the model has to be read anew.
bool ModelImport::choices(Form& form) {
    const ModelReading before = reading_;
    std::vector<std::string> names;
    int unit = 0;
    for (std::size_t k = 0; k < units.size(); ++k) {
        names.emplace_back(tr(units[k].label));
        if (units[k].metres == reading_.metres_per_unit) unit = static_cast<int>(k);
    }
    if (form.choice("import.unit", "Unit", "What a length of 1 stands for in the file", names, unit))
        reading_.metres_per_unit = units[static_cast<std::size_t>(unit)].metres;
    int up = reading_.z_up ? 1 : 0;
    const auto axes = translated({"Y, as glTF says", "Z"});
    if (form.choice("import.up", "Up", "Which axis of the file points up", axes, up)) reading_.z_up = up == 1;
    int kind = static_cast<int>(reading_.kind);
    const auto kinds = translated({"What it looks like", "Furniture", "A room"});
    if (form.choice("import.kind", "Take it as", "Whether a closed shell around everything is the room", kinds, kind))
        reading_.kind = static_cast<ModelReading::Kind>(kind);
    place_choice(form);
    return !(reading_ == before);
}

/// A model with a room is a project of its own; furniture stands somewhere in the present one.
void ModelImport::place_choice(Form& form) {
    if (!opened_.content) return;
    const bool brings_room = opened_.content->scene.room.has_value();
    const Where moved = brings_room ? Where::instead : dropped_ ? Where::pointer : Where::middle;
    const std::array ways{moved, Where::as_drawn, Where::new_project};
    int way = where_ == Where::as_drawn ? 1 : where_ == Where::new_project ? 2 : 0;
    const char* const first = brings_room ? "In place of all that is there"
                              : dropped_  ? "Where it was dropped"
                                          : "In the middle of the room";
    const char* const second = brings_room ? "Beside what is there, but for the room" : "Where the file has it";
    const auto places = translated({first, second, "As a new project"});
    form.choice("import.place", "Place", "Where it stands, and what it takes the place of", places, way);
    where_ = ways[static_cast<std::size_t>(way)];
}

void ModelImport::facts(Form& form) const {
    if (!opened_.content) return;
    const ModelContent& content = *opened_.content;
    form.fact("Size", size_of(content.size), "m");
    form.fact("Furniture", fmt::format("{}", content.scene.furniture.size()));
    form.fact("Solids", fmt::format("{}", content.solids));
    form.fact("Free surfaces", fmt::format("{}", content.sheets));
    form.fact("Luminaires", fmt::format("{}", content.luminaires));
    if (content.scene.room)
        form.fact("Room", fmt::format("{} corners, {:.2f} m high", content.scene.room->plan.size(),
                                      content.scene.room->height));
}

void ModelImport::remarks() const {
    if (opened_.findings.empty()) return;
    ImGui::Dummy({0.0F, 2.0F * style::scale()});
    const float row = ImGui::GetTextLineHeightWithSpacing();
    const auto rows = static_cast<float>(std::min<std::size_t>(2 * opened_.findings.size(), 7));
    ImGui::PushStyleColor(ImGuiCol_ChildBg, style::card);
    ImGui::BeginChild("remarks", {0.0F, rows * row + 8.0F * style::scale()}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PushFont(style::fonts().small);
    for (const Diagnostic& finding : opened_.findings) {
        const bool grave = finding.severity == Severity::error;
        ImGui::PushStyleColor(ImGuiCol_Text, grave                                   ? style::error
                                             : finding.severity == Severity::warning ? style::warning
                                                                                     : style::quiet_text);
        const std::string text = grave ? finding.place.field + ": " + finding.message : finding.message;
        ImGui::TextWrapped("%s", text.c_str());
        ImGui::PopStyleColor();
    }
    ImGui::PopFont();
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

void ModelImport::draw(Form& form, const std::optional<Task>& reading) {
    if (!open_) return;
    const std::string title = fmt::format("{} {}###model", tr("Import"), file_.filename().string());
    if (just_opened_) ImGui::OpenPopup(title.c_str());
    just_opened_ = false;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({std::min(460.0F * style::scale(), screen.x - 40.0F), 0.0F});
    bool stay = true;
    if (!ImGui::BeginPopupModal(title.c_str(), &stay, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
        open_ = false;
        return;
    }
    form.begin("model");
    if (!reading) reading_ = read_as_;  // the reading was stopped
    if (choices(form))
        read_(reading_, [this, how = reading_](Opened<ModelContent> opened) {
            opened_ = std::move(opened);
            read_as_ = how;
        });
    facts(form);
    form.end();
    remarks();
    if (reading) task_bar(*reading, form.widgets());
    ImGui::Dummy({0.0F, 6.0F * style::scale()});
    const float width = 220.0F * style::scale() + ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
    const bool cancel =
        dialog_button("Cancel", "import.cancel", form.widgets()) || key_pressed(ImGuiKey_Escape) || !stay;
    ImGui::SameLine();
    ImGui::BeginDisabled(!can_take());
    const bool pressed = dialog_button("Import", "import.ok", form.widgets()) || key_pressed(ImGuiKey_Enter);
    ImGui::EndDisabled();
    const bool take = pressed && can_take() && !cancel;
    if (take || cancel) {
        if (reading) reading->cancel();
        open_ = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
    if (!take) return;
    taken_({file_, std::move(*opened_.content), std::move(opened_.findings), where_, place_});
}

}  // namespace hanei
