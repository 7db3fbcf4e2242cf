#include "engine/project/luminaire_file.h"
#include "engine/scene/intensity.h"

#include <array>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace hanei {
namespace {

/// A small EULUMDAT file as its lines: Isym 4, planes 0 to 270 by 90, gamma 0, 60, 120, one lamp set.
std::vector<std::string> lines() {
    return {"Maker", "3",    "4",   "4",  "90",   "3",   "60",   "report", "Lamp", "no. 1", "file.ldt",
            "today", "1300", "320", "80", "1200", "300", "0",    "0",      "0",    "0",     "90",
            "75",    "1",    "0",   "1",  "2",    "T16", "6000", "840",    "1B",   "70",    "1",
            "1",     "1",    "1",   "1",  "1",    "1",   "1",    "1",      "1",    "0",     "90",
            "180",   "270",  "0",   "60", "120",  "100", "80",   "5",      "100",  "40",    "5"};
}

LuminaireFileRead read(const std::vector<std::string>& of) {
    std::string text;
    for (const std::string& line : of) text += line + "\r\n";
    return read_luminaire_text(text, "lamp.ldt");
}

Diagnostic refusal(const std::vector<std::string>& of) {
    const LuminaireFileRead result = read(of);
    EXPECT_FALSE(result.photometry);
    return result.findings.empty() ? Diagnostic{} : result.findings.back();
}

TEST(LdtFile, says_what_it_holds) {
    const LuminaireFileRead result = read(lines());
    ASSERT_TRUE(result.photometry);
    const Photometry& photometry = *result.photometry;
    EXPECT_TRUE(result.findings.empty());
    EXPECT_EQ(photometry.format, "EULUMDAT");
    EXPECT_EQ(photometry.name, "Lamp");
    EXPECT_EQ(photometry.symmetry, PhotometricSymmetry::quadrant);
    EXPECT_EQ(photometry.horizontal_deg, (std::vector<double>{0.0, 90.0}));
    EXPECT_EQ(photometry.lamps, 2);
    EXPECT_EQ(photometry.lamp_lumens, 6000.0);
    EXPECT_EQ(*photometry.declared_output_ratio, 0.75);
    EXPECT_EQ(*photometry.declared_downward_share, 0.9);
    EXPECT_EQ(photometry.keywords[0], (std::pair<std::string, std::string>{"company", "Maker"}));
}

TEST(LdtFile, candela_are_cd_per_klm_times_the_flux_of_all_lamps_of_the_set) {
    EXPECT_EQ(read(lines()).photometry->candela, (std::vector<double>{600, 480, 30, 600, 240, 30}));
    EXPECT_EQ(read(lines()).photometry->candela_per_figure, 6.0);
}

TEST(LdtFile, the_length_of_the_opening_lies_along_plane_90) {
    EXPECT_EQ(read(lines()).photometry->opening, (MeasuredOpeningSize{OpeningShape::rectangle, 0.3, 1.2, 0.0}));
}

TEST(LdtFile, sides_of_different_height_are_kept_apart) {
    auto stepped = lines();
    stepped[17] = "50";
    stepped[19] = "20";
    const MeasuredOpeningSize opening = read(stepped).photometry->opening;
    EXPECT_EQ(opening.shape, OpeningShape::box);
    EXPECT_EQ(opening.height, 0.05);
    EXPECT_EQ(opening.side_heights, (std::array<double, 4>{0.05, 0.0, 0.02, 0.0}));
    EXPECT_FALSE(read(lines()).photometry->opening.side_heights);
}

TEST(LdtFile, a_width_of_0_makes_the_opening_round) {
    auto round = lines();
    round[16] = "0";
    EXPECT_EQ(read(round).photometry->opening.shape, OpeningShape::circle);
    round[17] = "40";
    EXPECT_EQ(read(round).photometry->opening.shape, OpeningShape::vertical_cylinder);
}

TEST(LdtFile, a_negative_number_of_lamps_makes_it_absolute) {
    auto absolute = lines();
    absolute[26] = "-1";
    EXPECT_TRUE(read(absolute).photometry->absolute);
    EXPECT_EQ(read(absolute).photometry->candela[0], 600.0);
    EXPECT_EQ(read(absolute).photometry->lamp_lumens, 0.0);
}

TEST(LdtFile, decimal_commas_blank_names_and_tabs_are_read) {
    auto commas = lines();
    commas[23] = "1,0";
    commas[8] = "";
    commas[53] = "\t40,5 ";
    ASSERT_TRUE(read(commas).photometry);
    EXPECT_DOUBLE_EQ(read(commas).photometry->candela[4], 243.0);
}

TEST(LdtFile, a_conversion_factor_multiplies_with_a_warning_and_0_is_read_as_1) {
    auto other = lines();
    other[23] = "0.5";
    EXPECT_EQ(read(other).photometry->candela[0], 300.0);
    EXPECT_EQ(read(other).photometry->warnings.size(), 1U);
    other[23] = "0";
    EXPECT_EQ(read(other).photometry->candela[0], 600.0);
    EXPECT_EQ(read(other).photometry->warnings.size(), 1U);
}

TEST(LdtFile, isym_3_stores_the_planes_from_270_over_0_to_90) {
    auto half = lines();
    half[2] = "3";
    half.insert(half.end(), {"100", "20", "5"});
    const LuminaireFileRead result = read(half);
    ASSERT_TRUE(result.photometry);
    EXPECT_EQ(result.photometry->horizontal_deg, (std::vector<double>{-90.0, 0.0, 90.0}));
    const auto at = [&](double plane) {
        return intensity(*result.photometry, photometric_direction(PhotometricType::C, {plane, 60.0})).value;
    };
    EXPECT_NEAR(at(270.0), 480.0, 1e-9);
    EXPECT_NEAR(at(0.0), 240.0, 1e-9);
    EXPECT_NEAR(at(180.0), 240.0, 1e-9);
    EXPECT_NEAR(at(90.0), 120.0, 1e-9);
}

TEST(LdtFile, the_first_of_several_lamp_sets_is_used_and_all_are_kept) {
    auto sets = lines();
    sets[25] = "2";
    const std::vector<std::string> second{"1", "T5", "9000", "830", "1A", "100"};
    sets.insert(sets.begin() + 32, second.begin(), second.end());
    const LuminaireFileRead result = read(sets);
    ASSERT_TRUE(result.photometry);
    EXPECT_EQ(result.photometry->lamp_sets.size(), 2U);
    EXPECT_EQ(result.photometry->lamp_sets[1].lumens, 9000.0);
    EXPECT_EQ(result.photometry->candela[0], 600.0);
    EXPECT_EQ(result.findings[0].place.line, 26);
}

TEST(LdtFile, with_a_blank_line_too_many_is_refused_where_a_number_is_missing) {
    auto shifted = lines();
    shifted.insert(shifted.begin() + 8, "");
    EXPECT_EQ(refusal(shifted).place.line, 13);
    EXPECT_EQ(refusal(shifted).place.field, "length");
}

TEST(LdtFile, planes_that_cannot_have_its_symmetry_are_refused) {
    auto six = lines();
    six[3] = "6";
    EXPECT_EQ(refusal(six).place.line, 4);
    auto turned = lines();
    turned[42] = "10";
    EXPECT_EQ(refusal(turned).place.field, "C angle");
}

TEST(LdtFile, counts_beyond_the_file_are_refused_at_their_line) {
    for (const auto& [line, field] : {std::pair{3, "Mc"}, std::pair{5, "Ng"}, std::pair{25, "number of lamp sets"}}) {
        auto huge = lines();
        huge[static_cast<std::size_t>(line)] = "2000000000";
        EXPECT_EQ(refusal(huge).place.line, line + 1);
        EXPECT_EQ(refusal(huge).place.field, field);
    }
}

TEST(LdtFile, that_ends_too_early_is_refused_at_the_line_that_is_missing) {
    auto cut = lines();
    cut.resize(20);
    EXPECT_EQ(refusal(cut).place.line, 21);
    cut = lines();
    cut.pop_back();
    EXPECT_EQ(refusal(cut).place.field, "intensity");
}

TEST(LdtFile, is_recognised_under_any_name) {
    std::string text;
    for (const std::string& line : lines()) text += line + "\n";
    const LuminaireFileRead result = read_luminaire_text(text, "lamp.IES");
    ASSERT_TRUE(result.photometry);
    EXPECT_EQ(result.photometry->format, "EULUMDAT");
    EXPECT_EQ(result.photometry->warnings.size(), 1U);
}

}  // namespace
}  // namespace hanei
