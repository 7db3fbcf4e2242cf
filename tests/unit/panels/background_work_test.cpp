#include "ui/panels/background_work.h"

#include "engine/base/stoppable.h"
#include "ui/panels/luminaire_batch.h"

#include <atomic>
#include <fstream>
#include <gtest/gtest.h>
#include <stdexcept>

namespace hanei {
namespace {

/// Follows until nothing is under way, ten seconds at most.
void follow_to_end(BackgroundWork& work) {
    for (int k = 0; k < 1000 && work.busy(); ++k) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        work.follow();
    }
}

TEST(BackgroundWork, that_is_done_soon_is_finished_as_if_it_took_no_time) {
    BackgroundWork work([] {}, 60.0, [](const std::string&) {});
    int made = 0;
    work.start("a", [&](const Work&) { return [&] { made = 1; }; });
    EXPECT_EQ(made, 1);
    EXPECT_FALSE(work.busy());
}

TEST(BackgroundWork, that_takes_its_time_goes_on_beside_the_frames_and_wakes_them) {
    std::atomic<bool> may_end = false, woke = false;
    BackgroundWork work([&] { woke = true; }, 0.0, [](const std::string&) {});
    int made = 0;
    work.start("Reading a", [&](const Work& how) {
        how.progress->advance(0.25F);
        while (!may_end) std::this_thread::yield();
        return [&] { made = 1; };
    });
    work.follow();
    ASSERT_TRUE(work.busy());
    EXPECT_EQ(made, 0);
    EXPECT_EQ(work.task().name, "Reading a");
    may_end = true;
    follow_to_end(work);
    EXPECT_EQ(made, 1);
    EXPECT_TRUE(woke);
}

TEST(BackgroundWork, that_is_cancelled_or_overtaken_comes_to_nothing) {
    BackgroundWork work([] {}, 0.0, [](const std::string&) {});
    std::atomic<int> stopped = 0;
    int made = 0;
    const auto endless = [&](const Work&) -> BackgroundWork::Finish {
        try {
            while (true) stop_if_wished();
        } catch (const Stopped&) {
            ++stopped;
            throw;
        }
        return [&] { made = 1; };
    };
    work.start("a", endless);
    work.start("b", endless);
    work.cancel();
    EXPECT_FALSE(work.busy());
    work.start("c", [&](const Work&) { return [&] { made = 3; }; });
    follow_to_end(work);
    EXPECT_EQ(made, 3);
    for (int k = 0; k < 1000 && stopped < 2; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(stopped, 2);
}

TEST(BackgroundWork, that_fails_says_why) {
    std::string said;
    BackgroundWork work([] {}, 60.0, [&](const std::string& fault) { said = fault; });
    work.start("a", [](const Work&) -> BackgroundWork::Finish { throw std::runtime_error("no"); });
    EXPECT_EQ(said, "no");
    EXPECT_NO_THROW(stop_if_wished()) << "outside such work nobody is stopped";
}

Opened<std::vector<Photometry>> read_by_name(const std::filesystem::path& file) {
    Opened<std::vector<Photometry>> opened;
    if (file.stem() == "bad") {
        opened.findings.push_back({Severity::error, {file.string(), 0, {}, 0}, "no"});
        return opened;
    }
    opened.content.emplace(file.stem() == "two" ? 2 : 1);
    for (Photometry& photometry : *opened.content) photometry.name = file.stem().string();
    return opened;
}

TEST(LuminaireFiles, of_a_folder_are_read_by_name_up_to_one_that_holds_several) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "hanei luminaire batch";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    for (const char* const name : {"a.ies", "bad.LDT", "two.gldf", "z.ies", "notes.txt"})
        std::ofstream(folder / name) << 1;
    Progress progress;
    LuminaireBatch batch = read_luminaire_files({folder}, read_by_name, {1, {}, &progress});
    ASSERT_EQ(batch.read.size(), 1U);
    EXPECT_EQ(batch.read[0].name, "a");
    EXPECT_EQ(batch.faults.size(), 1U);
    EXPECT_EQ(batch.several.size(), 2U);
    EXPECT_EQ(batch.file.filename(), "two.gldf");
    EXPECT_EQ(progress.fraction(), 0.5F);
    ASSERT_EQ(batch.left.size(), 1U);
    batch = read_luminaire_files(batch.left, read_by_name, {});
    EXPECT_EQ(batch.read.size(), 1U);
    EXPECT_TRUE(batch.left.empty() && batch.several.empty());
}

}  // namespace
}  // namespace hanei
