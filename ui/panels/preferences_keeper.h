/// Keeps preferences on disk in step with those of the window.
#pragma once

#include "ui/panels/user_door.h"

namespace hanei {

/// How many projects are remembered.
inline constexpr std::size_t most_recent = 12;

/// The project becomes the newest of the list, once; the oldest falls out.
void remember(std::vector<std::filesystem::path>& recent, const std::filesystem::path& project);

class PreferencesKeeper {
public:
    explicit PreferencesKeeper(UserDoor door) : door_(std::move(door)) {}

    /// As they are kept, with remarks on a file that could not be read. Defaults when nothing is kept.
    UserDoor::Opened open();

    /// Adds what other windows opened meanwhile, too.
    void remember_project(Preferences& now, const std::filesystem::path& project);

    /// Once a frame: writes what changed. Returns what went wrong, once a change.
    std::optional<Diagnostic> keep(const Preferences& now);

private:
    UserDoor door_;
    Preferences kept_;
};

}  // namespace hanei
