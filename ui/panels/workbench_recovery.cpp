#include "engine/edit/edit.h"
#include "ui/panels/language.h"
#include "ui/panels/scene_difference.h"
#include "ui/panels/workbench.h"

namespace hanei {

/// At the start, and when the user asks for it.
void Workbench::offer_recovery() {
    const RecoveryDoor& door = door_.user.recovery;
    if (!door.lost) return;
    std::vector<RecoveryDialog::Offer> offers;
    for (const LostWork& work : door.lost()) {
        const Opened<ProjectContent> kept = door.open(work);
        RecoveryDialog::Offer offer{work, work.original.filename().string(), {}};
        if (work.original.empty()) offer.name = "Untitled";
        if (!kept.content) {
            offer.differs = "It cannot be read";
        } else if (work.original.empty()) {
            offer.differs = difference_text(empty_room(), kept.content->scene);
            if (!kept.content->scene.title.empty()) offer.name = kept.content->scene.title;
        } else {
            const Opened<ProjectContent> file = door_.open(work.original);
            offer.differs =
                file.content ? difference_text(file.content->scene, kept.content->scene) : "The project's file is gone";
        }
        offers.push_back(std::move(offer));
    }
    recovery_.open(std::move(offers));
}

/// The file as it is comes first in the history, so that undo leads back to it.
void Workbench::recover(const LostWork& work) {
    Opened<ProjectContent> kept = door_.user.recovery.open(work);
    messages_.note("Recovery", kept.findings);
    if (!kept.content) return dialogs_.show_findings("This work cannot be recovered", std::move(kept.findings));
    std::optional<ProjectContent> before;
    if (!work.original.empty()) before = door_.open(work.original).content;
    if (!before) before = ProjectContent{empty_room(), {}};
    show(Document(std::move(*before), work.original));
    document_.commit(std::move(*kept.content), "Recover unsaved work");
    autosave_.take_over(work);
    message_ = say("Recovered unsaved work of {}", document_.title());
}

void Workbench::follow_recovery() {
    autosave_.follow(document_, preferences_.autosave);
    if (const auto fault = autosave_.take_fault()) {
        messages_.note("Autosave", *fault);
        message_ = "Unsaved work cannot be kept: save it to another disk";
    }
    const RecoveryDialog::Outcome outcome = recovery_.draw(widgets_);
    if (outcome.wish == RecoveryDialog::Wish::recover) {
        if (document_.is_saved()) return recover(outcome.work);
        guarded([this, work = outcome.work] { recover(work); });
    }
    if (outcome.wish == RecoveryDialog::Wish::discard) door_.user.recovery.discard(outcome.work);
}

}  // namespace hanei
