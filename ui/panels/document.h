/// What is being edited: the scene with its history, the settings, and where both are kept.
#pragma once

#include "engine/scene/history.h"
#include "ui/panels/project_door.h"

#include <filesystem>
#include <optional>
#include <string>

namespace hanei {

/// A gesture (a drag, a typed value) shows a working copy on every frame and becomes one step of
/// the history when it ends.
class Document {
public:
    explicit Document(ProjectContent content, std::filesystem::path file = {});

    /// What is shown and solved: the working copy during a gesture, else the history's present.
    const SceneSnapshot& shown() const { return working_ ? working_ : history_.now(); }

    void propose(Scene scene, std::string step);  ///< begins or continues a gesture
    void settle();                                ///< ends it: one step, none when nothing changed
    void abandon() { working_.reset(); }          ///< ends it as if it had never been
    bool in_gesture() const { return working_ != nullptr; }

    void commit(Scene scene, std::string step);  ///< a change without a gesture
    void undo();
    void redo();
    const History& history() const { return history_; }

    const Settings& settings() const { return settings_; }
    void set_settings(const Settings& settings) { settings_ = settings; }

    ProjectContent content() const { return {*shown(), settings_}; }
    const std::filesystem::path& file() const { return file_; }
    bool is_saved() const;
    void mark_saved(std::filesystem::path file);
    std::string title() const;  ///< file name without its ending, or the scene's title

private:
    History history_;
    Settings settings_, saved_settings_;
    SceneSnapshot working_;
    std::string step_;
    std::filesystem::path file_;
};

}  // namespace hanei
