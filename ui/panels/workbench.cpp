#include "ui/panels/workbench.h"

#include "engine/edit/edit.h"
#include "ui/panels/checks.h"
#include "ui/panels/style.h"
#include "ui/panels/units.h"
#include "ui/panels/window_layout.h"

#include <algorithm>
#include <cmath>
#include <imgui_internal.h>

namespace hanei {
Workbench::Workbench(ProjectContent content, std::filesystem::path file, ProjectDoor door, std::function<void()> wake,
                     Options how)
    : how_(how),
      door_(std::move(door)),
      document_(std::move(content), std::move(file)),
      study_(wake),
      exact_(wake),
      file_work_(wake, how.patience,
                 [this](const std::string& fault) {
                     Diagnostic told;
                     told.message = fault;
                     tell("File", told);
                 }),
      start_look_(wake, how.patience, [](const std::string&) {}),
      keeper_(door_.user),
      export_(wake, how.patience),
      stamp_(stamp_of(document_.file())),
      autosave_(door_.user.recovery, wake) {
    read_preferences();
    offer_recovery();
    checks_ = std::make_shared<Checks>(wake, how.patience);
    readings_.study.connect(door_.user, wake);
    readings_.effects.connect(wake);
    readings_.wake = std::move(wake);
    viewport_.state.options.pins = true;
    overlays_ = {&furnishing_,         &readings_.labels,  &readings_.why,
                 &readings_.snapshots, &readings_.profile, &readings_.effects};
    viewport_.state.options.grids = false;  // dots over every surface; shown with a chosen grid, or by N
}

std::string Workbench::title() const { return (document_.is_saved() ? "" : "• ") + document_.title() + " – Hanei"; }

void Workbench::read_keys() {
    const ImGuiIO& io = ImGui::GetIO();
    const bool blocked =
        is_asking() || viewport_.dragging() || io.WantTextInput || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
    const bool menu_open = !is_asking() && !io.WantTextInput &&
                           ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    if (menu_open && ImGui::IsKeyPressed(static_cast<int>(Key::escape))) return ImGui::ClosePopupToLevel(0, true);
    if (blocked || menu_open) return;
    if (viewport_.tool() != nullptr && ImGui::IsKeyPressed(static_cast<int>(Key::escape)))
        return viewport_.take_up(nullptr);
    for (int k = 1; k < key_count; ++k) {
        if (!ImGui::IsKeyPressed(k, k >= static_cast<int>(Key::right) && k <= static_cast<int>(Key::page_down)))
            continue;
        const Chord chord{static_cast<Key>(k), io.KeyCtrl, io.KeyShift, io.KeyAlt};
        if (viewport_.tool() != nullptr && viewport_.tool()->takes(chord)) continue;
        const Command* entry = command_for(chord);
        if (entry != nullptr && can(entry->id)) carry_out(entry->id);
    }
}

void Workbench::propose(Scene scene, std::string step) {
    document_.propose(std::move(scene), std::move(step));
    gesture_item_ = form_.finished() ? 0 : ImGui::GetCurrentContext()->ActiveId;
}

/// A gesture ends when the item it began with is let go.
void Workbench::settle() {
    if (!document_.in_gesture() || viewport_.dragging() || furnishing_.is_asking()) return;
    if (gesture_item_ == 0 || ImGui::GetCurrentContext()->ActiveId != gesture_item_) document_.settle();
}

void Workbench::follow_study() {
    const bool unshadowed =
        viewport_.state.panes.shows(LightPart::unshadowed, viewport_.state.options.part) || export_.wants_unshadowed();
    const bool shadows = viewport_.state.options.shadow_classes || viewport_.state.options.shadow_outlines;
    study_.follow({document_.shown(), document_.settings(), unshadowed, document_.in_gesture(), shadows});
    follow_scale();
}

void Workbench::draw(const ViewPainter& paint) {
    ++frames_;
    widgets_.begin_frame();
    form_.begin_frame();
    show_units(preferences_.length, preferences_.illuminance);
    read_keys();
    selection_.keep_existing(*document_.shown());
    follow_study();
    follow_readings();
    menu_bar();

    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const WindowLayout layout = lay_out(preferences_, screen.x, screen.y, ImGui::GetFrameHeight(), style::scale());
    // Fields first: what was typed there is finished by a click elsewhere, before that click counts.
    right(layout.right);
    left(layout);
    bottom(layout.bottom);
    centre(layout.centre, paint);
    if (shows_overview_) {
        // The view's size is known once it was drawn.
        viewport_.look_from(Standpoint::overview, *document_.shown());
        shows_overview_ = false;
    }
    settle();
    follow_study();
    status_line(layout.status);
    exact_.draw(
        paint, [this] { save_exact(); }, widgets_);
    model_import_.draw(form_, file_work_.busy() ? std::optional(file_work_.task()) : std::nullopt);
    if (auto made = start_layout_.draw(*document_.shown(), form_)) {
        document_.commit(std::move(made->scene), "Start layout");
        selection_.choose(made->object);
    }
    furnishing_wish(furnishing_.questions(*document_.history().now(), selection_, form_));
    popups();
    dialogs_.draw(widgets_);
    browser_.draw(widgets_);
    preferences_dialog_.draw(preferences_, form_);
    checks_->draw(widgets_);
    start_wish(start_page_.draw(preferences_.shows_start_page, widgets_));
    draw_export();
    follow_recovery();
    start_look_.follow();
    const bool may_finish = (!is_asking() || model_import_.is_open()) && !document_.in_gesture();
    if (may_finish && !viewport_.dragging()) file_work_.follow();
    keep_preferences();
}

}  // namespace hanei
