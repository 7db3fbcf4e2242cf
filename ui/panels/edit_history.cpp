#include "ui/panels/edit_history.h"

#include <algorithm>
#include <utility>

namespace hanei {
namespace {

const std::string no_step;

}  // namespace

EditHistory::EditHistory(Scene first, const Settings& settings) {
    steps_.push_back({std::make_shared<const Scene>(std::move(first)), settings, ""});
    mark_saved();
}

void EditHistory::commit(SceneSnapshot scene, const Settings& settings, std::string name) {
    if (scene == now() || *scene == *now()) {
        if (settings == this->settings()) return;
        scene = now();
    }
    steps_.resize(at_ + 1);
    steps_.push_back({std::move(scene), settings, std::move(name)});
    if (steps_.size() > most_steps) steps_.erase(steps_.begin());
    at_ = steps_.size() - 1;
}

void EditHistory::undo() {
    if (can_undo()) --at_;
}

void EditHistory::redo() {
    if (can_redo()) ++at_;
}

void EditHistory::go_to(std::size_t step) { at_ = std::min(step, steps_.size() - 1); }

const std::string& EditHistory::undo_name() const { return can_undo() ? steps_[at_].name : no_step; }

const std::string& EditHistory::redo_name() const { return can_redo() ? steps_[at_ + 1].name : no_step; }

void EditHistory::mark_saved() {
    saved_scene_ = now();
    saved_settings_ = settings();
}

}  // namespace hanei
