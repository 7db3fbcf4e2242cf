#include "ui/panels/pane_set.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hanei {
namespace {

constexpr float gap = 3.0F;           // pixels between pictures
constexpr double least_share = 0.15;  // of the view, for every picture

}  // namespace

std::size_t PaneSet::set_of(PaneLayout layout) {
    return layout == PaneLayout::split ? 1 : layout == PaneLayout::four ? 2 : 0;
}

/// A layout's pictures when it is first shown, the present one among them.
void PaneSet::fill(PaneLayout layout, const Slot& present, const Bounds& bounds) {
    Slots& slots = sets_[set_of(layout)];
    const bool drawing = standpoint_of(present.camera).has_value();
    const auto from = [&](Standpoint standpoint) {
        Slot slot;
        slot.part = present.part;
        slot.standpoint = standpoint;
        slot.camera = slot.given = camera_at(standpoint, bounds, 1.5);  // fitted to its shape when it has one
        return slot;
    };
    if (layout == PaneLayout::split) {
        slots[0] = present;
        slots[1] = from(drawing ? Standpoint::overview : Standpoint::plan);
    } else {
        slots = {from(Standpoint::plan), drawing ? from(Standpoint::overview) : present, from(Standpoint::front),
                 from(Standpoint::right)};
    }
}

void PaneSet::choose(PaneLayout layout, Present present, const Bounds& bounds) {
    if (layout == layout_) return;
    const std::size_t from = set_of(layout_), to = set_of(layout);
    Slot& shown = slots()[index(active_)];
    shown.camera = present.camera;
    shown.part = present.part;
    last_active_[from] = active_;
    if (layout == PaneLayout::four_parts) before_parts_ = layout_;
    layout_ = layout;
    if (from == to) return;
    active_ = last_active_[to];
    if (!std::exchange(filled_[to], true))
        fill(layout, shown, bounds);
    else if (from == 0 || to == 0)
        slots()[index(active_)] = shown;
    present.camera = slots()[index(active_)].camera;
    present.part = slots()[index(active_)].part;
}

void PaneSet::toggle(PaneLayout layout, Present present, const Bounds& bounds) {
    const PaneLayout without = layout == PaneLayout::four_parts ? before_parts_ : PaneLayout::single;
    choose(layout_ == layout ? without : layout, present, bounds);
}

void PaneSet::activate(int k, Present present) {
    if (k == active_ || !is_divided()) return;
    Slot& left = slots()[index(active_)];
    left.camera = present.camera;
    left.part = present.part;
    active_ = k;
    present.camera = slots()[index(k)].camera;
    present.part = slots()[index(k)].part;
}

void PaneSet::lay_out(const ScreenRect& all, const Camera& present) {
    const float whole_width = all.right - all.left, whole_height = all.bottom - all.top;
    const auto first = [](float whole, double share, bool cut) {
        return cut ? std::floor((whole - gap) * static_cast<float>(std::clamp(share, least_share, 1.0 - least_share)))
                   : whole;
    };
    const Vec2 shares = shows_parts() ? Vec2(0.5) : divider;
    const float width = first(whole_width, shares.x, count() > 1);
    const float height = first(whole_height, shares.y, count() > 2);
    for (int k = 0; k < most; ++k) {
        const bool right = k % 2 == 1, low = k / 2 == 1;
        Pane& pane = panes_[index(k)];
        pane.left = all.left + (right ? width + gap : 0.0F);
        pane.top = all.top + (low ? height + gap : 0.0F);
        pane.width = std::max(1.0F, right ? all.right - pane.left : width);
        pane.height = std::max(1.0F, low ? all.bottom - pane.top : height);
        pane.camera = camera(k, present);
    }
}

std::optional<int> PaneSet::under(ImVec2 at) const {
    for (int k = 0; k < count(); ++k) {
        if (pane(k).holds(at)) return k;
    }
    return std::nullopt;
}

const Camera& PaneSet::camera(int k, const Camera& present) const {
    return k == active_ || !is_divided() ? present : slots()[index(k)].camera;
}

LightPart PaneSet::part(int k, LightPart present) const {
    if (shows_parts()) return parts[index(k)];
    return k == active_ || !is_divided() ? present : slots()[index(k)].part;
}

bool PaneSet::shows(LightPart wanted, LightPart present) const {
    for (int k = 0; k < count(); ++k) {
        if (part(k, present) == wanted) return true;
    }
    return false;
}

void PaneSet::fit(Slot& slot, const Pane& pane, const Bounds& bounds, float covered) {
    const double share = pane.width > 2.0F * covered ? static_cast<double>(covered / pane.height) : 0.0;
    slot.shape = {pane.width, pane.height};
    const Camera fitted = camera_at(*slot.standpoint, bounds, pane.aspect() - share);
    const LeftOut left_out = slot.camera.left_out;
    slot.camera = panned(fitted, {-0.5 * share, 0.0}, pane.aspect());
    slot.camera.left_out = left_out;
    slot.given = slot.camera;
}

void PaneSet::look_from(Standpoint standpoint, Camera& present, const Bounds& bounds, float covered) {
    Slot& slot = slots()[index(active_)];
    slot.standpoint = standpoint;
    slot.camera = present;
    fit(slot, active_pane(), bounds, covered);
    present = slot.camera;
}

void PaneSet::follow_shapes(Camera& present, const Bounds& bounds, float covered) {
    slots()[index(active_)].camera = present;
    for (int k = 0; k < (is_divided() ? count() : 1); ++k) {
        Slot& slot = slots()[index(k)];
        const bool reshaped = slot.shape != Vec2(pane(k).width, pane(k).height);
        slot.given.left_out = slot.camera.left_out;  // no change of place
        if (reshaped && slot.standpoint && slot.camera == slot.given) fit(slot, pane(k), bounds, covered);
    }
    present = slots()[index(active_)].camera;
}

}  // namespace hanei
