/// How exact an answer is wished to be, in one figure, and which settings give it on a scene.
#pragma once

#include "engine/study/calibration.h"

#include <array>
#include <string_view>

namespace hanei {

/// Three usual wishes: draft follows the hand, design decides between variants, verify stands in a report.
enum class Preset { draft, design, verify };
inline constexpr std::array presets{Preset::draft, Preset::design, Preset::verify};

std::string_view name_of(Preset preset);  ///< "draft", as every door writes it
std::optional<Preset> preset_named(std::string_view name);

/// The share of the value that 95 of 100 points shall be within: 10 %, 3 %, 1 %.
double wished_error(Preset preset);

inline constexpr double least_wish = 0.001, greatest_wish = 0.5;  ///< shares that can be wished for

struct Suggestion {
    Settings settings;
    Prediction prediction;
    bool reaches = true;  ///< the prediction is within the wish; false: the most exact there is falls short of it
};

/// Method, patch width, number of interreflections and accuracy of the iteration for the wish: the
/// soonest of all that are predicted to be within it, of the methods patch and linear with widths that fit the scene.
/// What else `from` sets (threads, memory, tolerance) stays.
///
/// Returns   the most exact there is when none reaches the wish. A scene without faces: `from` as it is.
/// Cost      that of counting patches some thirty times: milliseconds.
Suggestion settings_for(const Scene& scene, const Settings& from, double wished_share, const Calibration& calibration);

inline Suggestion settings_for(const Scene& scene, const Settings& from, Preset preset,
                               const Calibration& calibration) {
    return settings_for(scene, from, wished_error(preset), calibration);
}

}  // namespace hanei
