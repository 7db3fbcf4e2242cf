#include "engine/project/measured_file.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

MeasuredValues values_of(const std::string& text) {
    MeasuredRead read = read_measured_text(text, "t.csv");
    for (const Diagnostic& finding : read.findings) ADD_FAILURE() << to_text(finding);
    return read.values.value_or(MeasuredValues{});
}

/// What is said of a table that cannot be used.
std::string faults_of(const std::string& text) {
    const MeasuredRead read = read_measured_text(text, "t.csv");
    EXPECT_FALSE(read.values.has_value());
    std::string said;
    for (const Diagnostic& finding : read.findings) said += to_text(finding) + '\n';
    return said;
}

TEST(MeasuredFile, a_plain_table_is_read_by_its_header) {
    const MeasuredValues values = values_of("set,index,lux,uncertainty\nDesk,1,512.5,12\nDesk,2,480,\n");
    ASSERT_EQ(values.values.size(), 2U);
    EXPECT_EQ(values.values[0].set, "Desk");
    EXPECT_EQ(values.values[0].index, 1);
    EXPECT_EQ(values.values[0].lux, 512.5);
    EXPECT_EQ(values.values[0].uncertainty, 12.0);
    EXPECT_EQ(values.values[0].line, 2);
    EXPECT_FALSE(values.values[1].uncertainty.has_value());
}

TEST(MeasuredFile, an_export_with_a_preamble_millimetres_and_decimal_commas_is_understood) {
    const MeasuredValues values = values_of(
        "\xef\xbb\xbfProject: Office; storey 2\r\n\r\nCalculation surface;Nr;X [mm];Y [mm];Z [mm];Illuminance "
        "[lx];Uncertainty [%]\r\nDesk;1;750,5;1250;750;437,9;10\r\nDesk;2;1250;750;750;/;\r\n\r\n");
    ASSERT_EQ(values.values.size(), 1U);
    EXPECT_DOUBLE_EQ(values.values[0].plan->x, 0.7505);
    EXPECT_DOUBLE_EQ(*values.values[0].height, 0.75);
    EXPECT_DOUBLE_EQ(values.values[0].lux, 437.9);
    EXPECT_DOUBLE_EQ(*values.values[0].uncertainty, 43.79);
    EXPECT_EQ(values.without_value, 1U);
}

TEST(MeasuredFile, tabs_quotes_and_foot_candles_are_understood) {
    const MeasuredValues values = values_of("# by hand\npoint\tE (fc)\n\"Desk \"\"left\"\"\"\t10\n");
    ASSERT_EQ(values.values.size(), 1U);
    EXPECT_EQ(values.values[0].set, "Desk \"left\"");
    EXPECT_NEAR(values.values[0].lux, 107.639, 1e-3);
}

TEST(MeasuredFile, a_point_column_counts_where_another_names_the_set) {
    const MeasuredValues values = values_of("grid;point;E\nDesk;7;100\n");
    EXPECT_EQ(values.values[0].set, "Desk");
    EXPECT_EQ(values.values[0].index, 7);
}

TEST(MeasuredFile, directions_are_made_unit) {
    const MeasuredValues values = values_of("x,y,z,nx,ny,nz,lux\n1,2,3,0,3,4,5\n");
    EXPECT_NEAR(values.values[0].normal->y, 0.6, 1e-15);
}

TEST(MeasuredFile, faults_name_line_field_what_was_found_and_what_is_allowed) {
    const std::string said = faults_of("set,index,lux\nA,1,abc\nA,0,5\nA,1.5,5\nA,2,-1\nA,2,nan\n\"A,2,1\nA,1,1,5\n");
    for (const char* expected :
         {"t.csv:2: lux: \"abc\" is no number; allowed is a number from 0 to 1000000000\n",
          "t.csv:3: index: \"0\" is out of range; allowed is a whole number from 1 to 1000000000\n",
          "t.csv:4: index: 1.5 is no whole number; points are counted from 1\n", "t.csv:5: lux: \"-1\" is out of range",
          "t.csv:6: lux: \"nan\" is no number", "t.csv:7: a quote does not end on its line\n",
          "t.csv:8: 4 fields, where the header has 3; decimals have a point where commas separate\n"})
        EXPECT_NE(said.find(expected), std::string::npos) << expected << "\nin\n" << said;
}

TEST(MeasuredFile, a_table_without_what_it_needs_says_what_it_needs) {
    EXPECT_NE(faults_of("").find("no row names a column of illuminances"), std::string::npos);
    EXPECT_NE(faults_of("a,b\n1,2\n").find("no row names a column of illuminances"), std::string::npos);
    EXPECT_NE(faults_of("lux\n5\n").find("no column says where"), std::string::npos);
    EXPECT_NE(faults_of("x,lux\n1,5\n").find("a column x and none y"), std::string::npos);
    EXPECT_NE(faults_of("set,E,lux\nA,1,2\n").find("\"lux\" means the same"), std::string::npos);
    EXPECT_NE(faults_of("set,lux\n").find("no row below the header has a value"), std::string::npos);
    EXPECT_NE(faults_of("set,x,y,lux\n,1,,5\n").find("a place needs both x and y"), std::string::npos);
    EXPECT_NE(faults_of("set,index,lux\n,,5\n").find("nothing says where"), std::string::npos);
    EXPECT_NE(faults_of("x,y,z,nx,ny,nz,lux\n1,2,3,0,0,0,5\n").find("has no direction"), std::string::npos);
}

TEST(MeasuredFile, a_thousand_faults_are_twenty_and_a_count) {
    std::string text = "set,lux\n";
    for (int k = 0; k < 1000; ++k) text += "A,x\n";
    const MeasuredRead read = read_measured_text(text, "t.csv");
    ASSERT_EQ(read.findings.size(), 21U);
    EXPECT_EQ(read.findings.back().message, "980 faults more");
}

TEST(MeasuredFile, any_cut_and_any_changed_byte_is_a_table_or_a_sentence) {
    const std::string whole =
        "Title\r\nset;index;x [mm];y;z;nx;ny;nz;E [lx];u "
        "[%]\r\n\"A;\"\"b\";1;1,5;2;3;0;0;1;512,5;3\r\nB;2;1;2;3;;;;/;\r\n";
    const auto holds = [](const std::string& text) {
        const MeasuredRead read = read_measured_text(text, "t.csv");
        EXPECT_EQ(read.values.has_value(), read.findings.empty()) << text;
    };
    for (std::size_t k = 0; k <= whole.size(); ++k) holds(whole.substr(0, k));
    for (std::size_t k = 0; k < whole.size(); ++k) {
        for (const char c : {'\0', '"', ';', '\n', '\xff', 'e'}) {
            std::string changed = whole;
            changed[k] = c;
            holds(changed);
        }
    }
}

TEST(MeasuredFile, a_missing_file_is_a_finding) {
    EXPECT_TRUE(has_errors(read_measured("nowhere/at-all.csv").findings));
}

}  // namespace
}  // namespace hanei
