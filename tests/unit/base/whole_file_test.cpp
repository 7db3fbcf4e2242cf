#include "engine/base/whole_file.h"

#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

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

}  // namespace
}  // namespace hanei
