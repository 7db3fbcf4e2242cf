/// The window's way to the place where unsaved work outlives a crash.
#pragma once

#include "ui/panels/project_content.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hanei {

/// Unsaved work of a window that ended without saving it or giving it up.
struct LostWork {
    std::filesystem::path file;      ///< that holds it
    std::filesystem::path original;  ///< the project it belongs to; empty when it was never saved
    std::chrono::system_clock::time_point kept_at;
    int process = 0;  ///< of the window
};

/// All empty where nothing is kept.
struct RecoveryDoor {
    /// The present work takes the place of what this window kept before. From any thread, one call at a time.
    std::function<std::optional<Diagnostic>(const Scene&, const Settings&, const std::filesystem::path& original)> keep;
    std::function<void()> forget;  ///< what this window kept
    /// The newest first; from then on no other window is offered them.
    std::function<std::vector<LostWork>()> lost;
    std::function<Opened<ProjectContent>(const LostWork&)> open;
    std::function<void(const LostWork&)> discard;
};

}  // namespace hanei
