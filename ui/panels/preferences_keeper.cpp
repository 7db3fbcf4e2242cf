#include "ui/panels/preferences_keeper.h"

#include <algorithm>
#include <utility>

namespace hanei {

void remember(std::vector<std::filesystem::path>& recent, const std::filesystem::path& project) {
    std::error_code failure;
    std::filesystem::path whole = std::filesystem::absolute(project, failure).lexically_normal();
    if (failure || project.empty()) return;
    recent.erase(std::remove(recent.begin(), recent.end(), whole), recent.end());
    recent.insert(recent.begin(), std::move(whole));
    if (recent.size() > most_recent) recent.resize(most_recent);
}

UserDoor::Opened PreferencesKeeper::open() {
    UserDoor::Opened opened;
    if (door_.open_preferences) opened = door_.open_preferences();
    kept_ = opened.preferences;
    return opened;
}

void PreferencesKeeper::remember_project(Preferences& now, const std::filesystem::path& project) {
    if (door_.open_preferences) now.recent = door_.open_preferences().preferences.recent;
    remember(now.recent, project);
}

std::optional<Diagnostic> PreferencesKeeper::keep(const Preferences& now) {
    if (!door_.save_preferences || now == kept_) return std::nullopt;
    kept_ = now;
    return door_.save_preferences(now);
}

}  // namespace hanei
