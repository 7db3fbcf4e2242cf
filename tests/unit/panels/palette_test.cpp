#include "ui/panels/palette.h"

#include <gtest/gtest.h>
#include <utility>

namespace hanei::style {
namespace {

class EveryTheme : public testing::TestWithParam<Theme> {
protected:
    const Palette& look = palette(GetParam());
    /// Everything a letter may stand on, made opaque.
    std::vector<std::pair<const char*, ImU32>> grounds() const {
        return {{"ground", look.ground},
                {"panel", look.panel},
                {"popup", look.popup},
                {"field", look.field},
                {"hovered field", look.field_hovered},
                {"card over black", laid_over(look.card, IM_COL32(0, 0, 0, 255))},
                {"card over white", laid_over(look.card, IM_COL32(255, 255, 255, 255))},
                {"chosen", laid_over(look.chosen, look.panel)},
                {"second row", laid_over(look.row, look.panel)}};
    }
};

TEST(Contrast, is_21_between_black_and_white_and_1_with_itself) {
    EXPECT_NEAR(contrast(IM_COL32(255, 255, 255, 255), IM_COL32(0, 0, 0, 255)), 21.0, 1e-9);
    EXPECT_NEAR(contrast(IM_COL32(90, 12, 7, 255), IM_COL32(90, 12, 7, 255)), 1.0, 1e-9);
    // Grey 0x767676 on white is the textbook's 4.54.
    EXPECT_NEAR(contrast(IM_COL32(0x76, 0x76, 0x76, 255), IM_COL32(255, 255, 255, 255)), 4.54, 0.005);
}

TEST_P(EveryTheme, writes_letters_that_read_on_every_ground) {
    const std::pair<const char*, ImU32> letters[] = {
        {"text", look.text}, {"quiet", look.quiet_text}, {"accent", look.accent}, {"second", look.second},
        {"good", look.good}, {"warning", look.warning},  {"error", look.error}};
    for (const auto& [name, colour] : letters) {
        for (const auto& [where, ground] : grounds())
            EXPECT_GE(contrast(colour, ground), 4.5) << name << " on " << where;
    }
}

TEST_P(EveryTheme, draws_marks_that_are_seen_on_every_ground) {
    for (const ImU32 mark : {look.axis_x, look.axis_y, look.axis_z, look.furniture, look.reading, look.sight}) {
        for (const auto& [where, ground] : grounds()) EXPECT_GE(contrast(mark, ground), 3.0) << mark << " on " << where;
    }
}

INSTANTIATE_TEST_SUITE_P(Palettes, EveryTheme, testing::Values(Theme::dark, Theme::light),
                         [](const auto& each) { return each.param == Theme::dark ? "dark" : "light"; });

}  // namespace
}  // namespace hanei::style
