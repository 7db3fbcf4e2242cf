/// Unsaved work on disk: one file a window, and a lock that tells whether the window lives.
#pragma once

#include "ui/panels/recovery_door.h"

#include <filesystem>
#include <map>
#include <mutex>

namespace hanei {

/// A window's work lies in NAME.work: a line of JSON that says whose it is, then the text of a project.
/// NAME.lock is locked for as long as its window lives; the system lets go of it however the window
/// ends. Work whose lock can be had is lost work.
///
/// Needs     one caller of keep() and forget() at a time, and one of lost(); discard() may be called beside
///           both. Any number of windows and programs share the folder.
class RecoveryFolder {
public:
    explicit RecoveryFolder(std::filesystem::path folder);
    ~RecoveryFolder();
    RecoveryFolder(const RecoveryFolder&) = delete;
    RecoveryFolder& operator=(const RecoveryFolder&) = delete;

    std::optional<Diagnostic> keep(const Scene& scene, const Settings& settings, const std::filesystem::path& original);
    void forget();

    std::vector<LostWork> lost();
    Opened<ProjectContent> open(const LostWork& work) const;
    void discard(const LostWork& work);

private:
    std::filesystem::path folder_;
    std::string name_;                              ///< of this window's files
    int own_lock_ = -1;                             ///< open file; none before the first keep()
    std::mutex guard_;                              ///< of what is claimed
    std::map<std::filesystem::path, int> claimed_;  ///< locks of lost work, by its file
};

RecoveryDoor recovery_door(const std::filesystem::path& folder);

}  // namespace hanei
