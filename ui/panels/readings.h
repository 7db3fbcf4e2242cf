/// What the light is read with: the colour scale, figures in the view, why it is bright at a place, states
/// that are compared.
#pragma once

#include "ui/panels/compare_panel.h"
#include "ui/panels/effects_panel.h"
#include "ui/panels/histogram_panel.h"
#include "ui/panels/label_layer.h"
#include "ui/panels/preset_rows.h"
#include "ui/panels/profile_panel.h"
#include "ui/panels/project_scale.h"
#include "ui/panels/study_panel.h"
#include "ui/panels/why_panel.h"

#include <functional>
#include <string>

namespace hanei {

struct Readings {
    explicit Readings(const ViewState& state) : labels(state) {}

    ProjectScale scale;
    LabelLayer labels;
    WhyPanel why;
    Snapshots snapshots;
    ProfilePanel profile;
    HistogramPanel histogram;
    StudyPanel study;
    EffectsPanel effects;
    PresetRows presets;
    std::function<void()> wake{};  ///< wants another frame
    std::string front_tab{};       ///< of the bottom panel, to come to the front in this frame; empty: stay
};

}  // namespace hanei
