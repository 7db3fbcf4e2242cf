/// What studies teach, as a file, and the commands that predict from it.
#include "app/calibration_file.h"
#include "app/exit_code.h"
#include "tests/golden/command_run.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace hanei {
namespace {

const std::string room = HANEI_SOURCE "/assets/rooms/painted-room.hanei";

class CalibrationFile : public CommandRun {
protected:
    CalibrationFile()
        : folder_(std::filesystem::path(testing::TempDir()) /
                  ("hanei-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()))) {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
        ::setenv("XDG_STATE_HOME", folder_.c_str(), 1);
    }
    ~CalibrationFile() override { ::unsetenv("XDG_STATE_HOME"); }

    static std::string content(const std::filesystem::path& file) {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    std::filesystem::path folder_;
};

Calibration two_studies() {
    Calibration calibration;
    calibration.learn({Method::linear, 1234.0, 0xfedcba9876543210ULL, {1.0, 2.5, 3.0, 4.0, 5.0}, std::nullopt});
    calibration.learn({Method::patch, 880.0, 7, {0.5, 0.0, 1e-3, 4.0, 5.0}, 0.0125});
    return calibration;
}

TEST_F(CalibrationFile, comes_back_as_it_was_written) {
    const std::filesystem::path file = folder_ / "deep" / "calibration.json";
    ASSERT_FALSE(write_calibration(two_studies(), file));
    const CalibrationRead read = read_calibration(file);
    EXPECT_TRUE(read.findings.empty());
    EXPECT_EQ(read.calibration, two_studies());
}

TEST_F(CalibrationFile, that_is_missing_is_an_empty_one_without_a_remark) {
    const CalibrationRead read = read_calibration(folder_ / "none.json");
    EXPECT_TRUE(read.findings.empty());
    EXPECT_TRUE(read.calibration.samples().empty());
}

TEST_F(CalibrationFile, of_hostile_content_gives_warnings_and_what_is_good_of_it) {
    const std::string good =
        R"({"method": "patch", "room": "0000000000000007", "unknowns": 10, "ns_a_unit": [1, 2, 3, 4, 5]})";
    const auto with = [&](const std::string& study) {
        return R"({"format": "hanei-calibration", "version": 1, "studies": [)" + good + ", " + study + "]}";
    };
    for (const char* study :
         {R"({"method": "magic", "room": "0000000000000007", "unknowns": 10, "ns_a_unit": [1, 2, 3, 4, 5]})",
          R"({"method": "patch", "room": "xyz", "unknowns": 10, "ns_a_unit": [1, 2, 3, 4, 5]})",
          R"({"method": "patch", "room": "0000000000000007", "unknowns": -3, "ns_a_unit": [1, 2, 3, 4, 5]})",
          R"({"method": "patch", "room": "0000000000000007", "unknowns": 1e300, "ns_a_unit": [1, 2, 3, 4, 5]})",
          R"({"method": "patch", "room": "0000000000000007", "unknowns": 10, "ns_a_unit": [1, 2, 3]})",
          R"({"method": "patch", "room": "0000000000000007", "unknowns": 10, "ns_a_unit": [1, 2, 3, 4, -5]})",
          R"({"method": "patch", "room": "0000000000000007", "unknowns": 10, "ns_a_unit": "fast"})",
          R"({"method": "patch", "room": "0000000000000007", "unknowns": 10, "ns_a_unit": [1, 2, 3, 4, 5],
                 "p95_percent": -1})",
          R"(17)", R"({})", R"([[[[]]]])"}) {
        const CalibrationRead read = calibration_of_text(with(study), "calibration.json");
        EXPECT_EQ(read.calibration.samples().size(), 1U) << study;
        ASSERT_FALSE(read.findings.empty()) << study;
        for (const Diagnostic& finding : read.findings) EXPECT_EQ(finding.severity, Severity::warning) << study;
    }
}

TEST_F(CalibrationFile, that_is_no_calibration_teaches_nothing_and_says_so) {
    for (const char* text : {"", "{", "[]", "null", "\xff\xfe", R"({"format": "hanei-project", "version": 1})",
                             R"({"format": "hanei-calibration", "version": 2, "studies": []})",
                             R"({"format": "hanei-calibration", "version": 1, "studies": 5})"}) {
        const CalibrationRead read = calibration_of_text(text, "calibration.json");
        EXPECT_TRUE(read.calibration.samples().empty()) << text;
        EXPECT_FALSE(read.findings.empty()) << text;
    }
    std::string many = R"({"format": "hanei-calibration", "version": 1, "studies": [1)";
    for (int k = 0; k < 1000; ++k) many += ", 1";
    EXPECT_LE(calibration_of_text(many + "]}", "calibration.json").findings.size(), 5U) << "not a thousand remarks";
}

TEST_F(CalibrationFile, is_written_by_a_study_that_compares_predicted_with_found) {
    const auto out = folder_ / "out";
    ASSERT_EQ(run({"study", room, "--max-patch", "2", "--budget", "8", "--out", out}), exit_done) << err_;
    EXPECT_NE(out_.find("none of this machine yet"), std::string::npos) << out_;
    for (const char* word :
         {"draft", "design", "verify", "Frontier", "Lumen method", "It is uncertain itself by", "s of processor time"})
        EXPECT_NE(out_.find(word), std::string::npos) << word << "\n" << out_;
    EXPECT_NE(content(out / "accuracy-time.csv").find("\nrun,patch,"), std::string::npos);
    EXPECT_NE(content(out / "accuracy-time.csv").find("\nreference,"), std::string::npos);
    EXPECT_NE(content(out / "accuracy-time.svg").find("</svg>"), std::string::npos);
    const Calibration learned = read_calibration(folder_ / "hanei/calibration.json").calibration;
    EXPECT_GT(learned.samples().size(), 3U);

    ASSERT_EQ(run({"solve", room, "--preset", "draft"}), exit_done) << err_;
    EXPECT_NE(err_.find("draft 10 %: --method "), std::string::npos) << err_;
    EXPECT_NE(err_.find("studies of this room on this machine"), std::string::npos) << err_;
}

TEST_F(CalibrationFile, a_wish_in_percent_chooses_the_settings_and_other_options_have_the_last_word) {
    ASSERT_EQ(run({"solve", room, "--within", "20"}), exit_done) << err_;
    EXPECT_NE(err_.find("within 20 %: --method "), std::string::npos) << err_;
    ASSERT_EQ(run({"solve", room, "--within", "20", "--method", "paper", "--max-patch", "1.5"}), exit_done) << err_;
    EXPECT_NE(err_.find("--method paper --max-patch 1.5"), std::string::npos) << err_;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "hanei/calibration.json")) << "only studies are learned from";
}

TEST_F(CalibrationFile, a_preset_that_is_none_and_a_budget_of_nothing_are_bad_input) {
    EXPECT_EQ(run({"solve", room, "--preset", "best"}), exit_bad_input);
    EXPECT_EQ(run({"solve", room, "--within", "0"}), exit_bad_input);
    EXPECT_EQ(run({"solve", room, "--preset", "draft", "--within", "3"}), exit_bad_input);
    EXPECT_EQ(run({"study", room, "--budget", "0", "--out", folder_ / "out"}), exit_bad_input);
}

}  // namespace
}  // namespace hanei
