/// The window's way to what belongs to its user and to no project.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/study/calibration.h"
#include "ui/panels/preferences.h"
#include "ui/panels/recovery_door.h"

#include <functional>
#include <optional>

namespace hanei {

/// Scripts and tests leave the functions empty: then nothing of the user's is read or written.
struct UserDoor {
    struct Opened {
        Preferences preferences;
        Diagnostics findings;
    };
    /// Never fails: what cannot be read is as it is by default, with a remark.
    std::function<Opened()> open_preferences;
    std::function<std::optional<Diagnostic>(const Preferences&)> save_preferences;
    RecoveryDoor recovery = {};
    /// What studies taught about this machine.
    std::function<Calibration()> open_calibration = {};
    std::function<void(const std::vector<CalibrationSample>&)> keep_learned = {};
};

}  // namespace hanei
