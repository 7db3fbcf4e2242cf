#include "ui/panels/units.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

/// The units of the window for one test.
struct Shown {
    explicit Shown(LengthUnit length, IlluminanceUnit illuminance = IlluminanceUnit::lux) {
        show_units(length, illuminance);
    }
    ~Shown() { show_units(LengthUnit::metre, IlluminanceUnit::lux); }
};

TEST(Lengths, are_shown_as_preferred) {
    EXPECT_EQ(with_unit(1.234, "m", 2), "1.23 m");
    {
        const Shown shown(LengthUnit::centimetre);
        EXPECT_EQ(with_unit(1.234, "m", 2), "123 cm");
        EXPECT_EQ(with_unit(1.2346, "m", 3), "123.5 cm");
    }
    const Shown shown(LengthUnit::millimetre);
    EXPECT_EQ(with_unit(1.234, "m", 3), "1234 mm");
}

TEST(Lengths, in_feet_and_inches_are_divided_as_a_rule_is) {
    const Shown shown(LengthUnit::feet_inches);
    EXPECT_EQ(with_unit(5 * 0.3048 + 3.5 * 0.0254, "m", 3), "5'-3 1/2\"");
    EXPECT_EQ(with_unit(0.0, "m", 3), "0'-0\"");
    EXPECT_EQ(with_unit(-0.3048, "m", 3), "-1'-0\"");
    EXPECT_EQ(with_unit(0.3048 - 0.0001, "m", 3), "1'-0\"") << "rounded up over the foot";
    EXPECT_EQ(with_unit(1e9, "m", 3), "3280839895'");
}

TEST(Illuminances, are_shown_in_foot_candles_when_preferred) {
    EXPECT_EQ(with_unit(500.0, "lx", 0), "500 lx");
    const Shown shown(LengthUnit::metre, IlluminanceUnit::foot_candle);
    EXPECT_EQ(with_unit(500.0, "lx", 0), "46.5 fc");
    EXPECT_EQ(with_unit(4000.0, "K", 0), "4000 K") << "other units stay";
}

}  // namespace
}  // namespace hanei
