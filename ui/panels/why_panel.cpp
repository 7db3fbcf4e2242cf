#include "ui/panels/why_panel.h"

#include "engine/edit/edit.h"
#include "ui/panels/elided.h"
#include "ui/panels/form.h"
#include "ui/panels/illuminance_text.h"
#include "ui/panels/language.h"
#include "ui/panels/panel_frame.h"
#include "ui/panels/probe.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

constexpr float least_width = 160.0F;   // of a table at scale 1
constexpr double worth_telling = 5e-4;  // of the whole: less is no row, but the first

double whole_of(const Contributions& made) { return made.value.total().value; }

double share_of(double lux, double whole) { return whole > 0.0 ? lux / whole : 0.0; }

}  // namespace

void WhyPanel::ask(const Vec3& position, const Vec3& normal, std::string name) {
    asked_ = Place{position, glm::normalize(normal), std::move(name)};
}

void WhyPanel::forget() {
    asked_.reset();
    place_.reset();
    take(nullptr);
}

void WhyPanel::take(std::shared_ptr<const Contributions> made) {
    if (made == made_) return;
    made_ = std::move(made);
    tables_.clear();
    pointed_.reset();
    if (!made_ || made_->value.inside_solid) return;
    tables_ = {{"From luminaires", "Direct light, by luminaire", rows_by_luminaire(*made_)},
               {"By group", "Direct and interreflected light, by what is dimmed together", rows_by_group(*made_)},
               {"By reflections", "Interreflected light, by how often it was reflected on its way",
                rows_by_reflections(*made_)},
               {"From surfaces", "Interreflected light, by the surface that sends it here", rows_by_surface(*made_)}};
}

void WhyPanel::follow(const Scene& scene, ObjectId chosen, LiveStudy& study) {
    // a chosen point stays the place while what lights it is chosen in the table
    for (const CalculationPoint& point : scene.points)
        if (point.id == chosen)
            asked_ = Place{point.position, glm::normalize(point.normal), display_name(scene, point.id)};
    place_ = asked_;
    if (!place_ || !is_open_) return take(nullptr);
    is_open_ = false;
    take(study.contributions(place_->position, place_->normal));
}

std::optional<ObjectId> WhyPanel::draw_table(const Table& table, int number, WidgetRegistry& widgets) {
    std::optional<ObjectId> clicked;
    const double whole = whole_of(*made_);
    const float scale = style::scale(), line = ImGui::GetTextLineHeight();
    ImGui::TextColored(style::colour(style::quiet_text), "%s  %s", tr(table.title), illuminance_unit_name());
    tooltip(tr(table.help));
    double greatest = 0.0;
    for (const ContributionRow& row : table.rows) greatest = std::max(greatest, row.lux);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        const ContributionRow& row = table.rows[k];
        if (share_of(row.lux, whole) < worth_telling) continue;
        ImGui::PushID(static_cast<int>(k));
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x;
        const float bar = static_cast<float>(share_of(row.lux, greatest)) * width;
        list.AddRectFilled({at.x, at.y + 1.0F}, {at.x + bar, at.y + line + 3.0F * scale},
                           (style::accent & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 0x4A), 2.0F * scale);
        if (ImGui::Selectable("##row", false, 0, {width, line + 3.0F * scale}) && row.object) clicked = row.object;
        if (ImGui::IsItemHovered()) pointed_ = row;
        widgets.note(fmt::format("why.{}.{}", number, row.name));
        const std::string figures =
            fmt::format("{}  {:.1f} %", illuminance_figure(row.lux), 100.0 * share_of(row.lux, whole));
        const float room = ImGui::CalcTextSize(figures.c_str()).x;
        const std::string name = elided(tr(row.name.c_str()), width - room - 16.0F * scale, Elide::middle);
        tooltip(fmt::format("{}: {}  {:.1f} %", row.name, illuminance_text(row.lux), 100.0 * share_of(row.lux, whole)));
        list.AddText({at.x + 5.0F * scale, at.y + 1.0F}, ImGui::GetColorU32(ImGuiCol_Text), name.c_str());
        list.AddText({at.x + width - room - 5.0F * scale, at.y + 1.0F}, ImGui::GetColorU32(ImGuiCol_Text),
                     figures.c_str());
        ImGui::PopID();
    }
    if (greatest <= 0.0) ImGui::TextDisabled("%s", tr("None"));
    return clicked;
}

