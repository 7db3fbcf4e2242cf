#include "ui/panels/snapshots.h"

#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <fmt/format.h>
#include <imgui.h>

namespace hanei {

std::size_t Snapshots::keep(SolutionSnapshot solution, const ColourScale& scale) {
    list_.push_back({fmt::format("State {}", ++kept_), std::move(solution), scale});
    return list_.size() - 1;
}

void Snapshots::keep_as_a(SolutionSnapshot solution, const ColourScale& scale) {
    a_ = keep(std::move(solution), scale);
}
void Snapshots::keep_as_b(SolutionSnapshot solution, const ColourScale& scale) {
    b_ = keep(std::move(solution), scale);
}

void Snapshots::remove(std::size_t number) {
    if (number >= list_.size()) return;
    list_.erase(list_.begin() + static_cast<std::ptrdiff_t>(number));
    for (std::optional<std::size_t>* which : {&a_, &b_}) {
        if (*which == number)
            which->reset();
        else if (*which && **which > number)
            --**which;
    }
}

void Snapshots::forget() { *this = Snapshots(); }

SolutionSnapshot Snapshots::first() const { return a_ ? list_[*a_].solution : nullptr; }
SolutionSnapshot Snapshots::second(const SolutionSnapshot& present) const { return b_ ? list_[*b_].solution : present; }

const SolutionSnapshot& Snapshots::difference(const SolutionSnapshot& present) {
    const SolutionSnapshot one = first(), other = second(present);
    if (difference_.first == one && difference_.second == other) return difference_.made;
    const bool both = one && other && one->display && other->display && other->mesh;
    difference_ = {one, other, both ? difference_of(*one, *other) : nullptr};
    return difference_.made;
}

double Snapshots::range_of(LightPart part) const {
    if (range > 0.0 || !difference_.made) return range > 0.0 ? range : 1.0;
    return suggested_difference(*difference_.made, part);
}

const SolutionSnapshot& Snapshots::follow(const SolutionSnapshot& present, bool flipped) {
    shown_ = show;
    if (flipped && a_) shown_ = show != Show::a ? Show::a : b_ ? Show::b : Show::now;
    if ((shown_ == Show::a && !a_) || (shown_ == Show::b && !b_) || (shown_ == Show::difference && !a_))
        shown_ = Show::now;
    now_shown_ = nullptr;
    if (shown_ == Show::a) now_shown_ = first();
    if (shown_ == Show::b) now_shown_ = second(present);
    if (shown_ == Show::difference) now_shown_ = difference(present);
    if (!now_shown_) shown_ = Show::now;
    return now_shown_;
}

std::string Snapshots::title() const {
    if (shown_ == Show::now) return {};
    if (shown_ == Show::a) return fmt::format("A  ·  {}", list_[*a_].name);
    const std::string b_name = b_ ? list_[*b_].name : tr("now");
    if (shown_ == Show::b) return fmt::format("B  ·  {}", b_name);
    return fmt::format("B − A  ·  {} − {}", b_name, list_[*a_].name);
}

void Snapshots::draw(const PaneSight& sight, WidgetRegistry& widgets) {
    if (sight.number != 0 || shown_ == Show::now) return;
    const std::string text = title();
    const float scale = style::scale();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 at{sight.pane.left + 18.0F * scale, sight.pane.top + 14.0F * scale};
    const ImVec2 low{at.x - 9.0F * scale, at.y - 4.0F * scale};
    const ImVec2 high{at.x + size.x + 9.0F * scale, at.y + size.y + 5.0F * scale};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, style::accent, 5.0F * scale);
    list.AddText(at, style::ground, text.c_str());
    widgets.note("snapshot.shown", {low.x, low.y, high.x, high.y});
}

}  // namespace hanei
