/// One wish in percent in place of method, patch width and accuracy.
#pragma once

#include "engine/solution/solution.h"
#include "engine/study/presets.h"
#include "ui/panels/form.h"

namespace hanei {

/// Three presets as buttons and any wish as a figure, each with the time and the error it is predicted to
/// have. Predictions are made anew when the scene or what is known of the machine has changed.
class PresetRows {
public:
    /// Returns   the settings that were asked for.
    std::optional<Settings> draw(const SceneSnapshot& scene, const Settings& settings, const Calibration& calibration,
                                 Form& form);

private:
    void predict(const SceneSnapshot& scene, const Settings& settings, const Calibration& calibration);

    SceneSnapshot scene_;
    Settings settings_;
    std::size_t known_ = 0;
    std::array<Suggestion, presets.size()> suggestions_;
    Prediction present_;                ///< of the settings as they are
    std::optional<Settings> made_for_;  ///< by the wish that was typed
    double wished_ = 0.0;               ///< percent
};

}  // namespace hanei
