#include "../small_disk.h"
#include "app/files.h"
#include "app/preferences_file.h"
#include "app/recovery_folder.h"
#include "engine/base/whole_file.h"
#include "engine/edit/edit.h"
#include "engine/project/gltf_export.h"
#include "engine/project/project_file.h"
#include "ui/view/image.h"

#include <cstdlib>
#include <functional>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <stdexcept>
#include <sys/wait.h>

namespace hanei {
namespace {

namespace fs = std::filesystem;

std::string reason_of(const std::optional<Diagnostic>& fault) { return fault ? to_text(*fault) : std::string(); }

std::string reason_thrown(const std::function<void()>& write) {
    try {
        write();
    } catch (const std::runtime_error& fault) {
        return fault.what();
    }
    return {};
}

Scene small_room() { return with_panel_luminaire(empty_room()).scene; }

Image grey_picture() {
    Image image{64, 64, std::vector<std::uint8_t>(std::size_t{64} * 64 * 4)};
    unsigned bits = 1;
    for (std::uint8_t& byte : image.rgba)
        byte = static_cast<std::uint8_t>((bits = bits * 1664525U + 1013904223U) >> 24U);
    return image;  // noise, so that it packs badly
}

/// Every way in which the program puts a file on a disk: what it wrote wrong, or nothing.
struct Writer {
    const char* name;
    std::string (*write)(const fs::path&);
};
constexpr Writer writers[] = {
    {"project",
     [](const fs::path& file) {
         return reason_of(write_project({small_room(), {}}, file));
     }},
    {"preferences", [](const fs::path& file) { return reason_of(write_preferences({}, file)); }},
    {"glTF",
     [](const fs::path& file) {
         return reason_of(write_gltf({small_room(), {}}, nullptr, file));
     }},
    {"table", [](const fs::path& file) { return reason_thrown([&] { write_text(file, std::string(9000, '1')); }); }},
    {"picture", [](const fs::path& file) { return reason_thrown([&] { write_png(grey_picture(), file); }); }},
    {"state", [](const fs::path& file) { return write_passing_file(file, std::string(9000, '1')).value_or(""); }},
};

std::map<std::string, std::string> files_in(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().filename() == "ballast") continue;
        if (entry.is_directory()) continue;
        std::ifstream in(entry.path(), std::ios::binary);
        files[entry.path().filename()] = {std::istreambuf_iterator<char>(in), {}};
    }
    return files;
}

class ADiskThatRefuses : public testing::TestWithParam<Writer> {
protected:
    ADiskThatRefuses() { fs::create_directories(folder); }
    ~ADiskThatRefuses() override { fs::remove_all(folder); }
    static std::string own_name() {
        std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        for (char& letter : name)
            if (letter == '/') letter = '-';
        return name;
    }
    const fs::path folder = fs::path(testing::TempDir()) / "hanei refusing" / (own_name() + std::to_string(::getpid()));
    const fs::path file = folder / "there";
};

TEST_P(ADiskThatRefuses, for_it_is_full_at_whatever_page_leaves_what_was_there) {
    const SmallDisk probe(folder / "probe", 1);
    if (!probe.is_there()) GTEST_SKIP() << "no disk can be mounted here: only limits of a file's size are tried";
    const fs::path disk_folder = folder / "disk";
    SmallDisk disk(disk_folder, 64);
    ASSERT_TRUE(disk.is_there());
    ASSERT_EQ(GetParam().write(disk_folder / "there"), "");
    const auto whole = files_in(disk_folder);
    const std::size_t pages = (whole.at("there").size() + SmallDisk::page - 1) / SmallDisk::page;
    ASSERT_FALSE(write_whole_file(disk_folder / "there", "former"));
    const auto former = files_in(disk_folder);
    for (std::size_t free = 0; free < pages; ++free) {
        disk.leave(free);
        EXPECT_NE(GetParam().write(disk_folder / "there").find("the disk is full"), std::string::npos) << free;
        EXPECT_EQ(files_in(disk_folder), former) << free;
    }
    disk.leave(pages);
    EXPECT_EQ(GetParam().write(disk_folder / "there"), "");
    EXPECT_EQ(files_in(disk_folder), whole);
}

TEST_P(ADiskThatRefuses, after_any_byte_leaves_what_was_there) {
    ASSERT_EQ(GetParam().write(file), "");
    const auto whole = files_in(folder);
    const std::size_t size = whole.at("there").size();
    ASSERT_FALSE(write_whole_file(file, "former"));
    const auto former = files_in(folder);
    const std::size_t step = size > 4000 ? 97 : 1;
    for (std::size_t bytes = 0; bytes < size; bytes += step) {
        std::string reason;
        {
            const FilesAtMost limit(bytes);
            reason = GetParam().write(file);
        }
        ASSERT_NE(reason.find("may not become so large"), std::string::npos) << bytes << ' ' << reason;
        ASSERT_EQ(files_in(folder), former) << bytes;
    }
    const FilesAtMost limit(size);
    EXPECT_EQ(GetParam().write(file), "");
    EXPECT_EQ(files_in(folder), whole);
}

