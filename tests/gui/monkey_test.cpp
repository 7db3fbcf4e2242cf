#include "monkey.h"

#include "app/desktop.h"
#include "engine/project/project_file.h"
#include "engine/scene/scene_check.h"

#include <chrono>
#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <thread>
#include <unistd.h>

namespace hanei {
namespace {

/// HANEI_MONKEY=100000 for the long run.
int event_count() {
    const char* const wished = std::getenv("HANEI_MONKEY");
    return wished != nullptr ? std::atoi(wished) : 1500;
}

/// HANEI_MONKEY_SEED=7 for another run.
unsigned first_seed() {
    const char* const wished = std::getenv("HANEI_MONKEY_SEED");
    return wished != nullptr ? static_cast<unsigned>(std::atoi(wished)) : 1U;
}

constexpr int events_a_room = 2500;
constexpr int events_between_checks = 50;
constexpr int events_between_undoing_all = 500;

/// The door to the disk with nothing behind it that a monkey could overwrite.
ProjectDoor closed_door(std::string& saved) {
    ProjectDoor door = project_door();
    door.save = [&saved](const ProjectContent& content, const std::filesystem::path&) -> std::optional<Diagnostic> {
        saved = project_text({content.scene, content.settings});
        return {};
    };
    return door;
}

std::string errors_of(const Scene& scene) {
    std::string text;
    for (const Diagnostic& finding : check_scene(scene))
        if (finding.severity == Severity::error) text += to_text(finding) + "\n";
    return text;
}

std::string text_of(const Scene& scene) { return project_text({scene, {}}); }

/// Edits in turn until nothing is left to undo; the scene must be the one the history began with.
/// What files still bring comes first.
void undo_all(BareDesk& desk) {
    for (int k = 0; k < 6000 && desk.workbench().reads_or_writes(); ++k) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        desk.frame();
    }
    for (int k = 0; k < 20 && desk.workbench().document().in_gesture(); ++k) desk.frame();
    while (desk.workbench().can(CommandId::undo)) desk.workbench().carry_out(CommandId::undo);
    desk.frame();
}

class AMonkey : public testing::Test {
protected:
    AMonkey() : folder(std::filesystem::path(testing::TempDir()) / "hanei monkey") {
        std::filesystem::create_directories(folder);
        // What is random must not reach files that matter: a superuser becomes nobody.
        if (geteuid() == 0) {
            std::filesystem::permissions(folder, std::filesystem::perms::all);
            EXPECT_EQ(setegid(65534), 0);
            EXPECT_EQ(seteuid(65534), 0);
            became_nobody = true;
        }
        before = std::filesystem::current_path();
        std::filesystem::current_path(folder);
    }
    ~AMonkey() override {
        std::filesystem::current_path(before);
        if (!became_nobody) return;
        EXPECT_EQ(seteuid(0), 0);
        EXPECT_EQ(setegid(0), 0);
    }

    std::filesystem::path folder, before;
    bool became_nobody = false;
};

TEST_F(AMonkey, breaks_nothing_and_undo_gives_back_the_room_it_began_with) {
    const std::filesystem::path assets = std::filesystem::path(HANEI_SOURCE) / "assets";
    const std::vector<std::filesystem::path> files{assets / "photometry/downlight.ies",
                                                   assets / "photometry/linear-pendant.ies",
                                                   assets / "rooms/computer-room-panels.hanei",
                                                   assets / "pictures/computer-room.png", folder / "no such file.ies"};
    const int wished = event_count();
    int done = 0;
    for (unsigned seed = first_seed(); done < wished; ++seed) {
        Monkey monkey(seed, folder / fmt::format("events-{}.log", seed), files);
        std::string saved;
        BareDesk desk(random_room(seed), closed_door(saved));
        SceneSnapshot first;
        Scene begun_with;
        const auto follow = [&] {
            const SceneSnapshot now = desk.workbench().document().history().first();
            if (first == now) return;  // else another project was opened
            first = now;
            begun_with = *first;
        };
        for (int k = 1; k <= events_a_room && done < wished; ++k, ++done) {
            monkey.act(desk);
            const Document& document = desk.workbench().document();
            follow();
            if (k % events_between_checks == 0) {
                ASSERT_EQ(errors_of(*document.shown()), "") << "after event " << k << " of seed " << seed;
                const std::string text = project_text({*document.shown(), document.settings()});
                const ProjectRead read = read_project_text(text, "monkey.hanei");
                ASSERT_TRUE(read.project) << text;
                ASSERT_EQ(project_text(*read.project), text);
                ASSERT_TRUE(read.project->scene == *document.shown()) << text;
            }
            if (k % events_between_undoing_all == 0) {
                undo_all(desk);
                follow();
                const std::string where = fmt::format("after event {} of seed {}", k, seed);
                ASSERT_FALSE(desk.workbench().document().in_gesture()) << where;
                ASSERT_EQ(text_of(*desk.workbench().document().shown()), text_of(begun_with)) << where;
                ASSERT_TRUE(*desk.workbench().document().shown() == begun_with) << where;
            }
        }
    }
}

}  // namespace
}  // namespace hanei
