#include "engine/project/luminaire_file.h"
#include "engine/scene/intensity.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <optional>
#include <string>

namespace hanei {
namespace {

/// A small LM-63 file, one part of which a test replaces.
struct Parts {
    std::string version = "IESNA:LM-63-2002\n";
    std::string label = "[LUMINAIRE] Panel\n[MORE] with a frame\n[LAMP] LED\n";
    std::string tilt = "TILT=NONE\n";
    std::string lamps = "2 500 1.5 ";
    std::string counts = "3 1 ";
    std::string type = "1 2 ";
    std::string opening = "0.6 1.2 0\n";
    std::string factors = "0.8 1.1 30\n";
    std::string verticals = "0 45 90\n";
    std::string horizontals = "0\n";
    std::string candela = "100 80 0\n";
    std::string text() const {
        return version + label + tilt + lamps + counts + type + opening + factors + verticals + horizontals + candela;
    }
};

LuminaireFileRead read(const Parts& parts) { return read_luminaire_text(parts.text(), "panel.ies"); }

Diagnostic refusal(const Parts& parts) {
    const LuminaireFileRead result = read(parts);
    EXPECT_FALSE(result.photometry);
    return result.findings.empty() ? Diagnostic{} : result.findings.back();
}

TEST(IesFile, says_what_it_holds) {
    const LuminaireFileRead result = read({});
    ASSERT_TRUE(result.photometry);
    const Photometry& photometry = *result.photometry;
    EXPECT_TRUE(result.findings.empty());
    EXPECT_EQ(photometry.name, "Panel");
    EXPECT_EQ(photometry.source_file, "panel.ies");
    EXPECT_EQ(photometry.format, "LM-63-2002");
    EXPECT_EQ(photometry.symmetry, PhotometricSymmetry::rotational);
    EXPECT_EQ(photometry.lamps, 2);
    EXPECT_EQ(photometry.lamp_lumens, 1000.0);
    EXPECT_EQ(photometry.input_watts, 30.0);
    ASSERT_EQ(photometry.keywords.size(), 2U);
    EXPECT_EQ(photometry.keywords[0].second, "Panel\nwith a frame");
    EXPECT_EQ(photometry.opening, (MeasuredOpeningSize{OpeningShape::rectangle, 1.2, 0.6, 0.0}));
}

TEST(IesFile, candela_take_multiplier_and_ballast_factor_but_the_ballast_lamp_factor_until_1991_alone) {
    Parts parts;
    EXPECT_DOUBLE_EQ(read(parts).photometry->candela[0], 100.0 * 1.5 * 0.8);
    parts.version = "IESNA91\n";
    EXPECT_DOUBLE_EQ(read(parts).photometry->candela[0], 100.0 * 1.5 * 0.8 * 1.1);
    parts.version = "";
    EXPECT_EQ(read(parts).photometry->format, "LM-63-1986");
    EXPECT_DOUBLE_EQ(read(parts).photometry->candela[0], 100.0 * 1.5 * 0.8 * 1.1);
    parts.version = "IES:LM-63-2019\n";
    EXPECT_DOUBLE_EQ(read(parts).photometry->candela[0], 100.0 * 1.5 * 0.8);
    EXPECT_DOUBLE_EQ(read(parts).photometry->candela_per_figure, 1.5 * 0.8);
}

TEST(IesFile, feet_become_metres) {
    Parts parts;
    parts.type = "1 1 ";
    EXPECT_DOUBLE_EQ(read(parts).photometry->opening.extent_0, 1.2 * 0.3048);
}

TEST(IesFile, with_lumens_of_minus_one_is_absolute) {
    Parts parts;
    parts.lamps = "1 -1 1 ";
    const LuminaireFileRead result = read(parts);
    EXPECT_TRUE(result.photometry->absolute);
    EXPECT_EQ(result.photometry->lamp_lumens, 0.0);
    EXPECT_TRUE(result.findings.empty());
}

TEST(IesFile, numbers_may_wrap_anywhere) {
    Parts parts;
    parts.verticals = "0,45\r\n,90 ";
    parts.candela = "1e2\t80 ,\r0";
    ASSERT_TRUE(read(parts).photometry);
    EXPECT_EQ(read(parts).photometry->candela.size(), 3U);
}

TEST(IesFile, tilt_factors_are_kept_beside_the_figures) {
    Parts parts;
    parts.tilt = "TILT=INCLUDE\n1\n2\n0 90\n1 0.9\n";
    const LuminaireFileRead result = read(parts);
    ASSERT_TRUE(result.photometry->tilt);
    EXPECT_EQ(result.photometry->tilt->factor, (std::vector<double>{1.0, 0.9}));
    EXPECT_DOUBLE_EQ(result.photometry->candela[0], 100.0 * 1.5 * 0.8);
}

TEST(IesFile, with_a_missing_angle_is_refused_with_its_line) {
    Parts parts;
    parts.verticals = "0 45\n";
    const Diagnostic found = refusal(parts);
    EXPECT_EQ(found.place.file, "panel.ies");
    EXPECT_EQ(found.place.line, 9);  // the 0 of the next line is taken for the missing angle
    EXPECT_EQ(found.place.field, "vertical angle");
    EXPECT_EQ(found.message, "0 follows 45; angles must increase");
}

TEST(IesFile, that_ends_too_early_is_refused_with_what_was_found) {
    Parts parts;
    parts.candela = "100 80\n";
    const Diagnostic found = refusal(parts);
    EXPECT_EQ(found.place.field, "candela");
    EXPECT_EQ(found.message, "the file ends after 2 of 3 values");
}

TEST(IesFile, that_announces_more_than_a_file_can_hold_is_refused_before_anything_is_reserved) {
    Parts parts;
    for (const char* counts :
         {"2000000000 2000000000 ", "65536 65536 ", "99999999999999999999 1 ", "-3 1 ", "0 1 ", "3.5 1 "}) {
        parts.counts = counts;
        EXPECT_EQ(refusal(parts).place.line, 6) << counts;
    }
}

TEST(IesFile, with_a_word_or_a_figure_that_is_none_is_refused) {
    Parts parts;
    for (const char* candela : {"nan 80 0", "100 inf 0", "100 0x1p3 0", "100 1e400 0", "100 eighty 0", "100 --8 0"}) {
        parts.candela = candela;
        EXPECT_EQ(refusal(parts).place.field, "candela") << candela;
    }
}

TEST(IesFile, symmetry_follows_the_range_of_the_horizontal_angles) {
    Parts parts;
    parts.counts = "3 3 ";
    parts.candela = "1 1 0 1 1 0 1 1 0";
    const auto symmetry = [&](const char* horizontals) {
        parts.horizontals = horizontals;
        return read(parts).photometry->symmetry;
    };
    EXPECT_EQ(symmetry("0 45 90\n"), PhotometricSymmetry::quadrant);
    EXPECT_EQ(symmetry("0 90 180\n"), PhotometricSymmetry::plane_0);
    EXPECT_EQ(symmetry("90 180 270\n"), PhotometricSymmetry::plane_90);
    EXPECT_EQ(symmetry("0 180 360\n"), PhotometricSymmetry::none);
    EXPECT_EQ(symmetry("0 120 240\n"), PhotometricSymmetry::none);
    parts.horizontals = "30 50 75\n";
    EXPECT_EQ(refusal(parts).place.field, "horizontal angle");
}

TEST(IesFile, doubtful_figures_are_read_with_a_warning) {
    Parts parts;
    parts.candela = "100 -3 0\n";
    const LuminaireFileRead negative = read(parts);
    ASSERT_EQ(negative.photometry->warnings.size(), 1U);
    EXPECT_EQ(negative.photometry->candela[1], 0.0);
    EXPECT_EQ(negative.findings[0].severity, Severity::warning);
    parts.candela = "100 80 0\nIESNA:LM-63-2002\n";
    EXPECT_EQ(read(parts).findings[0].place.line, 11);
    parts.candela = "0 0 0\n";
    EXPECT_EQ(read(parts).findings.size(), 1U);
    parts.opening = "600 1200 0\n";
    EXPECT_EQ(read(parts).findings.size(), 2U);
}

struct OpeningCase {
    const char* dimensions;  // width, length, height
    OpeningShape until_1995, since_2002;
};

TEST(IesFile, the_signs_of_its_dimensions_name_the_shape_of_the_opening) {
    using Shape = OpeningShape;
    const OpeningCase cases[] = {
        {"0 0 0", Shape::point, Shape::point},
        {"1 2 3", Shape::box, Shape::box},
        {"-1 0 0", Shape::circle, Shape::circle},
        {"-1 -1 0", Shape::circle, Shape::circle},
        {"-1 2 0", Shape::ellipse, Shape::ellipse},
        {"-1 -2 0", Shape::ellipse, Shape::ellipse},
        {"-1 0 3", Shape::vertical_cylinder, Shape::vertical_cylinder},
        {"-1 -1 3", Shape::vertical_cylinder, Shape::vertical_cylinder},
        {"-1 0 -1", Shape::sphere, Shape::vertical_disc},
        {"-1 -1 -1", Shape::sphere, Shape::sphere},
        {"-1 -2 -3", Shape::ellipsoid, Shape::ellipsoid},
        {"-1 2 -1", Shape::ellipsoid, Shape::horizontal_cylinder},
        {"2 -1 -1", Shape::ellipsoid, Shape::horizontal_cylinder_90},
        {"0 2 -1", Shape::horizontal_cylinder, Shape::horizontal_cylinder},
        {"2 0 -1", Shape::horizontal_cylinder_90, Shape::horizontal_cylinder_90},
    };
    Parts parts;
    for (const OpeningCase& opening : cases) {
        parts.opening = std::string{opening.dimensions} + "\n";
        parts.version = "IESNA:LM-63-1995\n";
        EXPECT_EQ(read(parts).photometry->opening.shape, opening.until_1995) << opening.dimensions;
        parts.version = "IESNA:LM-63-2002\n";
        EXPECT_EQ(read(parts).photometry->opening.shape, opening.since_2002) << opening.dimensions;
    }
    parts.opening = "0 -1 0\n";
    EXPECT_EQ(read(parts).photometry->opening.shape, OpeningShape::point);
    EXPECT_EQ(read(parts).photometry->warnings.size(), 1U);
}

TEST(IesFile, text_that_is_no_utf8_is_kept_as_latin_1) {
    Parts parts;
    parts.label = "[LUMINAIRE] B\xFCro\n";
    EXPECT_EQ(read(parts).photometry->name, "B\xC3\xBCro");
}

TEST(IesFile, tilt_factors_of_a_file_beside_it_are_read_from_there) {
    Parts parts;
    parts.tilt = "TILT=lamp.tlt\n";
    std::string asked;
    const FileBeside beside = [&asked](const std::string& name) -> std::optional<std::string> {
        asked = name;
        return "2\n3\n0 45 90\n1 .95, 0.9\n";
    };
    const LuminaireFileRead result = read_luminaire_text(parts.text(), "panel.ies", beside);
    ASSERT_TRUE(result.photometry);
    EXPECT_TRUE(result.findings.empty());
    EXPECT_EQ(asked, "lamp.tlt");
    EXPECT_EQ(*result.photometry->tilt, (LampTilt{"lamp.tlt", 2, {0.0, 45.0, 90.0}, {1.0, 0.95, 0.9}}));
    EXPECT_EQ(result.photometry->candela, read(Parts{}).photometry->candela);
}

TEST(IesFile, a_tilt_file_that_is_missing_or_broken_is_a_warning) {
    Parts parts;
    parts.tilt = "TILT=lamp.tlt\n";
    for (const FileBeside& beside : {FileBeside{}, FileBeside{[](const std::string&) { return std::nullopt; }},
                                     FileBeside{[](const std::string&) { return "2\n3\n0 45"; }}}) {
        const LuminaireFileRead result = read_luminaire_text(parts.text(), "panel.ies", beside);
        ASSERT_TRUE(result.photometry);
        EXPECT_TRUE(result.photometry->tilt->factor.empty());
        ASSERT_EQ(result.findings.size(), 1U);
        EXPECT_EQ(result.findings[0].place.field, "TILT");
    }
}

TEST(IesFile, a_tilt_file_is_looked_for_under_its_bare_name_alone) {
    const FileBeside beside = files_beside(std::filesystem::path{HANEI_SOURCE} / "tests/unit/lamp.ies");
    EXPECT_TRUE(files_beside(std::filesystem::path{HANEI_SOURCE} / "lamp.ies")("README.md"));
    for (const char* name : {"../../README.md", "..\\..\\README.md", "/etc/hostname", "C:lamp.tlt", "project", "", ".",
                             "project/luminaire_ies_test.cpp", "a\nb"})
        EXPECT_FALSE(beside(name)) << name;
}

TEST(IesFile, without_a_tilt_line_or_without_text_is_refused) {
    Parts parts;
    parts.tilt = "";
    EXPECT_EQ(refusal(parts).place.field, "TILT");
    EXPECT_FALSE(read_luminaire_text("", "empty.ies").photometry);
    EXPECT_FALSE(read_luminaire_text(std::string(100, '\0'), "zeros.ies").photometry);
    EXPECT_FALSE(read_luminaire_text("\n\n \r\n", "blank.ldt").photometry);
}

}  // namespace
}  // namespace hanei