std::optional<ObjectId> WhyPanel::table(const Scene& scene, WidgetRegistry& widgets) {
    is_open_ = true;
    pointed_.reset();
    if (!place_) {
        quiet_words(tr("Point at a place in the view and press Y, or choose a calculation point."));
        return std::nullopt;
    }
    if (!made_) {
        quiet_words(tr("The light is being divided by where it comes from."));
        return std::nullopt;
    }
    if (made_->value.inside_solid) {
        quiet_words(tr("The place lies inside furniture: no light arrives."));
        return std::nullopt;
    }
    const PointValue& value = made_->value;
    headline(
        illuminance_text(value.total().value),
        fmt::format("± {} · {} · {} {} · {} {}{}", illuminance_figure(value.error.total()), place_->name, tr("direct"),
                    illuminance_figure(value.direct.value), tr("interreflected"),
                    illuminance_figure(value.interreflected.value),
                    made_->solution->scene.get() == &scene ? "" : std::string(" · ") + tr("before the last change")));
    std::optional<ObjectId> clicked;
    const float gap = 12.0F * style::scale();
    const auto count = static_cast<float>(tables_.size());
    const float width =
        std::max(least_width * style::scale(), (ImGui::GetContentRegionAvail().x - (count - 1.0F) * gap) / count);
    ImGui::BeginChild("why tables", {0.0F, 0.0F}, false, ImGuiWindowFlags_HorizontalScrollbar);
    for (std::size_t k = 0; k < tables_.size(); ++k) {
        if (k > 0) ImGui::SameLine(0.0F, gap);
        ImGui::BeginChild(tables_[k].title, {width, 0.0F});
        if (const auto row = draw_table(tables_[k], static_cast<int>(k), widgets)) clicked = row;
        ImGui::EndChild();
    }
    ImGui::EndChild();
    return clicked;
}

void WhyPanel::draw(const PaneSight& sight, WidgetRegistry& /*widgets*/) {
    if (!made_ || !is_open_ || !place_) return;
    std::optional<ContributionRow> top = pointed_;
    for (const Table& table : tables_)
        for (const ContributionRow& row : table.rows)
            if (!pointed_ && row.from && (!top || row.lux > top->lux)) top = row;
    const auto here = sight.pane.on_screen(place_->position);
    if (!here) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float scale = style::scale();
    list.AddCircle(*here, 7.0F * scale, IM_COL32(10, 12, 14, 180), 0, 4.0F * scale);
    list.AddCircle(*here, 7.0F * scale, style::accent, 0, 2.0F * scale);
    if (!top || !top->from) return;
    for (const std::vector<ImVec2>& piece : sight.pane.on_screen(std::vector<Vec3>{*top->from, place_->position})) {
        const int count = static_cast<int>(piece.size());
        list.AddPolyline(piece.data(), count, IM_COL32(10, 12, 14, 150), ImDrawFlags_None, 5.0F * scale);
        list.AddPolyline(piece.data(), count, style::accent, ImDrawFlags_None, 2.2F * scale);
    }
    const auto from = sight.pane.on_screen(*top->from);
    if (!from) return;
    list.AddCircleFilled(*from, 5.0F * scale, style::accent);
    const std::string text = fmt::format("{}  {:.0f} %", top->name, 100.0 * share_of(top->lux, whole_of(*made_)));
    const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
    const float left = std::clamp(from->x - 0.5F * extent.x, sight.pane.left + 8.0F * scale,
                                  sight.pane.left + sight.pane.width - extent.x - 8.0F * scale);
    const float above = from->y - extent.y - 14.0F * scale;
    const float top_edge = above > sight.pane.top ? above : from->y + 12.0F * scale;
    list.AddRectFilled({left - 7.0F * scale, top_edge - 3.0F * scale},
                       {left + extent.x + 7.0F * scale, top_edge + extent.y + 4.0F * scale}, style::card, 4.0F * scale);
    list.AddText({left, top_edge}, style::text, text.c_str());
}

}  // namespace hanei
