/// Where what belongs to the user is kept.
#pragma once

#include "ui/panels/user_door.h"

#include <filesystem>
#include <optional>

namespace hanei {

struct UserFolders {
    std::filesystem::path preferences;  ///< the file
    std::filesystem::path recovery;     ///< the folder of unsaved work
    std::filesystem::path calibration;  ///< the file of what studies took on this machine
};

/// As the XDG rules say (XDG_CONFIG_HOME and XDG_STATE_HOME, else below HOME), or all below the folder
/// that is named. Nothing when there is no home.
std::optional<UserFolders> user_folders(const std::optional<std::filesystem::path>& named);

UserDoor user_door(const UserFolders& folders);

}  // namespace hanei
