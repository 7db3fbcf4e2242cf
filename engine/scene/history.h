/// Undo as a stack of scenes.
#pragma once

#include "engine/scene/scene.h"

#include <string>
#include <vector>

namespace hanei {

/// Holds      every step's scene by shared pointer: unchanged scenes cost a pointer.
class History {
public:
    explicit History(Scene first);

    const SceneSnapshot& now() const { return steps_[at_].scene; }
    const SceneSnapshot& first() const { return steps_.front().scene; }

    /// A finished gesture: one step, named for the menu ("Move luminaire"). Drops what was undone.
    /// A scene equal to the present one makes no step.
    void commit(Scene scene, std::string name);

    bool can_undo() const { return at_ > 0; }
    bool can_redo() const { return at_ + 1 < steps_.size(); }
    void undo();
    void redo();
    const std::string& undo_name() const;  ///< of the step that undo() takes back; empty when none
    const std::string& redo_name() const;
    std::size_t depth() const { return at_; }

    /// Unsaved changes: is the present scene the one last marked?
    void mark_saved() { saved_ = now(); }
    bool is_saved() const { return saved_ == now(); }

private:
    struct Step {
        SceneSnapshot scene;
        std::string name;
    };
    std::vector<Step> steps_;
    std::size_t at_ = 0;
    SceneSnapshot saved_;
};

}  // namespace hanei
