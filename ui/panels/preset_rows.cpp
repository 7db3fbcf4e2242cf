#include "ui/panels/preset_rows.h"

#include "engine/report/sweep_report.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <fmt/format.h>

namespace hanei {
namespace {

struct PresetWords {
    const char* label;
    const char* help;
};

PresetWords words_of(Preset preset) {
    switch (preset) {
        case Preset::draft:
            return {"Draft", "Follows the hand: 95 of 100 points within 10 %"};
        case Preset::design:
            return {"Design", "Decides between variants: 95 of 100 points within 3 %"};
        case Preset::verify:
            return {"Verify", "Stands in a report: 95 of 100 points within 1 %"};
    }
    return {"", ""};
}

bool is_of(const Settings& settings, const Suggestion& suggestion) { return settings == suggestion.settings; }

}  // namespace

void PresetRows::predict(const SceneSnapshot& scene, const Settings& settings, const Calibration& calibration) {
    const bool same_scene = scene_ == scene || (scene_ && *scene_ == *scene);
    if (same_scene && settings == settings_ && known_ == calibration.samples().size()) return;
    scene_ = scene;
    settings_ = settings;
    known_ = calibration.samples().size();
    for (std::size_t k = 0; k < presets.size(); ++k)
        suggestions_[k] = settings_for(*scene, settings, presets[k], calibration);
    present_ = calibration.predict(*scene, settings);
}

std::optional<Settings> PresetRows::draw(const SceneSnapshot& scene, const Settings& settings,
                                         const Calibration& calibration, Form& form) {
    predict(scene, settings, calibration);
    std::optional<Settings> wished;
    for (std::size_t k = 0; k < presets.size(); ++k) {
        const Suggestion& suggestion = suggestions_[k];
        const PresetWords words = words_of(presets[k]);
        const std::string name = fmt::format("preset.{}", name_of(presets[k]));
        if (form.button(name.c_str(), words.label, words.help)) wished = suggestion.settings;
        const std::string figures =
            fmt::format("{}, {}", time_text(suggestion.prediction.ms), percent_text(suggestion.prediction.error));
        form.fact(is_of(settings, suggestion) ? "in use" : "predicted", figures);
    }
    double percent = made_for_ && *made_for_ == settings ? wished_ : 100.0 * present_.error;
    const NumberField field{"preset.within",
                            "Within",
                            "%",
                            "The error that 95 of 100 points shall be within: chooses method, patch width and accuracy",
                            100.0 * least_wish,
                            100.0 * greatest_wish,
                            0.05,
                            2};
    if (form.number(field, percent)) {
        wished = settings_for(*scene, settings, 0.01 * percent, calibration).settings;
        made_for_ = wished;
        wished_ = percent;
    }
    form.fact("now", fmt::format("{}, {}", time_text(present_.ms), percent_text(present_.error)));
    form.remark(present_.studies == 0
                    ? tr("Predicted from other machines: Results > Accuracy against time teaches this one.")
                : present_.same_room ? tr("Predicted from studies of this room on this machine.")
                                     : tr("Predicted from studies of other rooms on this machine."),
                false);
    return wished;
}

}  // namespace hanei
