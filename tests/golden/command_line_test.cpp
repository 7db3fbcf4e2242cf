/// The command line's door: what it answers, and its exit codes.

#include "app/exit_code.h"
#include "tests/golden/command_run.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <vector>

namespace hanei {
namespace {

const std::string rooms = HANEI_SOURCE "/assets/rooms/";

class CommandLine : public CommandRun {
protected:
    CommandLine() { ::setenv("SOURCE_DATE_EPOCH", "1700000000", 1); }  // the same pictures at any time
    static std::filesystem::path scratch(const std::string& name) {
        const auto folder = std::filesystem::path(testing::TempDir()) /
                            ("hanei-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::create_directories(folder);
        return folder / name;
    }
    static std::string content(const std::filesystem::path& file) {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
};

TEST_F(CommandLine, every_command_has_help) {
    for (const char* command : {"solve", "render", "describe", "plan", "study", "check", "validate", "photometry"}) {
        EXPECT_EQ(run({command, "--help"}), exit_done);
        EXPECT_NE(out_.find("Usage"), std::string::npos) << command;
    }
    EXPECT_EQ(run({"--help"}), exit_done);
}

TEST_F(CommandLine, solve_prints_the_lux_table_and_writes_csv_and_json) {
    const auto csv = scratch("values.csv"), json = scratch("values.json");
    ASSERT_EQ(run({"solve", rooms + "computer-room-panels.hanei", "--max-patch", "1", "--csv", csv, "--json", json}),
              exit_done)
        << err_;
    EXPECT_NE(out_.find("mean lx"), std::string::npos);
    EXPECT_EQ(content(csv).rfind("kind,name,x_m", 0), 0u);
    EXPECT_NE(content(json).find("\"total_lx\""), std::string::npos);
}

TEST_F(CommandLine, solve_gives_the_same_values_on_one_thread_and_on_three) {
    const auto one = scratch("one.csv"), three = scratch("three.csv");
    ASSERT_EQ(run({"solve", rooms + "computer-room-panels.hanei", "--max-patch", "1", "--threads", "1", "--csv", one}),
              exit_done);
    ASSERT_EQ(
        run({"solve", rooms + "computer-room-panels.hanei", "--max-patch", "1", "--threads", "3", "--csv", three}),
        exit_done);
    EXPECT_EQ(content(one), content(three));
}

TEST_F(CommandLine, a_missing_project_is_bad_input_with_the_file_named) {
    EXPECT_EQ(run({"solve", "nowhere.hanei"}), exit_bad_input);
    EXPECT_NE(err_.find("nowhere.hanei"), std::string::npos) << err_;
}

TEST_F(CommandLine, an_option_out_of_range_is_bad_input) {
    EXPECT_EQ(run({"solve", rooms + "computer-room-panels.hanei", "--max-patch", "-1"}), exit_bad_input);
    EXPECT_EQ(run({"solve", rooms + "computer-room-panels.hanei", "--method", "magic"}), exit_bad_input);
    EXPECT_EQ(run({"render", rooms + "computer-room-panels.hanei", "--out", "x.png", "--size", "0x7"}), exit_bad_input);
}

TEST_F(CommandLine, an_unknown_view_is_named_with_the_views_there_are) {
    EXPECT_EQ(run({"render", rooms + "computer-room-panels.hanei", "--out", scratch("x.png"), "--view", "attic"}),
              exit_bad_input);
    EXPECT_NE(err_.find("attic"), std::string::npos);
    EXPECT_NE(err_.find("overview"), std::string::npos);
}

TEST_F(CommandLine, render_draws_the_same_picture_twice) {
    const auto first = scratch("first.png"), second = scratch("second.png");
    for (const auto& file : {first, second})
        ASSERT_EQ(run({"render", rooms + "computer-room-panels.hanei", "--max-patch", "1", "--size", "480x300", "--out",
                       file}),
                  exit_done)
            << err_;
    EXPECT_GT(content(first).size(), 10'000u);
    EXPECT_EQ(content(first), content(second));
}

TEST_F(CommandLine, plan_says_why_for_every_effect) {
    ASSERT_EQ(run({"plan", rooms + "computer-room-panels.hanei"}), exit_done) << err_;
    for (const char* word : {"interreflection", "penumbra", "bounces", "simulated"})
        EXPECT_NE(out_.find(word), std::string::npos) << word;
}

TEST_F(CommandLine, plan_measures_what_effects_really_add_and_take) {
    const auto json = scratch("plan.json");
    ASSERT_EQ(run({"plan", rooms + "painted-room.hanei", "--max-patch", "1.5", "--measure", "--json", json}), exit_done)
        << err_;
    for (const char* word :
         {"ms with everything", "51 calculation points", "\nshadows between surfaces ", "\ncolour bands "})
        EXPECT_NE(out_.find(word), std::string::npos) << word;
    EXPECT_NE(content(json).find("\"change_lx\""), std::string::npos);
}

TEST_F(CommandLine, photometry_prints_a_section_for_each_luminaire_of_a_container) {
    const std::string luminaires = HANEI_SOURCE "/tests/golden/luminaires/";
    const auto json = scratch("two.json");
    ASSERT_EQ(run({"photometry", luminaires + "containers/two_emitters_bom.gldf", "--json", json}), exit_done) << err_;
    EXPECT_EQ(out_.rfind("V / e1\n", 0), 0U);
    EXPECT_NE(out_.find("\n\nV / e2, emergency only\n"), std::string::npos);
    EXPECT_NE(content(json).find("\"luminaires\""), std::string::npos);
    EXPECT_EQ(run({"photometry", luminaires + "malformed/gldf_08_dangling_reference.gldf"}), exit_bad_input);
    EXPECT_NE(err_.find("PhotometryReference"), std::string::npos);
}

TEST_F(CommandLine, photometry_is_of_the_lamp_set_that_is_asked_for) {
    const std::string file = HANEI_SOURCE "/tests/golden/luminaires/synthetic/none_isym0_two_sets.ldt";
    ASSERT_EQ(run({"photometry", file}), exit_done);
    EXPECT_NE(out_.find("lamp set 1, used"), std::string::npos);
    const std::string first = out_;
    ASSERT_EQ(run({"photometry", file, "--lamp-set", "2"}), exit_done);
    EXPECT_NE(out_.find("lamp set 2, used"), std::string::npos);
    EXPECT_NE(out_.substr(out_.find("flux computed"), 40), first.substr(first.find("flux computed"), 40));
    EXPECT_EQ(run({"photometry", file, "--lamp-set", "3"}), exit_bad_input);
    EXPECT_NE(err_.find("lamp set 3 is asked for"), std::string::npos);
}

TEST_F(CommandLine, check_tells_what_is_to_be_said_of_the_photometries) {
    const auto project = scratch("scaled.hanei");
    std::ofstream(project) << R"({"format": "hanei-project", "version": 1, "photometries": [{"name": "lamp",
        "type": "C", "symmetry": "rotational", "opening": {"shape": "point"}, "horizontal_deg": [0],
        "vertical_deg": [0, 180], "candela": [[100, 100]], "keywords": [["LuminousFlux", "1000"]],
        "warnings": ["planes 0 and 360 differ"]}]})";
    EXPECT_EQ(run({"check", project}), exit_answer_is_no);
    EXPECT_NE(err_.find("photometries[0]: warning: lamp: planes 0 and 360 differ"), std::string::npos) << err_;
    EXPECT_NE(err_.find("declares 1000 lm; its intensities integrate to 1257 lm"), std::string::npos) << err_;
}

TEST_F(CommandLine, render_names_pictures_by_a_template_and_describe_reads_what_they_say) {
    const auto folder = scratch("named");
    std::filesystem::create_directories(folder);
    const auto render = [&](const std::string& name) {
        return run({"render", rooms + "painted-room.hanei", "--view", "plan", "--part", "direct", "--size", "320x240",
                    "--max-patch", "2", "--out", folder, "--name-template", name});
    };
    ASSERT_EQ(render("{project} {view} {part} {size}"), exit_done) << err_;
    ASSERT_EQ(run({"describe", folder / "painted-room plan direct 320x240.png"}), exit_done) << err_;
    EXPECT_EQ(out_.rfind("Title: A room with one red wall", 0), 0U) << out_;
    EXPECT_NE(out_.find("Description: Illuminance in lx"), std::string::npos);
    EXPECT_NE(out_.find("Creation Time: 2023-11-14T22:13:20Z"), std::string::npos);
    EXPECT_EQ(render("{colour}"), exit_bad_input);
    EXPECT_NE(err_.find("{colour} means nothing"), std::string::npos);
    EXPECT_EQ(run({"describe", rooms + "painted-room.hanei"}), exit_bad_input);
}

TEST_F(CommandLine, every_start_room_passes_its_check) {
    for (const auto& entry : std::filesystem::directory_iterator(rooms)) {
        if (entry.path().extension() != ".hanei") continue;
        EXPECT_EQ(run({"check", entry.path()}), exit_done) << err_;
    }
}

TEST_F(CommandLine, check_ends_with_how_many_findings_of_each_kind_there_are) {
    EXPECT_EQ(run({"check", rooms + "hard/shadow-edge.hanei"}), exit_done);
    EXPECT_NE(out_.find("shadow-edge.hanei: no errors; 1 note\n"), std::string::npos) << out_;
    EXPECT_EQ(run({"check", rooms + "hard/lamp-in-a-box.hanei"}), exit_answer_is_no);
    EXPECT_NE(out_.find("lamp-in-a-box.hanei: no errors, 1 warning\n"), std::string::npos) << out_;
    EXPECT_EQ(run({"check", rooms + "painted-room.hanei"}), exit_done);
    EXPECT_NE(out_.find("painted-room.hanei: nothing to complain about\n"), std::string::npos) << out_;
}

TEST_F(CommandLine, the_reference_cases_kept_with_the_project_pass) {
    EXPECT_EQ(run({"validate", HANEI_SOURCE "/assets/reference"}), exit_done) << out_ << err_;
    EXPECT_NE(out_.find("b. measured photometry"), std::string::npos);
}

TEST_F(CommandLine, validate_without_a_path_signs_the_table_of_its_own_cases) {
    const auto json = scratch("points.json"), csv = scratch("table.csv");
    EXPECT_EQ(run({"validate", "--threads", "2", "--json", json, "--csv", csv}), exit_done) << out_ << err_;
    for (const char* expected :
         {"expected by", "Penumbra of a box", "CIE 171, 5.8", "own reference", "Furnished computer room",
          "Hanei " HANEI_VERSION ", 2023-11-14, method linear, 2 threads: all 48 cases hold (564 points"})
        EXPECT_NE(out_.find(expected), std::string::npos) << expected << '\n' << out_;
    EXPECT_NE(content(json).find("\"allowed_pass\""), std::string::npos);
    const std::string table = content(csv);
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 49) << table;
}

