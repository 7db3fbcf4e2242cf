/// The pictures of the view: how many there are, where they stand, from where each looks, and which
/// of them commands act on.
#pragma once

#include "ui/panels/pane.h"
#include "ui/panels/widget_registry.h"
#include "ui/view/standpoint.h"
#include "ui/view/view_options.h"

#include <array>

namespace hanei {

enum class PaneLayout {
    single,
    split,      ///< two side by side
    four,       ///< plan, perspective, front and right side
    four_parts  ///< total, direct, unshadowed and interreflected light, all through one camera
};

/// Holds     camera and part of all pictures but the active one. That one's are kept by whoever keeps
///           the set and are handed in: there is one present camera, whatever is on the screen.
class PaneSet {
public:
    struct Present {
        Camera& camera;
        LightPart& part;
    };

    PaneLayout layout() const { return layout_; }
    bool shows_parts() const { return layout_ == PaneLayout::four_parts; }
    bool is_divided() const { return layout_ == PaneLayout::split || layout_ == PaneLayout::four; }
    int count() const { return layout_ == PaneLayout::single ? 1 : layout_ == PaneLayout::split ? 2 : 4; }
    int active() const { return active_; }

    /// The first split puts the plan beside the present picture, the first four put the usual
    /// drawings around it. A single picture is the active one of before, and steps back into its place.
    void choose(PaneLayout layout, Present present, const Bounds& bounds);
    /// The layout; when it is there already, a single picture, or what was there before the four parts.
    void toggle(PaneLayout layout, Present present, const Bounds& bounds);
    void activate(int k, Present present);

    /// Places the pictures in the rectangle, by the divider.
    void lay_out(const ScreenRect& all, const Camera& present);
    const Pane& pane(int k) const { return panes_[index(k)]; }
    const Pane& active_pane() const { return pane(active_); }
    /// The picture that holds this place of the screen; empty between and beside them.
    std::optional<int> under(ImVec2 at) const;

    const Camera& camera(int k, const Camera& present) const;
    LightPart part(int k, LightPart present) const;
    bool shows(LightPart part, LightPart present) const;  ///< in any of the pictures

    /// The active picture from a standpoint, and so again whenever it changes its shape while its
    /// camera is left alone. `covered` pixels at its right are kept clear.
    void look_from(Standpoint standpoint, Camera& present, const Bounds& bounds, float covered);
    /// Once a frame, after lay_out.
    void follow_shapes(Camera& present, const Bounds& bounds, float covered);

    Vec2 divider{0.5, 0.5};  ///< shares of width and height that the first picture has

    static constexpr int most = 4;
    static constexpr std::array<LightPart, most> parts{LightPart::total, LightPart::direct, LightPart::unshadowed,
                                                       LightPart::interreflected};

private:
    struct Slot {
        Camera camera;
        LightPart part = LightPart::total;
        std::optional<Standpoint> standpoint;  ///< chosen last, what it gave, and for which pixels
        Camera given;
        Vec2 shape{0.0};
    };
    using Slots = std::array<Slot, most>;

    Slots& slots() { return sets_[set_of(layout_)]; }
    const Slots& slots() const { return sets_[set_of(layout_)]; }
    static std::size_t set_of(PaneLayout layout);
    void fill(PaneLayout layout, const Slot& present, const Bounds& bounds);
    static std::size_t index(int k) { return static_cast<std::size_t>(k); }
    static void fit(Slot& slot, const Pane& pane, const Bounds& bounds, float covered);

    PaneLayout layout_ = PaneLayout::single, before_parts_ = PaneLayout::single;
    int active_ = 0;
    std::array<Pane, most> panes_{};
    std::array<Slots, 3> sets_{};              ///< of single, split, four
    std::array<int, 3> last_active_{0, 0, 1};  ///< of each
    std::array<bool, 3> filled_{true, false, false};
};

}  // namespace hanei
