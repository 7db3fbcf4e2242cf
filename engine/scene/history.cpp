#include "engine/scene/history.h"

#include <utility>

namespace hanei {
namespace {

const std::string no_step;

}  // namespace

History::History(Scene first) {
    steps_.push_back({std::make_shared<const Scene>(std::move(first)), ""});
    mark_saved();
}

void History::commit(Scene scene, std::string name) {
    if (scene == *now()) return;
    steps_.resize(at_ + 1);
    steps_.push_back({std::make_shared<const Scene>(std::move(scene)), std::move(name)});
    ++at_;
}

void History::undo() {
    if (can_undo()) --at_;
}

void History::redo() {
    if (can_redo()) ++at_;
}

const std::string& History::undo_name() const { return can_undo() ? steps_[at_].name : no_step; }

const std::string& History::redo_name() const { return can_redo() ? steps_[at_ + 1].name : no_step; }

}  // namespace hanei