TEST_F(CommandLine, validate_without_a_path_says_no_when_the_method_is_too_coarse) {
    EXPECT_EQ(run({"validate", "--method", "paper", "--max-patch", "1"}), exit_answer_is_no) << out_ << err_;
    EXPECT_NE(out_.find("method paper"), std::string::npos) << out_;
    EXPECT_NE(out_.find(" of 48 cases fail"), std::string::npos) << out_;
    EXPECT_NE(out_.find("    worst: "), std::string::npos) << out_;
}

TEST_F(CommandLine, validate_says_no_when_a_case_fails) {
    const std::string good = content(HANEI_SOURCE "/assets/reference/P-A1.json");
    const auto bad = scratch("wrong.json");
    std::string text = good;
    const std::string key = "\"expected_lx\":";
    const auto at = text.find(key);
    ASSERT_NE(at, std::string::npos);
    text.insert(at + key.size() + 1, 1, '1');  // behind the blank: ten times and more
    std::ofstream(bad) << text;
    EXPECT_EQ(run({"validate", bad}), exit_answer_is_no) << out_ << err_;
}

TEST_F(CommandLine, validate_of_an_empty_folder_is_bad_input) {
    const auto folder = scratch("empty");
    std::filesystem::create_directories(folder);
    EXPECT_EQ(run({"validate", folder}), exit_bad_input);
}

