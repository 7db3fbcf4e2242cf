// The one door for luminaire files: the format is recognised by what stands in the file.

#include "engine/project/luminaires.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string_view>

namespace hanei {
namespace {

constexpr std::string_view bare_lamp = "TILT=NONE\n1 1000 1 2 1 1 2 0 0 0 1 1 10\n0 90\n0\n100 100\n";

TEST(LuminairesOfAFile, an_lm63_file_holds_one) {
    const LuminairesRead read = read_luminaires(bare_lamp, "lamp.ies");
    ASSERT_EQ(read.luminaires.size(), 1U);
    EXPECT_EQ(read.luminaires.front().photometry.candela.size(), 2U);
}

TEST(LuminairesOfAFile, are_recognised_by_content_whatever_the_name_says) {
    EXPECT_EQ(read_luminaires(bare_lamp, "lamp.txt").luminaires.size(), 1U);
}

TEST(LuminairesOfAFile, that_is_missing_are_none_and_say_why) {
    const LuminairesRead read = read_luminaires(std::filesystem::path{"no such folder/lamp.ies"});
    EXPECT_TRUE(read.luminaires.empty());
    EXPECT_TRUE(has_errors(read.findings));
}

TEST(LuminairesOfAFile, named_as_a_container_that_is_none_are_refused_as_one) {
    const LuminairesRead read = read_luminaires("hello", "lamp.gldf");
    ASSERT_TRUE(has_errors(read.findings));
    EXPECT_EQ(read.findings.front().place.field, "zip");
}

}  // namespace
}  // namespace hanei
