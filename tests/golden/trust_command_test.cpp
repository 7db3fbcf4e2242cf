/// The command that checks an answer by what must hold of any.
#include "app/exit_code.h"
#include "tests/golden/command_run.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace hanei {
namespace {

const std::string rooms = HANEI_SOURCE "/assets/rooms/";

class TrustCommand : public CommandRun {
protected:
    int run(const std::vector<std::string>& after_command) {
        std::vector<std::string> arguments{"trust"};
        arguments.insert(arguments.end(), after_command.begin(), after_command.end());
        return CommandRun::run(arguments);
    }
    bool says(const std::string& words) const { return out_.find(words) != std::string::npos; }
};

TEST_F(TrustCommand, holds_of_the_painted_room_and_is_written_as_json) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "hanei-trust-command";
    std::filesystem::create_directories(folder);
    const auto file = folder / "trust.json";
    ASSERT_EQ(run({rooms + "painted-room.hanei", "--json", file}), exit_done) << out_ << err_;
    EXPECT_TRUE(says("6000 lm emitted"));
    EXPECT_TRUE(says("All 5 checks hold."));  // one luminaire makes no halves
    std::ifstream in(file);
    const auto json = nlohmann::json::parse(in);
    EXPECT_TRUE(json["holds"].get<bool>());
    EXPECT_EQ(json["checks"]["additivity"]["state"], "does not apply");
    EXPECT_LT(json["checks"]["energy"]["found"].get<double>(), 6.0) << "a thousandth of what is emitted";
}

TEST_F(TrustCommand, accounts_for_the_light_that_four_bounces_leave_on_its_way) {
    ASSERT_EQ(run({rooms + "hard/plain-room.hanei", "--bounces", "4"}), exit_done) << out_ << err_;
    EXPECT_TRUE(says("stopped after 4, as set"));
}

TEST_F(TrustCommand, says_no_and_names_the_lamp_whose_light_goes_nowhere) {
    EXPECT_EQ(run({rooms + "hard/above-the-ceiling.hanei"}), exit_answer_is_no);
    EXPECT_TRUE(says("Panel sends 3000 of its 3000 lm"));
}

TEST_F(TrustCommand, says_no_of_point_to_point_factors) {
    EXPECT_EQ(run({rooms + "hard/slit.hanei", "--method", "paper", "--bounces", "4"}), exit_answer_is_no);
    EXPECT_TRUE(says("Use"));
}

TEST_F(TrustCommand, refuses_a_file_that_is_not_there) {
    EXPECT_EQ(run({rooms + "nowhere.hanei"}), exit_bad_input);
    EXPECT_FALSE(err_.empty());
}

}  // namespace
}  // namespace hanei
