#include "engine/project/luminaire_text.h"
#include "engine/project/number_text.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

TEST(NumberText, plain_decimals_are_read_in_every_notation) {
    EXPECT_EQ(decimal_number("37.0"), 37.0);
    EXPECT_EQ(decimal_number("-.5"), -0.5);
    EXPECT_EQ(decimal_number("+5."), 5.0);
    EXPECT_EQ(decimal_number("1.5E+02"), 150.0);
    EXPECT_EQ(decimal_number("94.792500000000004"), 94.7925);
}

TEST(NumberText, everything_else_is_no_number) {
    for (const char* text :
         {"", "+", ".", "nan", "inf", "-Infinity", "0x10", "1e400", "1e", "1.2.3", "1,5", "12lm", "+-1", "1 2"}) {
        EXPECT_FALSE(decimal_number(text)) << text;
    }
}

TEST(NumberText, one_comma_may_stand_for_the_point_where_that_is_allowed) {
    EXPECT_EQ(decimal_number_with_comma("1,5"), 1.5);
    EXPECT_EQ(decimal_number_with_comma("1.5"), 1.5);
    EXPECT_FALSE(decimal_number_with_comma("1,2,3"));
    EXPECT_FALSE(decimal_number_with_comma("1.000,5"));
}

TEST(NumberText, a_quoted_word_is_short_and_printable) {
    EXPECT_EQ(in_quotes("a\x01\xFF"), "\"a??\"");
    EXPECT_EQ(in_quotes(std::string(100, 'x')).size(), 45U);
}

TEST(LuminaireText, utf16_is_decoded_and_a_byte_order_mark_dropped) {
    using namespace std::string_view_literals;
    EXPECT_EQ(decoded_text("\xFF\xFE\x41\x00\xFC\x00"sv), "A\xC3\xBC");
    EXPECT_EQ(decoded_text("\xFE\xFF\x00\x41\xD8\x3D\xDC\xA1"sv), "A\xF0\x9F\x92\xA1");
    EXPECT_EQ(decoded_text("\xFE\xFF\xD8\x3D\x00"sv), "\xEF\xBF\xBD");
    EXPECT_EQ(decoded_text("\xEF\xBB\xBFtext"), "text");
}

TEST(LuminaireText, bytes_that_are_no_utf8_become_latin_1) {
    EXPECT_EQ(utf8_text("\xC3\xBC"), "\xC3\xBC");
    EXPECT_EQ(utf8_text("\xFC"), "\xC3\xBC");
    EXPECT_EQ(utf8_text("\xED\xA0\x80"), "\xC3\xAD\xC2\xA0\xC2\x80");
    EXPECT_EQ(utf8_text("\xC0\xAF"), "\xC3\x80\xC2\xAF");
}

TEST(LuminaireText, every_kind_of_line_end_counts_once) {
    LineReader lines{"a\r\nb\rc\n\nd"};
    std::string all;
    while (lines.next()) all += std::string{lines.line()} + "|";
    EXPECT_EQ(all, "a|b|c||d|");
    EXPECT_EQ(lines.number(), 5);
}

}  // namespace
}  // namespace hanei
