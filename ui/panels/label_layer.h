/// Figures of calculation points and grids over every picture.
#pragma once

#include "ui/panels/viewport.h"
#include "ui/view/value_labels.h"

namespace hanei {

class LabelLayer : public ViewOverlay {
public:
    /// `state`: what the pictures show; it must outlive the layer.
    explicit LabelLayer(const ViewState& state) : state_(state) {}

    std::optional<double> difference;  ///< lx: figures are differences (Viewport::Input)

    void draw(const PaneSight& sight, WidgetRegistry& widgets) override;

private:
    ViewOptions options_of(const PaneSight& sight) const;

    const ViewState& state_;
    struct Kept {
        std::vector<ValueLabel> labels;
        SolutionSnapshot solution;
        Camera camera;
        ViewOptions options;
        PixelSize size;
    } kept_[4];
};

}  // namespace hanei
