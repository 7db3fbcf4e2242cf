#include "engine/base/expression.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace hanei {
namespace {

constexpr std::array metres{UnitWord{"m", 1.0},     UnitWord{"cm", 0.01},  UnitWord{"mm", 0.001},
                            UnitWord{"ft", 0.3048}, UnitWord{"'", 0.3048}, UnitWord{"in", 0.0254},
                            UnitWord{"\"", 0.0254}};

double metres_of(std::string_view text, double bare = 1.0) {
    const Calculated result = calculated(text, metres, bare);
    EXPECT_TRUE(result.value) << text << ": " << result.fault;
    return result.value.value_or(NAN);
}
std::string fault_of(std::string_view text) {
    const Calculated result = calculated(text, metres, 1.0);
    EXPECT_FALSE(result.value) << text;
    return result.fault;
}

constexpr double rounding = 1e-12;  // of a few operations on figures of a room

TEST(AFigure, is_calculated_as_it_is_written) {
    EXPECT_EQ(metres_of("1.25"), 1.25);
    EXPECT_EQ(metres_of("1/3"), 1.0 / 3.0);
    EXPECT_NEAR(metres_of("2*0.6+0.05"), 1.25, rounding);
    EXPECT_NEAR(metres_of("2*(0.6+0.05)"), 1.3, rounding);
    EXPECT_NEAR(metres_of(" - ( 1 - 3 ) / -4 "), -0.5, rounding);
    EXPECT_EQ(metres_of("10-2-3"), 5.0);
    EXPECT_EQ(metres_of("8/2/2"), 2.0);
    EXPECT_EQ(metres_of("1e3"), 1000.0);
    EXPECT_EQ(metres_of("3 1/2"), 3.5);
    EXPECT_EQ(metres_of("--2"), 2.0);
}

TEST(AFigure, may_have_a_unit) {
    EXPECT_NEAR(metres_of("60 cm"), 0.6, rounding);
    EXPECT_NEAR(metres_of("1200mm + 1 m"), 2.2, rounding);
    EXPECT_NEAR(metres_of("2*60cm"), 1.2, rounding);
    EXPECT_NEAR(metres_of("(1+2) ft"), 0.9144, rounding);
    EXPECT_NEAR(metres_of("6 m / 3"), 2.0, rounding);
    EXPECT_NEAR(metres_of("1 m / 50 cm"), 2.0, rounding) << "a ratio counts as a bare figure";
    EXPECT_NEAR(metres_of("12 in"), 0.3048, rounding);
}

TEST(AFigure, without_a_unit_counts_in_the_unit_that_is_shown) {
    EXPECT_NEAR(metres_of("1200", 0.001), 1.2, rounding);
    EXPECT_NEAR(metres_of("2*600", 0.001), 1.2, rounding) << "once, not for every figure";
    EXPECT_NEAR(metres_of("1 m + 5", 0.01), 1.05, rounding);
}

TEST(AFigure, in_feet_and_inches_is_read_as_builders_write_it) {
    const double expected = 5 * 0.3048 + 3.5 * 0.0254;
    for (const char* text : {"5'3 1/2\"", "5' 3 1/2\"", "5'-3 1/2\"", "5'-3.5\"", "5 ft 3.5 in", "5ft 3 1/2in"})
        EXPECT_NEAR(metres_of(text), expected, rounding) << text;
    EXPECT_NEAR(metres_of("5'"), 1.524, rounding);
    EXPECT_NEAR(metres_of("5' - 1'"), 4 * 0.3048, rounding) << "feet behind a minus are subtracted";
}

TEST(AFigure, that_cannot_be_read_says_what_is_wrong) {
    EXPECT_EQ(fault_of(""), "A figure is missing at the end.");
    EXPECT_EQ(fault_of("2*"), "A figure is missing at the end.");
    EXPECT_EQ(fault_of("two"), "A figure is expected where \"two\" stands.");
    EXPECT_EQ(fault_of("3 kg"), "\"kg\" is no unit here; these are: m, cm, mm, ft, ', in, \".");
    EXPECT_EQ(fault_of("(1+2"), "A closing bracket is missing.");
    EXPECT_EQ(fault_of("1)"), "There is a closing bracket too many.");
    EXPECT_EQ(fault_of("1/0"), "This divides by zero.");
    EXPECT_EQ(fault_of("1/(2-2)"), "This divides by zero.");
    EXPECT_EQ(fault_of("1,25"), "Decimals stand behind a point, not a comma.");
    EXPECT_EQ(fault_of("1 m * 2 m"), "Two figures with units cannot be multiplied.");
    EXPECT_EQ(fault_of("1e999"), "This figure is too large or too small.");
    EXPECT_EQ(fault_of("1e300*1e300"), "This figure is too large or too small.");
    EXPECT_EQ(fault_of("inf"), "A figure is expected where \"inf\" stands.");
    EXPECT_EQ(fault_of(std::string(201, '1')), "This is too long for a figure.");
    EXPECT_EQ(fault_of(std::string(150, '(')), "There are too many brackets or signs.");
    EXPECT_EQ(fault_of(std::string(150, '-')), "There are too many brackets or signs.");
}

TEST(AFigure, of_any_letters_has_a_finite_value_or_a_fault) {
    constexpr std::string_view letters = "0123456789.+-*/() '\"mcfti,ex\t\xC2\xB0\xFF";
    std::mt19937 random(7);
    for (int round = 0; round < 20000; ++round) {
        std::string text(random() % 24, ' ');
        for (char& letter : text) letter = letters[random() % letters.size()];
        const Calculated result = calculated(text, metres, 0.01);
        EXPECT_NE(result.value.has_value(), !result.fault.empty()) << text;
        EXPECT_TRUE(std::isfinite(result.value.value_or(0.0))) << text;
    }
}

}  // namespace
}  // namespace hanei