TEST_F(CommandLine, solve_compares_with_values_of_others_in_any_usual_table) {
    const auto values = scratch("values.csv"), theirs = scratch("theirs.csv"), pairs = scratch("pairs.csv"),
               json = scratch("compared.json");
    const std::string room = rooms + "computer-room-panels.hanei";
    ASSERT_EQ(run({"solve", room, "--max-patch", "1", "--csv", values}), exit_done) << err_;
    EXPECT_EQ(run({"solve", room, "--max-patch", "1", "--compare", values}), exit_done) << err_;
    EXPECT_NE(out_.find("0.00 / 0.00 / 0.00"), std::string::npos) << "our own values, again: " << out_;
    std::ofstream(theirs) << "Some program\r\n\r\nX [mm];Y [mm];Z [mm];E [lx];Uncertainty [%]\r\n"
                             "1500,5;1000;750;500,5;4\r\n1500;1500;750;/;\r\n";
    ASSERT_EQ(run({"solve", room, "--max-patch", "1", "--compare", theirs, "--differences", pairs, "--json", json}),
              exit_done)
        << err_;
    EXPECT_NE(out_.find("1 rows have no value"), std::string::npos) << out_;
    EXPECT_EQ(content(pairs).rfind("line,set,index,x_m", 0), 0U);
    EXPECT_NE(content(json).find("\"within_our_error_bar\""), std::string::npos);
}

