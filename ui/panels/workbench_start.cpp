#include "ui/panels/language.h"
#include "ui/panels/workbench.h"

namespace hanei {

void Workbench::ask_new_project() {
    furnishing_.ask_new_project(door_.examples ? door_.examples() : std::vector<std::filesystem::path>());
}

void Workbench::offer_start() {
    if (preferences_.shows_start_page && !recovery_.is_open()) open_start_page();
}

/// It is there at once; what the disk says of projects comes when it does.
void Workbench::open_start_page() {
    start_page_.open(static_cast<bool>(door_.user.recovery.lost));
    start_look_.start({}, [this, recent = preferences_.recent, examples = door_.examples](const Work&) {
        const auto recent_rows = StartPage::rows_of(recent, StartPage::Wish::project);
        const auto files = examples ? examples() : std::vector<std::filesystem::path>();
        auto example_rows = StartPage::rows_of(files, StartPage::Wish::example);
        for (StartPage::Row& row : StartPage::rows_of_gallery(files)) example_rows.push_back(std::move(row));
        return [this, recent_rows, example_rows] { start_page_.show(recent_rows, example_rows); };
    });
}

void Workbench::start_wish(const StartPage::Outcome& outcome) {
    using Wish = StartPage::Wish;
    switch (outcome.wish) {
        case Wish::none:
            return;
        case Wish::new_room:
            return guarded([this] { ask_new_project(); });
        case Wish::open:
            return guarded([this] { open_file(); });
        case Wish::recover:
            return carry_out(CommandId::recover_work);
        case Wish::project:
            return guarded([this, file = outcome.file] { load(file); });
        case Wish::example:
            return guarded([this, file = outcome.file] { begin_from(file); });
        case Wish::gallery:
            return browser_.open(
                {"Open a hard case", "Open", {".hanei"}, false, outcome.file, ""},
                [this](const std::filesystem::path& file) { guarded([this, file] { begin_from(file); }); });
    }
}

/// A copy: saving it asks for a name.
void Workbench::begin_from(const std::filesystem::path& example) {
    file_work_.start(say("Opening {}", example.filename().string()),
                     [this, open = door_.open, example, as_before = is_as_before()](const Work&) {
                         const auto opened = std::make_shared<Opened<ProjectContent>>(open(example));
                         return [this, opened, example, as_before] {
                             const auto take = [this, opened, example] {
                                 messages_.note("File", opened->findings);
                                 if (!opened->content)
                                     return dialogs_.show_findings("This project cannot be opened", opened->findings);
                                 show(Document(std::move(*opened->content)));
                                 viewport_.take_up(nullptr);
                                 furnishing_.room = {};
                                 message_ = say("A copy of {}", example.filename().string());
                             };
                             as_before() ? take() : guarded(take);
                         };
                     });
}

}  // namespace hanei
