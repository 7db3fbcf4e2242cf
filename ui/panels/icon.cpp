#include "ui/panels/icon.h"

#include "ui/panels/form.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <imgui_internal.h>
#include <utility>

namespace hanei {
namespace {

constexpr float sheet = 24.0F;
constexpr float stroke = 1.9F;  // on the sheet
constexpr float radian = 3.14159265F / 180.0F;

/// Reads a shape and draws it, token by token.
class Pen {
public:
    Pen(ImDrawList& list, std::string_view shape, ImVec2 corner, float size, ImU32 colour)
        : list_(list),
          rest_(shape),
          corner_(corner),
          unit_(size / sheet),
          colour_(colour),
          thickness_(std::max(1.2F, stroke * unit_)) {}

    void draw() {
        list_.PathClear();
        for (char letter = next_letter(); letter != '\0'; letter = next_letter()) step(letter);
    }

private:
    void step(char letter) {
        if (letter == 'm') list_.PathClear();
        if (letter == 'm' || letter == 'l') return list_.PathLineTo(place());
        if (letter == 's') return list_.PathStroke(colour_, ImDrawFlags_None, thickness_);
        if (letter == 'z') return list_.PathStroke(colour_, ImDrawFlags_Closed, thickness_);
        if (letter == 'f') return list_.PathFillConvex(colour_);
        if (letter == 'b') {
            const ImVec2 first = place(), second = place();
            return list_.PathBezierCubicCurveTo(first, second, place());
        }
        const ImVec2 at = place();
        if (letter == 'r') return frame(at);
        const float radius = unit_ * figure();
        if (letter == 'c') list_.AddCircle(at, radius, colour_, 0, thickness_);
        if (letter == 'd') list_.AddCircleFilled(at, radius, colour_);
        if (letter != 'a') return;
        const float from = figure() * radian;
        list_.PathArcTo(at, radius, from, figure() * radian, 16);
    }

    void frame(ImVec2 low) {
        const ImVec2 high = place();
        list_.AddRect(low, high, colour_, unit_ * figure(), ImDrawFlags_None, thickness_);
    }

    ImVec2 place() {
        const float x = figure(), y = figure();
        return {corner_.x + unit_ * x, corner_.y + unit_ * y};
    }

    char next_letter() {
        skip_blanks();
        if (rest_.empty()) return '\0';
        const char letter = rest_.front();
        rest_.remove_prefix(1);
        return letter;
    }

    float figure() {
        skip_blanks();
        float value = 0.0F;
        const auto [end, fault] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }

    void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }

    ImDrawList& list_;
    std::string_view rest_;
    ImVec2 corner_;
    float unit_;
    ImU32 colour_;
    float thickness_;
};

constexpr std::array table{
    CommandIcon{"add.box", Icon::furniture},
    CommandIcon{"add.calculation_point", Icon::point},
    CommandIcon{"add.file", Icon::file},
    CommandIcon{"add.furniture", Icon::furniture},
    CommandIcon{"add.grid", Icon::grid},
    CommandIcon{"add.line", Icon::luminaire},
    CommandIcon{"add.panel", Icon::luminaire},
    CommandIcon{"add.point", Icon::luminaire},
    CommandIcon{"arrange.array", Icon::four},
    CommandIcon{"arrange.circle", Icon::turn},
    CommandIcon{"arrange.group", Icon::group},
    CommandIcon{"edit.box_select", Icon::box},
    CommandIcon{"edit.copy", Icon::duplicate},
    CommandIcon{"edit.delete", Icon::remove},
    CommandIcon{"edit.deselect", Icon::close},
    CommandIcon{"edit.duplicate", Icon::duplicate},
    CommandIcon{"edit.preferences", Icon::settings},
    CommandIcon{"edit.redo", Icon::redo},
    CommandIcon{"edit.turn", Icon::turn},
    CommandIcon{"edit.undo", Icon::undo},
    CommandIcon{"file.copy_picture", Icon::duplicate},
    CommandIcon{"file.export", Icon::picture},
    CommandIcon{"file.new", Icon::add},
    CommandIcon{"file.start_page", Icon::overview},
    CommandIcon{"file.open", Icon::open},
    CommandIcon{"file.render_exact", Icon::photo},
    CommandIcon{"file.save", Icon::save},
    CommandIcon{"help.keys", Icon::note},
    CommandIcon{"help.search", Icon::search},
    CommandIcon{"light.aim", Icon::aim},
    CommandIcon{"light.circle", Icon::isolux},
    CommandIcon{"light.field", Icon::grid},
    CommandIcon{"light.group", Icon::dimmer},
    CommandIcon{"light.keep_scene", Icon::light_scene},
    CommandIcon{"light.layout", Icon::fit},
    CommandIcon{"light.line", Icon::luminaire},
    CommandIcon{"results.difference", Icon::compare},
    CommandIcon{"results.histogram", Icon::sum},
    CommandIcon{"results.pin", Icon::pin},
    CommandIcon{"results.profile", Icon::profile},
    CommandIcon{"results.values", Icon::measure},
    CommandIcon{"results.why", Icon::search},
    CommandIcon{"room.board", Icon::surface},
    CommandIcon{"room.choose", Icon::room},
    CommandIcon{"room.door", Icon::opening},
    CommandIcon{"room.draw", Icon::plan},
    CommandIcon{"room.material", Icon::material},
    CommandIcon{"room.new", Icon::room},
    CommandIcon{"room.window", Icon::opening},
    CommandIcon{"view.body", Icon::aim},
    CommandIcon{"view.ceiling", Icon::box},
    CommandIcon{"view.ceiling_plan", Icon::luminaire},
    CommandIcon{"view.fit_range", Icon::fit},
    CommandIcon{"view.four_up", Icon::four},
    CommandIcon{"view.four_views", Icon::four},
    CommandIcon{"view.grids", Icon::grid},
    CommandIcon{"view.isolux", Icon::isolux},
    CommandIcon{"view.language", Icon::language},
    CommandIcon{"view.look", Icon::visible},
    CommandIcon{"view.measure", Icon::distance},
    CommandIcon{"view.mesh", Icon::patches},
    CommandIcon{"view.overview", Icon::overview},
    CommandIcon{"view.photo", Icon::photo},
    CommandIcon{"view.plan", Icon::surface},
    CommandIcon{"view.save", Icon::view},
    CommandIcon{"view.section", Icon::section},
    CommandIcon{"view.shadow_classes", Icon::shadows},
    CommandIcon{"view.shadow_outlines", Icon::shadows},
    CommandIcon{"view.split", Icon::compare},
    CommandIcon{"view.theme", Icon::theme},
    CommandIcon{"view.walk", Icon::walk},
};

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 corner, float size, ImU32 colour) {
    Pen(list, shape_of(icon), corner, size, colour).draw();
}