TEST_P(ADiskThatRefuses, for_the_folder_may_only_be_read_leaves_what_was_there) {
    ASSERT_FALSE(write_whole_file(file, "former"));
    const auto former = files_in(folder);
    std::string reason;
    {
        const ReadOnlyFolder closed(folder);
        reason = GetParam().write(file);
    }
    EXPECT_NE(reason.find("you may not write in this folder"), std::string::npos) << reason;
    EXPECT_EQ(files_in(folder), former);
}

TEST_P(ADiskThatRefuses, for_the_name_is_a_folder_s_or_its_folder_has_gone_says_so) {
    fs::create_directories(file);
    EXPECT_NE(GetParam().write(file).find("this is no plain file"), std::string::npos);
    EXPECT_TRUE(fs::is_directory(file));
    if (GetParam().name == std::string("preferences")) return;  // makes its folder itself
    EXPECT_NE(GetParam().write(folder / "gone" / "x").find("there is no such folder"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder / "gone"));
}

TEST_P(ADiskThatRefuses, is_not_needed_for_a_link_to_stay_one_while_its_end_is_replaced) {
    fs::create_directories(folder / "far");
    std::ofstream(folder / "far/end") << "former";
    fs::create_symlink("far/end", file);
    ASSERT_EQ(GetParam().write(file), "");
    EXPECT_TRUE(fs::is_symlink(file));
    EXPECT_GT(fs::file_size(folder / "far/end"), 6U);
}

INSTANTIATE_TEST_SUITE_P(Of, ADiskThatRefuses, testing::ValuesIn(writers),
                         [](const auto& each) { return std::string(each.param.name); });

class AFullDisk : public testing::Test {
protected:
    ~AFullDisk() override { fs::remove_all(folder); }
    const fs::path folder = fs::path(testing::TempDir()) / ("hanei full disk " + std::to_string(::getpid()));
};

TEST_F(AFullDisk, keeps_the_unsaved_work_it_held_before) {
    SmallDisk disk(folder, 64);
    if (!disk.is_there()) GTEST_SKIP() << "no disk can be mounted here";
    RecoveryFolder recovery(folder / "recovery");
    ASSERT_FALSE(recovery.keep(small_room(), {}, {}));
    const auto former = files_in(folder / "recovery");
    disk.leave(0);
    EXPECT_NE(reason_of(recovery.keep(empty_room(), {}, {})).find("the disk is full"), std::string::npos);
    EXPECT_EQ(files_in(folder / "recovery"), former);
}

/// The program itself, its output on the full disk; returns its exit code.
int run_on(const fs::path& folder, const std::string& command) {
    const std::string line = "cd '" + folder.string() + "' && " HANEI_PROGRAM " " + command + " 2>said";
    const int status = std::system(line.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(AFullDisk, makes_every_command_end_with_a_sentence_and_leave_nothing_torn) {
    SmallDisk disk(folder / "disk", 256);
    if (!disk.is_there()) GTEST_SKIP() << "no disk can be mounted here";
    Settings coarse;
    coarse.max_patch = 2.0;
    ASSERT_FALSE(write_project({small_room(), coarse}, folder / "room.hanei"));
    disk.leave(0);
    const auto before = files_in(folder / "disk");
    const std::string commands[] = {
        "solve room.hanei --csv disk/out.csv >printed",   "solve room.hanei --json disk/out.json >printed",
        "render room.hanei --out disk/out.png >printed",  "export room.hanei --out disk/out.glb >printed",
        "plan room.hanei --json disk/plan.json >printed", "new --room 5x4x3 disk/new.hanei >printed",
    };
    for (const std::string& command : commands) {
        EXPECT_EQ(run_on(folder, command), 3) << command;
        const std::string said = files_in(folder).at("said");
        EXPECT_NE(said.find("the disk is full"), std::string::npos) << command << ": " << said;
        EXPECT_NE(said.find("disk/"), std::string::npos) << command << ": " << said;
        EXPECT_EQ(files_in(folder / "disk"), before) << command;
    }
}

TEST_F(AFullDisk, behind_standard_output_is_no_success) {
    fs::create_directories(folder);
    ASSERT_FALSE(write_project({small_room(), {}}, folder / "room.hanei"));
    EXPECT_EQ(run_on(folder, "plan room.hanei >/dev/full"), 3);
    EXPECT_NE(files_in(folder).at("said").find("standard output"), std::string::npos);
}

}  // namespace
}  // namespace hanei