TEST_F(CommandLine, a_table_that_cannot_be_compared_is_bad_input_with_its_line) {
    const auto theirs = scratch("theirs.csv");
    const std::string room = rooms + "computer-room-panels.hanei";
    std::ofstream(theirs) << "set,index,lux\nNowhere,1,abc\n";
    EXPECT_EQ(run({"solve", room, "--compare", theirs}), exit_bad_input);
    EXPECT_NE(err_.find("theirs.csv:2: lux: \"abc\" is no number"), std::string::npos) << err_;
    std::ofstream(theirs) << "set,index,lux\nNowhere,1,5\n";
    EXPECT_EQ(run({"solve", room, "--max-patch", "2", "--compare", theirs}), exit_bad_input);
    EXPECT_NE(err_.find("theirs.csv:2: set: no calculation grid \"Nowhere\""), std::string::npos) << err_;
    EXPECT_EQ(run({"solve", room, "--compare", "nowhere.csv"}), exit_bad_input);
}

/// More cases than travel with the project, where they lie.
TEST_F(CommandLine, direct_light_and_furnaces_of_the_shared_reference_pass) {
    const std::filesystem::path folder = HANEI_SHARED "/reference";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "skipped: no test data at " << folder;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        const bool wanted = name.rfind("P-", 0) == 0 && (std::string("ABCDEF").find(name[2]) != std::string::npos ||
                                                         name.rfind("P-G1", 0) == 0 || name.rfind("P-G2", 0) == 0);
        if (!wanted || name.rfind("P-G10", 0) == 0) continue;
        EXPECT_EQ(run({"validate", entry.path()}), exit_done) << out_ << err_;
    }
}

}  // namespace
}  // namespace hanei