float icon_size() { return std::round(0.95F * ImGui::GetTextLineHeight()); }

void icon_item(Icon icon, ImU32 colour) {
    const float size = icon_size();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float below =
        0.5F * (ImGui::GetTextLineHeight() - size) + ImGui::GetCurrentWindowRead()->DC.CurrLineTextBaseOffset;
    draw_icon(*ImGui::GetWindowDrawList(), icon, {at.x, at.y + below}, size, colour);
    ImGui::Dummy({size, ImGui::GetTextLineHeight()});
    ImGui::SameLine(0.0F, 6.0F * style::scale());
}

bool icon_button(const char* name, Icon icon, const std::string& help, bool on, WidgetRegistry& widgets) {
    const float side = ImGui::GetFrameHeight();
    ImGui::PushStyleColor(ImGuiCol_Button, on ? ImU32(style::chosen) : style::none);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::Button((std::string("###") + name).c_str(), {side, side});
    ImGui::PopStyleColor();
    const bool enabled = (ImGui::GetItemFlags() & ImGuiItemFlags_Disabled) == 0;
    const float size = icon_size(), margin = std::floor(0.5F * (side - size));
    const ImU32 ink = on ? ImU32(style::accent) : enabled ? ImU32(style::text) : style::faded(style::quiet_text, 0.5F);
    draw_icon(*ImGui::GetWindowDrawList(), icon, {at.x + margin, at.y + margin}, size, ink);
    widgets.note(name);
    tooltip(help);
    return pressed;
}

bool icon_text_button(const char* label, Icon icon) {
    const ImGuiStyle& look = ImGui::GetStyle();
    const float size = icon_size(), gap = 6.0F * style::scale();
    const ImVec2 words = ImGui::CalcTextSize(label, nullptr, true);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetFrameHeight();
    ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {1.0F, 0.5F});
    const bool pressed = ImGui::Button(label, {words.x + size + gap + 2.0F * look.FramePadding.x, side});
    ImGui::PopStyleVar();
    const float margin = std::floor(0.5F * (side - size));
    draw_icon(*ImGui::GetWindowDrawList(), icon, {at.x + look.FramePadding.x, at.y + margin}, size,
              ImGui::GetColorU32(ImGuiCol_Text));
    return pressed;
}

Icon icon_of(ObjectKind kind) {
    switch (kind) {
        case ObjectKind::none:
            return Icon::none;
        case ObjectKind::room:
            return Icon::room;
        case ObjectKind::furniture:
            return Icon::furniture;
        case ObjectKind::surface:
            return Icon::surface;
        case ObjectKind::luminaire:
            return Icon::luminaire;
        case ObjectKind::grid:
            return Icon::grid;
        case ObjectKind::point:
            return Icon::point;
        case ObjectKind::view:
            return Icon::view;
        case ObjectKind::material:
            return Icon::material;
        case ObjectKind::control_group:
            return Icon::dimmer;
        case ObjectKind::light_scene:
            return Icon::light_scene;
        case ObjectKind::arrangement:
            return Icon::four;
        case ObjectKind::sub_area:
            return Icon::opening;
        case ObjectKind::object_group:
            return Icon::group;
    }
    return Icon::none;
}

Icon icon_of(Severity severity) {
    return severity == Severity::error ? Icon::error : severity == Severity::warning ? Icon::warning : Icon::note;
}

ImU32 colour_of(Severity severity) {
    return severity == Severity::error     ? style::error
           : severity == Severity::warning ? style::warning
                                           : style::quiet_text;
}

std::span<const CommandIcon> command_icons() { return table; }

Icon icon_of(std::string_view command_name) {
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.command == command_name; });
    return found == table.end() ? Icon::none : found->icon;
}

}  // namespace hanei
