#include "ui/panels/document.h"

#include "engine/edit/arrangements.h"

namespace hanei {

Document::Document(ProjectContent content, std::filesystem::path file)
    : history_(std::move(content.scene), content.settings), file_(std::move(file)) {}

void Document::propose(Scene scene, std::string step) {
    if (scene == *shown()) return;
    if (working_settings_) settle();
    working_ = std::make_shared<const Scene>(std::move(scene));
    step_ = std::move(step);
}

void Document::set_settings(const Settings& settings) {
    if (settings == this->settings()) return;
    if (working_) settle();
    working_settings_ = settings;
    step_ = "Change calculation";
}

void Document::abandon() {
    working_.reset();
    working_settings_.reset();
}

void Document::settle() {
    if (!in_gesture()) return;
    SceneSnapshot scene = working_ ? std::make_shared<const Scene>(with_arrangements_kept(*working_)) : history_.now();
    history_.commit(std::move(scene), settings(), step_);
    abandon();
}

void Document::commit(Scene scene, std::string step) { commit({std::move(scene), settings()}, std::move(step)); }

void Document::commit(ProjectContent content, std::string step) {
    settle();
    auto scene = std::make_shared<const Scene>(with_arrangements_kept(std::move(content.scene)));
    history_.commit(std::move(scene), content.settings, std::move(step));
}

void Document::go_to(std::size_t step) {
    settle();
    history_.go_to(step);
}

void Document::undo() {
    settle();
    if (history_.can_undo()) history_.undo();
}

void Document::redo() {
    settle();
    if (history_.can_redo()) history_.redo();
}

bool Document::is_saved() const { return !in_gesture() && history_.is_saved(); }

void Document::mark_saved(std::filesystem::path file) {
    settle();
    history_.mark_saved();
    file_ = std::move(file);
}

std::string Document::title() const {
    if (!file_.empty()) return file_.stem().string();
    return shown()->title.empty() ? "Untitled" : shown()->title;
}

}  // namespace hanei
