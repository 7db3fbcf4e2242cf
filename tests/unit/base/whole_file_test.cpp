#include "engine/base/whole_file.h"

#include <csignal>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <sys/fsuid.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace hanei {
namespace {

std::filesystem::path fresh_folder(const char* name) {
    const auto folder = std::filesystem::path(testing::TempDir()) / name;
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

std::string content(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(WholeFile, a_file_is_replaced_and_nothing_is_left_beside_it) {
    const auto folder = fresh_folder("hanei-whole-file");
    EXPECT_FALSE(write_whole_file(folder / "a.txt", "first"));
    EXPECT_FALSE(write_whole_file(folder / "a.txt", "second"));
    EXPECT_EQ(content(folder / "a.txt"), "second");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

TEST(WholeFile, a_missing_folder_is_refused_with_a_sentence) {
    const auto reason = write_whole_file(fresh_folder("hanei-no-folder") / "none" / "a.txt", "text");
    ASSERT_TRUE(reason);
    EXPECT_NE(reason->find("folder"), std::string::npos);
}

TEST(WholeFile, a_folder_is_never_written_over) {
    const auto folder = fresh_folder("hanei-folder");
    EXPECT_TRUE(write_whole_file(folder, "text"));
    EXPECT_TRUE(std::filesystem::is_directory(folder));
}

TEST(WholeFile, a_replaced_file_keeps_its_permissions) {
    const auto folder = fresh_folder("hanei-permissions");
    std::ofstream(folder / "a.txt") << "first";
    ASSERT_EQ(::chmod((folder / "a.txt").c_str(), 0640), 0);
    EXPECT_FALSE(write_whole_file(folder / "a.txt", "second"));
    struct stat after {};
    ASSERT_EQ(::stat((folder / "a.txt").c_str(), &after), 0);
    EXPECT_EQ(after.st_mode & 07777U, 0640U);
}

TEST(WholeFile, a_symbolic_link_stays_one_and_its_end_is_written) {
    const auto folder = fresh_folder("hanei-links");
    std::filesystem::create_directories(folder / "far");
    std::filesystem::create_symlink("far/b.txt", folder / "a.txt");
    for (const char* const text : {"first", "second"}) {  // the end is not there at first
        EXPECT_FALSE(write_whole_file(folder / "a.txt", text));
        EXPECT_TRUE(std::filesystem::is_symlink(folder / "a.txt"));
        EXPECT_EQ(content(folder / "far/b.txt"), text);
    }
}

TEST(WholeFile, what_was_there_stays_when_the_disk_takes_no_more) {
    const auto folder = fresh_folder("hanei-full");
    ASSERT_FALSE(write_whole_file(folder / "a.txt", "first"));
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit tight{4096, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
    const auto reason = write_whole_file(folder / "a.txt", std::string(20'000, 'x'));
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    ASSERT_TRUE(reason);
    EXPECT_NE(reason->find("save to another place"), std::string::npos) << *reason;
    EXPECT_EQ(content(folder / "a.txt"), "first");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

/// As the user "nobody" for files, when the test runs as root, whom no permission stops.
TEST(WholeFile, what_was_there_stays_in_a_folder_that_may_not_be_written) {
    const auto folder = fresh_folder("hanei-unwritable");
    ASSERT_FALSE(write_whole_file(folder / "a.txt", "first"));
    ASSERT_EQ(::chmod(folder.c_str(), 0555), 0);
    const bool is_root = ::geteuid() == 0;
    if (is_root) ::setfsuid(65534);
    const auto reason = write_whole_file(folder / "a.txt", "second");
    if (is_root) ::setfsuid(0);
    ::chmod(folder.c_str(), 0755);
    ASSERT_TRUE(reason);
    EXPECT_EQ(*reason, "you may not write in this folder; save to another place");
    EXPECT_EQ(content(folder / "a.txt"), "first");
}

}  // namespace
}  // namespace hanei
