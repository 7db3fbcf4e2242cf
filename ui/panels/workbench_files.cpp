#include "engine/edit/edit.h"
#include "engine/scene/faces.h"
#include "ui/panels/language.h"
#include "ui/panels/workbench.h"

namespace hanei {

std::filesystem::path Workbench::folder() const {
    return document_.file().empty() ? std::filesystem::path()
                                    : std::filesystem::absolute(document_.file()).parent_path();
}

void Workbench::guarded(std::function<void()> then) {
    document_.settle();
    if (document_.is_saved()) return then();
    dialogs_.ask_unsaved(
        document_.title(), [this, then] { save(false, then); }, then);
}

void Workbench::ask_to_quit() {
    guarded([this] {
        quits_ = true;
        autosave_.end();
    });
}

void Workbench::open_file() {
    browser_.open({"Open a project", "Open", {".hanei"}, false, folder(), ""},
                  [this](const std::filesystem::path& file) { load(file); });
}

std::function<bool()> Workbench::is_as_before() const {
    return [this, scene = document_.shown(), settings = document_.settings()] {
        return scene == document_.shown() && settings == document_.settings();
    };
}

void Workbench::load(const std::filesystem::path& file) {
    file_work_.start(say("Opening {}", file.filename().string()),
                     [this, open = door_.open, file, as_before = is_as_before()](const Work&) {
                         const auto opened = std::make_shared<Opened<ProjectContent>>(open(file));
                         return [this, opened, file, as_before] {
                             const auto take = [this, opened, file] { take_project(std::move(*opened), file); };
                             as_before() ? take() : guarded(take);
                         };
                     });
}

void Workbench::take_project(Opened<ProjectContent> opened, const std::filesystem::path& file) {
    messages_.note("File", opened.findings);
    if (!opened.findings.empty()) {
        dialogs_.show_findings(opened.content ? "Opened, with remarks" : "This project cannot be opened",
                               opened.findings);
    }
    if (!opened.content) return;
    show(Document(std::move(*opened.content), file));
    keeper_.remember_project(preferences_, file);
    message_ = say("Opened {}", file.filename().string());
}

void Workbench::save(bool under_new_name, std::function<void()> then) {
    document_.settle();
    if (!under_new_name && !document_.file().empty()) return write(document_.file(), then);
    browser_.open({"Save the project", "Save", {".hanei"}, true, folder(), document_.title() + ".hanei"},
                  [this, then](const std::filesystem::path& file) { write(file, then); });
}

void Workbench::show(Document document) {
    document_ = std::move(document);
    stamp_ = stamp_of(document_.file());
    selection_.clear();
    readings_.scale.forget();
    readings_.why.forget();
    readings_.snapshots.forget();
    readings_.profile.forget();
    shows_overview_ = true;
}

void Workbench::write(const std::filesystem::path& file, const std::function<void()>& then) {
    const FileStamp now = stamp_of(file);
    const bool same_file = !file.empty() && file == document_.file();
    if (same_file && stamp_.is_there && now.is_there && now != stamp_) return ask_about_changed_file(then);
    if (const auto fault = door_.save(document_.content(), file)) return ask_where_else(file, *fault, then);
    document_.mark_saved(file);
    message_ = say("Saved {}", file.filename().string());
    if (same_file && stamp_.is_there && !now.is_there) message_ += tr(", which was gone");
    stamp_ = stamp_of(file);
    keeper_.remember_project(preferences_, file);
    if (then) then();
}

void Workbench::ask_about_changed_file(const std::function<void()>& then) {
    const std::filesystem::path file = document_.file();
    const std::string text =
        say("{} was written by another program since it was opened here. Saving would "
            "replace what that program wrote.",
            file.filename().string());
    dialogs_.ask_choice("The file has changed", text,
                        {"Replace it by what is shown here", "Save under another name...",
                         "Open what is there, and give up the changes made here"},
                        [this, file, then](std::size_t k) {
                            if (k == 1) return save(true, then);
                            if (k == 2) return load(file);
                            stamp_ = stamp_of(file);
                            write(file, then);
                        });
}

void Workbench::ask_where_else(const std::filesystem::path& file, const Diagnostic& fault,
                               const std::function<void()>& then) {
    messages_.note("File", fault);
    message_ = say("{} was not saved", file.filename().string());
    dialogs_.ask_choice("The project was not saved", to_text(fault) + ".\n" + tr("What was there before is as it was."),
                        {"Save under another name...", "Try again"}, [this, file, then](std::size_t k) {
                            if (k == 0) return save(true, then);
                            write(file, then);
                        });
}

}  // namespace hanei
