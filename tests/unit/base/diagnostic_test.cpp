#include "engine/base/diagnostic.h"

#include "engine/base/check.h"
#include "engine/base/quantity.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

TEST(Diagnostic, a_message_says_where_and_what) {
    EXPECT_EQ(to_text({Severity::error, {"office.ies", 14, "vertical angles", 0}, "73 announced, 71 found"}),
              "office.ies:14: vertical angles: 73 announced, 71 found");
    EXPECT_EQ(to_text({Severity::warning, {"office.ies", 0, "", 0}, "no lamp flux"}),
              "office.ies: warning: no lamp flux");
    EXPECT_EQ(to_text({Severity::error, {}, "no room"}), "no room");
}

TEST(Diagnostic, warnings_are_no_errors) {
    EXPECT_FALSE(has_errors({}));
    EXPECT_FALSE(has_errors({{Severity::warning, {}, "odd"}, {Severity::note, {}, "so"}}));
    EXPECT_TRUE(has_errors({{Severity::warning, {}, "odd"}, {Severity::error, {}, "wrong"}}));
}

TEST(Quantity, light_that_arrives_is_reflected_in_part) {
    EXPECT_EQ(reflected(Illuminance{200}, 0.5).value, 100);
    EXPECT_EQ((Illuminance{1} + Illuminance{2}) / Illuminance{3}, 1.0);
    EXPECT_LT(Illuminance{1}, 2 * Illuminance{1});
}

TEST(Check, our_own_mistake_stops_the_program) {
    HANEI_CHECK(1 + 1 == 2);
    EXPECT_DEATH(HANEI_CHECK(1 + 1 == 3), "1 \\+ 1 == 3");
}

}  // namespace
}  // namespace hanei
