/// The gallery of hard cases gives what its table says.
#include "app/hard_cases.h"
#include "engine/project/project_file.h"
#include "engine/project/text_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <set>

namespace hanei {
namespace {

const std::filesystem::path folder = std::filesystem::path{HANEI_SOURCE} / "assets/rooms/hard";

std::vector<HardCase> cases() {
    Diagnostics findings;
    std::vector<HardCase> read = read_hard_cases(folder, findings);
    for (const Diagnostic& finding : findings) ADD_FAILURE() << to_text(finding);
    return read;
}

/// Else the case would not be hard.
bool is_off(const HardOutcome::Figure& figure) {
    return figure.naive && !(std::abs(*figure.naive - figure.wanted.expected) <= figure.wanted.tolerance);
}

TEST(HardGallery, comes_out_as_its_table_says_where_naive_methods_fail) {
    std::ptrdiff_t naive = 0;
    for (const HardCase& wanted : cases()) {
        const HardOutcome outcome = solve_hard_case(folder, wanted);
        for (const std::string& fault : outcome.faults) ADD_FAILURE() << wanted.file << ": " << fault;
        EXPECT_FALSE(outcome.findings.empty()) << wanted.file << ": nobody is told what is hard in it";
        const auto& figures = outcome.figures;
        const auto stated =
            std::count_if(figures.begin(), figures.end(), [](const auto& figure) { return figure.naive.has_value(); });
        EXPECT_TRUE(stated == 0 || std::any_of(figures.begin(), figures.end(), is_off)) << wanted.file;
        naive += stated;
    }
    EXPECT_GE(naive, 100);
}

TEST(HardGallery, says_of_every_case_why_it_is_hard_and_of_every_file_what_is_right) {
    std::set<std::string> named;
    for (const HardCase& wanted : cases()) {
        EXPECT_FALSE(wanted.title.empty() || wanted.why.empty() || wanted.naive.empty()) << wanted.file;
        EXPECT_TRUE(named.insert(wanted.file).second) << wanted.file;
        EXPECT_TRUE(std::filesystem::exists(folder / wanted.file)) << wanted.file;
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        EXPECT_TRUE(entry.path().extension() != ".hanei" || named.count(name) == 1) << name;
    }
}

/// What breaks lighting programs. Whoever takes a file away has to say here what covers its kind instead.
TEST(HardGallery, covers_every_kind_of_hard_thing_that_is_known) {
    const std::set<std::string> known{"thin wall",
                                      "wall without thickness",
                                      "coplanar faces",
                                      "duplicate faces",
                                      "touching boxes",
                                      "two boxes that share an edge only",
                                      "solids that share space",
                                      "solid through a wall",
                                      "luminaire flush with ceiling",
                                      "luminaire above the ceiling",
                                      "luminaire partly inside furniture",
                                      "luminaire wholly inside furniture",
                                      "luminaire behind a luminaire",
                                      "luminaire with a hole",
                                      "touching luminaires",
                                      "zero-area light",
                                      "zero-area face",
                                      "sliver",
                                      "corridor of 1 km by 1 mm",
                                      "sharp corner",
                                      "far from the origin",
                                      "millimetre scale",
                                      "kilometre scale",
                                      "reflectance 1, closed",
                                      "reflectance 1, open",
                                      "reflectance 0.99",
                                      "reflectance 0 everywhere",
                                      "furnace",
                                      "room that is not closed",
                                      "reversed normals",
                                      "not-a-number or infinity in the input",
                                      "thin sticks",
                                      "a thousand thin sticks",
                                      "point on edge or vertex",
                                      "point in the corner of three walls",
                                      "point in the plane of a source",
                                      "point close to a source",
                                      "point inside a solid",
                                      "grazing",
                                      "source below the horizon in part",
                                      "edge of a hard shadow",
                                      "lamp on the line of an edge",
                                      "concave plan",
                                      "window flush with a corner",
                                      "narrow beam",
                                      "line source",
                                      "polyhedral source",
                                      "no light",
                                      "gap between boxes"};
    const std::set<std::string> of_reference{"P-B5",  "P-B6", "P-B7", "P-B8", "P-B9",
                                             "P-B10", "P-C2", "P-D2", "P-E6", "P-E7"};
    std::set<std::string> covered;
    for (const HardCase& wanted : cases()) covered.insert(wanted.covers.begin(), wanted.covers.end());
    for (const auto* list : {&known, &of_reference})
        for (const std::string& kind : *list) EXPECT_EQ(covered.count(kind), 1U) << kind;
}

TEST(HardGallery, tells_a_case_in_one_line_of_its_table) {
    HardCase wanted;
    wanted.file = "thin.hanei";
    wanted.covers = {"thin wall", "gap"};
    HardOutcome outcome;
    EXPECT_EQ(row_of(wanted, outcome).substr(0, 5), "told ");
    outcome.figures = {{{"p", true, 2.0, 0.1}, 2.5, 0.25, 5.0}, {{"q", true, 1.0, 0.1}, 1.0, 0.0, std::nullopt}};
    const std::string row = row_of(wanted, outcome);
    EXPECT_EQ(row.substr(0, 6), "right ");
    for (const char* part : {"thin.hanei", "5.0e-01", "2.5e-01", "3.0e+00", "thin wall, gap\n"})
        EXPECT_NE(row.find(part), std::string::npos) << row;
    outcome.faults = {"it is off"};
    EXPECT_EQ(row_of(wanted, outcome).substr(0, 5), "WRONG");
}

TEST(HardGallery, every_project_can_be_looked_at_and_is_saved_as_the_same_text) {
    for (const HardCase& wanted : cases()) {
        const ProjectRead read = read_project(folder / wanted.file);
        if (!read.project) continue;
        EXPECT_EQ(read.project->scene.title, wanted.title);
        EXPECT_FALSE(read.project->scene.views.empty()) << wanted.file;
        EXPECT_FALSE(read.project->scene.points.empty()) << wanted.file;
        Diagnostics none;
        if (!read.findings.empty()) continue;  // what was mended on the way in is written mended
        EXPECT_EQ(project_text(*read.project), read_text_file(folder / wanted.file, none).value_or("")) << wanted.file;
    }
}

}  // namespace
}  // namespace hanei
