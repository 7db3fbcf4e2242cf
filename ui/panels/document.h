/// What is being edited: the scene with its history, the settings, and where both are kept.
#pragma once

#include "ui/panels/edit_history.h"
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
    void abandon();                               ///< ends it as if it had never been
    bool in_gesture() const { return working_ != nullptr || working_settings_.has_value(); }

    void commit(Scene scene, std::string step);             ///< a change without a gesture
    void commit(ProjectContent content, std::string step);  ///< of the settings too
    void undo();
    void redo();
    void go_to(std::size_t step);  ///< of the history
    const EditHistory& history() const { return history_; }

    const Settings& settings() const { return working_settings_ ? *working_settings_ : history_.settings(); }
    void set_settings(const Settings& settings);  ///< begins or continues a gesture, as propose() does

    ProjectContent content() const { return {*shown(), settings()}; }
    const std::filesystem::path& file() const { return file_; }
    bool is_saved() const;
    void mark_saved(std::filesystem::path file);
    std::string title() const;  ///< file name without its ending, or the scene's title

private:
    EditHistory history_;
    SceneSnapshot working_;
    std::optional<Settings> working_settings_;
    std::string step_;
    std::filesystem::path file_;
};

}  // namespace hanei
