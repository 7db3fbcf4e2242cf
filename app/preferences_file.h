/// Preferences as a file: preferences.json in the user's folder.
#pragma once

#include "ui/panels/user_door.h"

#include <filesystem>
#include <string_view>

namespace hanei {

/// Preferences of a JSON text; `file` is what remarks call it. A field that is missing, of another kind
/// or out of its range is as it is by default; what is not of this version is kept.
UserDoor::Opened preferences_of_text(std::string_view json, const std::filesystem::path& file);

/// A missing file gives the defaults without a remark.
UserDoor::Opened read_preferences(const std::filesystem::path& file);

std::string preferences_text(const Preferences& preferences);

/// Makes the folder when it is not there; the file is written whole or not at all.
std::optional<Diagnostic> write_preferences(const Preferences& preferences, const std::filesystem::path& file);

}  // namespace hanei
