// TM-33 files of several emitters, and the areas that emit.

#include "engine/project/luminaire_file.h"
#include "engine/scene/intensity.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace hanei {
namespace {

LuminaireFileRead read(const std::string& text) { return read_luminaire_text(text, "lamp.xml"); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

std::string emitter(const std::string& name, const std::string& data, const std::string& more = "") {
    return "<Emitter><Quantity>1</Quantity><Description>" + name + "</Description><InputWattage>10</InputWattage>" +
           "<LuminousData><LuminousIntensity>" + data + "</LuminousIntensity></LuminousData>" + more + "</Emitter>\n";
}

std::string file_of(const std::string& emitters, const std::string& goniometer = "IES_C",
                    const std::string& root = "IESTM33-22") {
    return "<?xml version=\"1.0\"?>\n<" + root + "><Version>1.1</Version><Equipment><Gonioradiometer><Type>" +
           goniometer + "</Type></Gonioradiometer></Equipment>\n" + emitters + "</" + root + ">";
}

const std::string down = "<IntData h='0' v='0'>100</IntData><IntData h='0' v='90'>40</IntData>";
const std::string all_around =
    "<IntData h='0' v='0'>10</IntData><IntData h='0' v='60'>20</IntData>"
    "<IntData h='0' v='180'>30</IntData>";
const std::string quadrant =
    "<IntData h='0' v='0'>8</IntData><IntData h='0' v='180'>8</IntData>"
    "<IntData h='90' v='0'>4</IntData><IntData h='90' v='180'>4</IntData>";

TEST(Tm33Emitters, emitters_with_the_same_angles_are_added_figure_by_figure) {
    const LuminaireFileRead result = read(file_of(emitter("a", down) + emitter("b", down)));
    ASSERT_TRUE(result.photometry);
    EXPECT_EQ(result.photometry->candela, (std::vector<double>{200.0, 80.0}));
    EXPECT_EQ(result.photometry->input_watts, 20.0);
    ASSERT_EQ(result.findings.size(), 1U);
    EXPECT_EQ(to_text(result.findings[0]), "lamp.xml:2: Emitter: warning: the intensities of 2 emitters are added");
}

TEST(Tm33Emitters, emitters_with_angles_of_their_own_are_added_without_an_error_in_any_direction) {
    const LuminaireFileRead both =
        read(file_of(emitter("a", down) + emitter("b", all_around) + emitter("c", quadrant)));
    ASSERT_TRUE(both.photometry);
    const Photometry a = *read(file_of(emitter("a", down))).photometry;
    const Photometry b = *read(file_of(emitter("b", all_around))).photometry;
    const Photometry c = *read(file_of(emitter("c", quadrant))).photometry;
    for (const double plane : {0.0, 17.0, 90.0, 133.0, 271.5}) {
        for (const double gamma : {1.0, 30.0, 59.0, 61.0, 89.9, 90.1, 135.0, 179.0}) {
            const Vec3 towards = photometric_direction(PhotometricType::C, {plane, gamma});
            // the poles are taken a ten-millionth of a degree aside
            const double sum = intensity(a, towards).value + intensity(b, towards).value + intensity(c, towards).value;
            EXPECT_NEAR(intensity(*both.photometry, towards).value, sum, 1e-6) << plane << ' ' << gamma;
        }
    }
    const double flux = luminous_flux(a).value + luminous_flux(b).value + luminous_flux(c).value;
    // the step at the horizontal is a thousandth of a degree wide: 40 cd, 2 pi sr, 1.7e-5 / 2
    EXPECT_NEAR(luminous_flux(*both.photometry).value, flux, 40.0 * 6.3 * 1e-5);
}

TEST(Tm33Emitters, emitters_of_unknown_flux_are_luminaires_of_their_own) {
    const std::string unknown = "<AbsolutePhotometry>false</AbsolutePhotometry>" + down;
    const std::string text = file_of(emitter("up", down) + emitter("", unknown));
    EXPECT_FALSE(read(text).photometry);
    const LuminaireTextRead result = read_luminaire_texts(text, "lamp.xml");
    ASSERT_EQ(result.photometries.size(), 2U);
    EXPECT_EQ(result.photometries[0].name, " / up");
    EXPECT_EQ(result.photometries[1].name, " / emitter 2");
}

TEST(Tm33Emitters, emitters_of_radiant_flux_alone_are_left_out_of_the_sum) {
    const std::string radiant =
        "<Emitter><RadiantData><RadiantIntensity>" + down + "</RadiantIntensity></RadiantData></Emitter>";
    const LuminaireFileRead result = read(file_of(emitter("a", down) + radiant));
    ASSERT_TRUE(result.photometry);
    EXPECT_EQ(result.photometry->candela, (std::vector<double>{100.0, 40.0}));
    EXPECT_EQ(result.findings.size(), 1U);
}

MeasuredOpeningSize opening_of(const std::string& areas, const std::string& goniometer = "IES_C") {
    const std::string more = "<EmissionAreas>" + areas + "</EmissionAreas>";
    const LuminaireFileRead result = read(file_of(emitter("a", down, more), goniometer));
    return result.photometry ? result.photometry->opening : MeasuredOpeningSize{OpeningShape::sphere};
}

std::string area(const std::string& face, const std::string& fields) {
    return "<" + face + "Face><" + face + "Area>" + fields + "</" + face + "Area></" + face + "Face>";
}

TEST(Tm33Emitters, emission_areas_are_the_opening) {
    const std::string panel = area("Bottom", "<Length>1.2</Length><Width>0.3</Width>");
    const std::string disc = area("Bottom", "<Length>0.2</Length><Width>0.2</Width><Circular>true</Circular>");
    EXPECT_EQ(opening_of(panel), (MeasuredOpeningSize{OpeningShape::rectangle, 1.2, 0.3, 0.0}));
    EXPECT_EQ(opening_of(panel, "CIE _ C"), (MeasuredOpeningSize{OpeningShape::rectangle, 0.3, 1.2, 0.0}));
    EXPECT_EQ(opening_of(disc), (MeasuredOpeningSize{OpeningShape::circle, 0.2, 0.2, 0.0}));
    const std::string sides = area("C0", "<Length>1.2</Length><Height>0.05</Height>") +
                              area("C270", "<Width>0.3</Width><Height>0.02</Height>");
    EXPECT_EQ(opening_of(panel + sides),
              (MeasuredOpeningSize{OpeningShape::box, 1.2, 0.3, 0.05, {{0.05, 0.0, 0.0, 0.02}}}));
    EXPECT_EQ(opening_of(area("C0", "<Length>1.2</Length><Height>0.05</Height>")).shape, OpeningShape::point);
}

TEST(Tm33Emitters, several_areas_of_a_face_are_one_rectangle_around_them) {
    const std::string halves =
        "<BottomFace><BottomArea><Length>0.5</Length><Width>0.6</Width><LengthOffset>-0.3</LengthOffset></BottomArea>"
        "<BottomArea><Length>0.5</Length><Width>0.6</Width><LengthOffset>0.3</LengthOffset></BottomArea></BottomFace>";
    const MeasuredOpeningSize opening = opening_of(halves);
    EXPECT_EQ(opening.shape, OpeningShape::rectangle);
    EXPECT_NEAR(opening.extent_0, 1.1, 1e-12);
    EXPECT_NEAR(opening.extent_90, 0.6, 1e-12);
}

TEST(Tm33Emitters, the_roots_of_older_and_of_generated_files_are_known) {
    EXPECT_TRUE(read(file_of(emitter("a", down), "IES_C", "ATLA_S001_A")).photometry);
    const std::string generated =
        "<LuminaireOpticalData version='1.0'><Emitter><IntensityDistribution><Metric>Luminous</Metric>"
        "<IntensityData horz='0' vert='0'>9</IntensityData><IntensityData horz='0' vert='90'>5</IntensityData>"
        "</IntensityDistribution></Emitter></LuminaireOpticalData>";
    ASSERT_TRUE(read(generated).photometry);
    EXPECT_EQ(read(generated).photometry->candela, (std::vector<double>{9.0, 5.0}));
    EXPECT_FALSE(read(replaced(generated, "Luminous<", "Radiant<")).photometry);
}

TEST(Tm33Emitters, a_symmetry_that_the_planes_contradict_is_told) {
    for (const char* word : {"Symm_Full", "Symm _ Full", ""})
        EXPECT_TRUE(read(file_of(emitter("a", "<Symm>" + std::string{word} + "</Symm>" + down))).findings.empty())
            << word;
    EXPECT_EQ(read(file_of(emitter("a", "<Symm>Symm_Quad</Symm>" + down))).findings.size(), 1U);
    EXPECT_TRUE(read(file_of(emitter("a", "<Symm>Symm_Quad</Symm>" + quadrant))).findings.empty());
}

}  // namespace
}  // namespace hanei
