#include "ui/panels/document.h"

#include "engine/edit/arrangements.h"

namespace hanei {

Document::Document(ProjectContent content, std::filesystem::path file)
    : history_(std::move(content.scene)),
      settings_(content.settings),
      saved_settings_(content.settings),
      file_(std::move(file)) {
    history_.mark_saved();
}

void Document::propose(Scene scene, std::string step) {
    if (scene == *shown()) return;
    working_ = std::make_shared<const Scene>(std::move(scene));
    step_ = std::move(step);
}

void Document::settle() {
    if (!working_) return;
    history_.commit(with_arrangements_kept(*working_), step_);
    working_.reset();
}

void Document::commit(Scene scene, std::string step) {
    settle();
    history_.commit(with_arrangements_kept(std::move(scene)), std::move(step));
}

void Document::undo() {
    settle();
    if (history_.can_undo()) history_.undo();
}

void Document::redo() {
    settle();
    if (history_.can_redo()) history_.redo();
}

bool Document::is_saved() const { return !working_ && history_.is_saved() && settings_ == saved_settings_; }

void Document::mark_saved(std::filesystem::path file) {
    settle();
    history_.mark_saved();
    saved_settings_ = settings_;
    file_ = std::move(file);
}

std::string Document::title() const {
    if (!file_.empty()) return file_.stem().string();
    return shown()->title.empty() ? "Untitled" : shown()->title;
}

}  // namespace hanei
