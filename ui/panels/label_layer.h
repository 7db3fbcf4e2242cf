/// Figures of calculation points and grids over every picture.
#pragma once

#include "ui/panels/snapping.h"
#include "ui/panels/viewport.h"
#include "ui/view/value_labels.h"

namespace hanei {

/// A press on a pin's label takes hold of the pin.
class LabelLayer : public ViewOverlay, public ViewGrips {
public:
    /// `state`: what the pictures show; it must outlive the layer.
    explicit LabelLayer(const ViewState& state) : state_(state) {}

    std::optional<double> difference;  ///< lx: figures are differences (Viewport::Input)
    std::optional<Vec3> dragged;       ///< where something is dragged: labels keep clear of how far it went
    SnapSettings snap;                 ///< that pins catch at
    ViewGrips* others = nullptr;       ///< asked first

    void draw(const PaneSight& sight, WidgetRegistry& widgets) override;
    std::unique_ptr<ViewTool> take(const PaneSight& sight) override;

private:
    ViewOptions options_of(const PaneSight& sight) const;

    struct Pin {
        ObjectId id;
        ScreenRect label;
    };
    std::vector<Pin> pins_[4];  ///< as drawn last

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
