#include "engine/project/luminaire_file.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <string>

namespace hanei {
namespace {

const std::string intensity_of_a_small_lamp =
    "<LuminousIntensity><AbsolutePhotometry>true</AbsolutePhotometry>\n"
    "<IntData h=\"0\" v=\"0\">100</IntData>\n"
    "<IntData h=\"0\" v=\"90\">7</IntData>\n"
    "</LuminousIntensity>";

/// The intensities stand from line 4 on.
std::string file_with(const std::string& intensity, const std::string& description = "lamp") {
    return "<?xml version=\"1.0\"?>\n<IESTM33-22><Version>1.1</Version><Header><Description>" + description +
           "</Description></Header>\n<Emitter><Quantity>1</Quantity><InputWattage>10</InputWattage><LuminousData>\n" +
           intensity + "\n</LuminousData></Emitter></IESTM33-22>\n";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

LuminaireFileRead read(const std::string& text) { return read_luminaire_text(text, "lamp.xml"); }

/// Everything that is said of a file that is refused.
std::string refusal(const std::string& text) {
    const LuminaireFileRead result = read(text);
    EXPECT_FALSE(result.photometry);
    return result.findings.empty() ? "" : to_text(result.findings.back());
}

std::string description_of(const std::string& written) {
    const LuminaireFileRead result = read(file_with(intensity_of_a_small_lamp, written));
    return result.photometry ? result.photometry->name : "refused: " + to_text(result.findings.back());
}

TEST(Tm33File, says_what_it_holds) {
    const LuminaireFileRead result = read(file_with(intensity_of_a_small_lamp));
    ASSERT_TRUE(result.photometry);
    EXPECT_TRUE(result.findings.empty());
    EXPECT_EQ(result.photometry->format, "TM-33 1.1");
    EXPECT_EQ(result.photometry->name, "lamp");
    EXPECT_EQ(result.photometry->input_watts, 10.0);
    EXPECT_EQ(result.photometry->vertical_deg, (std::vector<double>{0.0, 90.0}));
    EXPECT_EQ(result.photometry->candela, (std::vector<double>{100.0, 7.0}));
}

TEST(Tm33File, texts_may_hold_the_references_of_xml_itself) {
    EXPECT_EQ(description_of("5 &lt; 6 &amp; &#x3b1;&#946;"), "5 < 6 & \xCE\xB1\xCE\xB2");
    EXPECT_EQ(description_of("<![CDATA[R&D]]>"), "R&D");
    EXPECT_EQ(description_of("a<!-- R&D -->b"), "ab");
}

TEST(Tm33File, texts_that_are_not_utf_8_are_read_as_latin_1) { EXPECT_EQ(description_of("caf\xE9"), "caf\xC3\xA9"); }

TEST(Tm33File, a_figure_parted_by_a_comment_is_read_whole) {
    const LuminaireFileRead result = read(file_with(replaced(intensity_of_a_small_lamp, "100", "1<!-- -->00")));
    ASSERT_TRUE(result.photometry);
    EXPECT_EQ(result.photometry->candela[0], 100.0);
    EXPECT_EQ(refusal(file_with(replaced(intensity_of_a_small_lamp, "100", "1<!-- --> <!-- -->00"))),
              "lamp.xml:5: IntData: \"1 00\" is no number; a plain decimal number is needed");
}

TEST(Tm33File, lines_are_counted_whatever_ends_them) {
    const std::string text = file_with(replaced(intensity_of_a_small_lamp, "7", "seven"));
    const std::string said = "lamp.xml:6: IntData: \"seven\" is no number; a plain decimal number is needed";
    std::string old_mac = text;
    std::replace(old_mac.begin(), old_mac.end(), '\n', '\r');
    std::string dos;
    for (const char c : text) dos += c == '\n' ? "\r\n" : std::string{c};
    EXPECT_EQ(refusal(text), said);
    EXPECT_EQ(refusal(old_mac), said);
    EXPECT_EQ(refusal(dos), said);
}

TEST(Tm33File, document_types_and_entities_are_refused) {
    const std::string text = file_with(intensity_of_a_small_lamp);
    const std::string said = "DOCTYPE: document types and entities are not allowed";
    EXPECT_EQ(refusal(replaced(text, "\n", "\n\n<!DOCTYPE x [<!ENTITY a \"b\">]>")), "lamp.xml:3: " + said);
    EXPECT_EQ(refusal(replaced(text, "\n", "\n<!DOCTYPE x [<!ENTITY a ")), "lamp.xml:2: " + said);
    EXPECT_EQ(refusal(file_with("<!DOCTYPE x>" + intensity_of_a_small_lamp)), "lamp.xml:4: " + said);
    for (const char* reference : {"&own;", "&", "&#0;", "&#4294967296;", "&#x110000;", "&#;", "&#x;"}) {
        const std::string described = description_of(std::string{"lamp "} + reference);
        EXPECT_TRUE(described.starts_with("refused: lamp.xml:2: xml: ")) << reference << described;
    }
    EXPECT_EQ(refusal(file_with(replaced(intensity_of_a_small_lamp, "h=\"0\"", "h=\"&zero;\""))),
              "lamp.xml:5: xml: \"&zero;\": entities of a file's own are not allowed");
}

TEST(Tm33File, one_that_is_not_well_formed_is_refused_where_it_breaks) {
    const std::string text = file_with(intensity_of_a_small_lamp);
    EXPECT_EQ(refusal(replaced(text, "</LuminousIntensity>", "</Luminous>")),
              "lamp.xml:7: xml: \"</Luminous>\": the end tag of an open element is missing here");
    EXPECT_EQ(refusal(replaced(text, "v=\"0\"", "v=0")),
              "lamp.xml:5: xml: \"<IntData h=\"0\" v=0>\": an attribute is a name, =, and a value in quotes");
    EXPECT_EQ(refusal(replaced(text, "v=\"0\"", "h=\"0\"")), "lamp.xml:5: xml: the attribute \"h\" stands twice");
    EXPECT_EQ(refusal(text.substr(0, text.find("7<"))),
              "lamp.xml:6: xml: \"<IntData h=\"0\" v=\"90\">\": the end tag of an open element is missing here");
    EXPECT_EQ(refusal(text + "<IESTM33-22/>"), "lamp.xml:9: root: a second root element; a file has one");
    EXPECT_EQ(refusal("<?xml"), "lamp.xml:1: xml: \"<?xml\": the instruction does not end");
    EXPECT_EQ(refusal("<?xml version=\"1.0\"?>"),
              "lamp.xml:1: xml: \"<?xml version=\"1.0\"?>\": the file holds no element");
}

TEST(Tm33File, depth_and_names_without_bounds_are_refused) {
    constexpr int depth = 200'000;  // a recursive reader's stack would overflow
    std::string begin, end;
    for (int k = 0; k < depth; ++k) {
        begin += "<a>";
        end += "</a>";
    }
    const std::string said = "lamp.xml:4: nesting: elements stand more than 64 deep in one another";
    EXPECT_EQ(refusal(file_with(begin + end)), said);
    EXPECT_EQ(refusal(file_with(begin)), said);
    const std::string name(200, 'n');
    EXPECT_NE(refusal(file_with("<" + name + "/>")).find("a name has 128 bytes at most"), std::string::npos);
}

TEST(Tm33File, another_kind_of_document_is_told_by_its_root) {
    EXPECT_EQ(refusal("<?xml version=\"1.0\"?>\n<html/>"),
              "lamp.xml:2: root: \"<html>\" found; TM-33 files begin with <IESTM33>");
}

TEST(Tm33File, radiant_and_photon_figures_are_never_candela) {
    for (const std::string quantity : {"Photon", "Radiant"}) {
        std::string text = file_with(intensity_of_a_small_lamp);
        for (const char* part : {"<Luminous", "</Luminous"}) {
            const std::string other = std::string{part}.substr(0, std::string{part}.find('L')) + quantity;
            text = replaced(replaced(text, std::string{part} + "Data", other + "Data"), std::string{part} + "Intensity",
                            other + "Intensity");
        }
        EXPECT_EQ(refusal(text),
                  "lamp.xml:2: LuminousData: the file holds radiant or photon intensity, no luminous intensity");
    }
}

TEST(Tm33File, relative_figures_are_scaled_by_the_rated_lumens_with_a_warning) {
    const std::string rated = "<InputWattage>10</InputWattage><RatedLumens>2500</RatedLumens>";
    for (const char* no : {"false", "0", " false "}) {
        const std::string relative = file_with(replaced(intensity_of_a_small_lamp, "true", no));
        const LuminaireFileRead result = read(replaced(relative, "<InputWattage>10</InputWattage>", rated));
        ASSERT_TRUE(result.photometry);
        EXPECT_EQ(result.photometry->candela, (std::vector<double>{250.0, 17.5}));
        EXPECT_FALSE(result.photometry->absolute);
        EXPECT_EQ(result.photometry->lamp_lumens, 2500.0);
        EXPECT_EQ(result.findings.size(), 1U);
        EXPECT_EQ(read(relative).photometry->candela, (std::vector<double>{100.0, 7.0}));
        EXPECT_EQ(read(relative).findings.size(), 1U);
    }
    EXPECT_TRUE(read(file_with(replaced(intensity_of_a_small_lamp, "true", "1"))).findings.empty());
}

TEST(Tm33File, relative_figures_of_more_than_a_thousand_lumens_are_candela_already) {
    std::string text = file_with(replaced(replaced(intensity_of_a_small_lamp, "true", "false"), ">7<", ">700<"));
    text = replaced(text, "<InputWattage>10</InputWattage>", "<RatedLumens>2500</RatedLumens>");
    EXPECT_EQ(read(text).photometry->candela, (std::vector<double>{100.0, 700.0}));
    EXPECT_EQ(read(text).photometry->lamp_lumens, 2500.0);
}

TEST(Tm33File, damaged_bytes_are_refused_or_read_and_never_more) {
    const std::string text = file_with(intensity_of_a_small_lamp, "<![CDATA[a]]>&amp;<!-- b -->");
    std::mt19937 dice{33};
    for (int trial = 0; trial < 20'000; ++trial) {
        std::string damaged = text;
        for (unsigned hits = 1 + dice() % 4; hits > 0; --hits) {
            const std::size_t place = dice() % damaged.size();
            if (dice() % 3 == 0)
                damaged.erase(place, 1 + dice() % 9);
            else
                damaged[place] = dice() % 2 == 0 ? "<>&;/!?\"'= -[]"[dice() % 14] : static_cast<char>(dice() % 256);
            if (damaged.empty()) break;
        }
        const LuminaireFileRead result = read(damaged);
        ASSERT_NE(result.photometry.has_value(), has_errors(result.findings)) << damaged;
    }
}

}  // namespace
}  // namespace hanei
