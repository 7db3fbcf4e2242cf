#include "app/user_folders.h"

#include "app/calibration_file.h"
#include "app/preferences_file.h"
#include "app/recovery_folder.h"

#include <cstdlib>

namespace hanei {
namespace {

/// The rules ask to overlook paths that are not absolute.
std::filesystem::path folder_named(const char* variable, const char* below_home) {
    const char* const named = std::getenv(variable);
    if (named != nullptr && std::filesystem::path(named).is_absolute()) return named;
    const char* const home = std::getenv("HOME");
    if (home == nullptr || !std::filesystem::path(home).is_absolute()) return {};
    return std::filesystem::path(home) / below_home;
}

}  // namespace

std::optional<UserFolders> user_folders(const std::optional<std::filesystem::path>& named) {
    if (named) return UserFolders{*named / "preferences.json", *named / "recovery", *named / "calibration.json"};
    const std::filesystem::path config = folder_named("XDG_CONFIG_HOME", ".config");
    const std::filesystem::path state = folder_named("XDG_STATE_HOME", ".local/state");
    if (config.empty() || state.empty()) return std::nullopt;
    return UserFolders{config / "hanei/preferences.json", state / "hanei/recovery", state / "hanei/calibration.json"};
}

UserDoor user_door(const UserFolders& folders) {
    UserDoor door;
    door.open_preferences = [file = folders.preferences] { return read_preferences(file); };
    door.save_preferences = [file = folders.preferences](const Preferences& preferences) {
        return write_preferences(preferences, file);
    };
    door.recovery = recovery_door(folders.recovery);
    door.open_calibration = [file = folders.calibration] { return read_calibration(file).calibration; };
    door.keep_learned = [file = folders.calibration](const std::vector<CalibrationSample>& learned) {
        add_learned(learned, file);
    };
    return door;
}

}  // namespace hanei
