/// Undo as a stack of what was edited: the scene with the settings it is computed by.
#pragma once

#include "engine/plan/settings.h"
#include "engine/scene/scene.h"

#include <string>
#include <vector>

namespace hanei {

/// Holds     every step's scene by shared pointer: unchanged scenes cost a pointer. The oldest steps
///           go when there are more than `most_steps`.
class EditHistory {
public:
    static constexpr std::size_t most_steps = 2000;

    EditHistory(Scene first, const Settings& settings);

    const SceneSnapshot& now() const { return steps_[at_].scene; }
    const SceneSnapshot& first() const { return steps_.front().scene; }  ///< of the oldest step that is kept
    const Settings& settings() const { return steps_[at_].settings; }

    /// A finished gesture: one step, named for the menu ("Move luminaire"). Drops what was undone.
    /// What equals the present makes no step.
    void commit(SceneSnapshot scene, const Settings& settings, std::string name);

    bool can_undo() const { return at_ > 0; }
    bool can_redo() const { return at_ + 1 < steps_.size(); }
    void undo();
    void redo();
    const std::string& undo_name() const;  ///< of the step that undo() takes back; empty when none
    const std::string& redo_name() const;

    std::size_t depth() const { return at_; }  ///< steps that can be taken back
    std::size_t size() const { return steps_.size(); }
    const std::string& name_of(std::size_t step) const { return steps_[step].name; }  ///< empty for the beginning
    void go_to(std::size_t step);                                                     ///< clamped to what there is

    /// Unsaved changes: is the present the one last marked?
    void mark_saved();
    bool is_saved() const { return saved_scene_ == now() && saved_settings_ == settings(); }

private:
    struct Step {
        SceneSnapshot scene;
        Settings settings;
        std::string name;
    };
    std::vector<Step> steps_;
    std::size_t at_ = 0;
    SceneSnapshot saved_scene_;
    Settings saved_settings_;
};

}  // namespace hanei
