#include "ui/panels/illuminance_text.h"
#include "ui/panels/workbench.h"

namespace hanei {

void Workbench::follow_scale() {
    show_illuminance_in(preferences_.illuminance);
    viewport_.state.options.unit = preferences_.illuminance;
    readings_.scale.follow(viewport_.state.options, *document_.shown(), study_.solution().get());
}

void Workbench::fit_scale() {
    if (!study_.solution()) return;
    document_.settle();
    if (auto fitted = readings_.scale.fitted(*document_.shown(), *study_.solution()))
        document_.commit(std::move(*fitted), "Fit the scale");
}

/// What was done to the scale in its legend or in the bar over the view.
void Workbench::take_scale_wishes() {
    ViewState& view = viewport_.state;
    if (auto wished = readings_.scale.wished(*document_.shown(), view.options))
        propose(std::move(*wished), "Change the scale");
    if (std::exchange(view.fit_asked, false)) fit_scale();
    const bool keep = std::exchange(view.keep_asked, false), release = std::exchange(view.automatic_asked, false);
    if (!keep && !release) return;
    Scene wished = *document_.shown();
    wished.colour_scale = keep ? std::optional(scale_of(view.options)) : std::nullopt;
    document_.settle();
    document_.commit(std::move(wished), keep ? "Keep the scale" : "Let the scale follow the light");
}

}  // namespace hanei
