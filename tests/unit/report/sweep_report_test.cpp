#include "engine/report/sweep_report.h"

#include "engine/report/label_places.h"
#include "engine/report/sweep_look.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

SweepPoint run(Method method, double ms, std::vector<SweepErrors> errors) {
    SweepPoint point;
    point.settings.method = method;
    point.unknowns = 100;
    point.milliseconds = ms;
    point.predicted = {2.0 * ms, 0.05, 0, false};
    point.errors = std::move(errors);
    return point;
}

Sweep two_runs() {
    Sweep sweep;
    sweep.against = "the expected values of <S2>";
    sweep.uncertainty = {"all", 0.001, 0.002, 0.003, 0.5, 1.0, 2.0};
    sweep.uncertainty_words = "as the case states it";
    sweep.budget_s = 60.0;
    sweep.points.push_back(run(
        Method::paper, 12.0, {{"all", 0.1, 0.2, 30.0, 1.0, 2.0, 3.0}, {"floor, left", 0.1, 0.2, 0.3, 1.0, 2.0, 3.0}}));
    sweep.points.push_back(run(Method::patch, 14.0, {{"all", 0.01, 0.02, 0.03}, {"floor, left", 0.0, 0.0, 0.0}}));
    sweep.points[0].marks.paper = true;
    sweep.points[1].marks.preset = Preset::design;
    sweep.points[1].marks.current = true;
    sweep.points[1].on_frontier = true;
    sweep.left_out.push_back({sweep.points[0].settings, false, 75e3});
    return sweep;
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(SweepReport, is_one_line_a_run_and_set_of_points) {
    const std::string csv = sweep_csv(two_runs());
    EXPECT_EQ(count_of(csv, "\n"), 7U) << csv;
    EXPECT_NE(csv.find("run,paper,0.5,1000,yes,0.1,paper's-own,100,12.00,24.00,5,no,all,10,20,3000,1,2,3\n"),
              std::string::npos)
        << csv;
    EXPECT_NE(csv.find(",floor  left,"), std::string::npos) << "a comma in a name would begin a column";
    EXPECT_NE(csv.find("\nreference,the expected values of <S2>; uncertainty: as the case states it,"),
              std::string::npos);
    const std::size_t columns = count_of(csv.substr(0, csv.find('\n')), ",");
    for (std::size_t at = 0; at < csv.size(); at = csv.find('\n', at) + 1)
        EXPECT_EQ(count_of(csv.substr(at, csv.find('\n', at) - at), ","), columns) << csv.substr(at, 40);
}

TEST(SweepReport, says_predicted_against_found_and_what_was_left_out) {
    const std::string text = sweep_text(two_runs());
    EXPECT_NE(text.find("design   patch, 0.5 m"), std::string::npos) << text;
    EXPECT_NE(text.find("28 ms"), std::string::npos);
    EXPECT_NE(text.find("uncertain itself by 0.1 % on the mean"), std::string::npos) << text;
    EXPECT_NE(text.find("paper 0.5 m without shadows between surfaces (75 s)"), std::string::npos) << text;
    EXPECT_NE(text.find("(current)"), std::string::npos);
}

TEST(SweepReport, is_drawn_for_every_set_with_its_marks) {
    const std::string svg = sweep_svg(two_runs(), "a < b");
    EXPECT_NE(svg.find("a &lt; b"), std::string::npos);
    EXPECT_NE(svg.find("gainst the expected values of &lt;S2&gt;"), std::string::npos);
    EXPECT_NE(svg.find(">current setting, design<"), std::string::npos);
    EXPECT_NE(svg.find(">the paper&#39;s own<"), std::string::npos);
    EXPECT_NE(svg.find("prefers-color-scheme: dark"), std::string::npos);
    EXPECT_EQ(count_of(svg, "Greatest error"), 2U);
    EXPECT_EQ(count_of(svg, "nan"), 0U);
    EXPECT_EQ(count_of(svg, "inf"), 0U);
}

TEST(SweepReport, of_nothing_is_a_sentence) {
    EXPECT_EQ(count_of(sweep_svg({}, "nothing"), "nan"), 0U);
    EXPECT_NE(sweep_svg({}, "nothing").find("No run was finished."), std::string::npos);
    EXPECT_EQ(count_of(sweep_csv({}), "\n"), 1U);
}

TEST(SweepReport, figures_have_the_digits_that_matter) {
    EXPECT_EQ(time_text(0.42), "0.4 ms");
    EXPECT_EQ(time_text(42.4), "42 ms");
    EXPECT_EQ(time_text(1340.0), "1.3 s");
    EXPECT_EQ(time_text(75e3), "75 s");
    EXPECT_EQ(time_text(900e3), "15 min");
    EXPECT_EQ(percent_text(0.0012), "0.12 %");
    EXPECT_EQ(percent_text(0.034), "3.4 %");
    EXPECT_EQ(percent_text(0.56), "56 %");
    EXPECT_EQ(percent_text(200.0), "> 1000 %");
}

TEST(SweepLook, methods_differ_by_colour_and_by_shape) {
    for (const Method a : methods) {
        for (const Method b : methods) {
            if (a == b) continue;
            EXPECT_NE(colour_of(a), colour_of(b));
            const auto first = marker_corners(a), second = marker_corners(b);
            EXPECT_FALSE(std::equal(first.begin(), first.end(), second.begin(), second.end()));
        }
    }
}

TEST(SweepLook, an_axis_keeps_everything_within_its_ends) {
    const LogAxis axis{1.0, 100.0, 10.0, 210.0};
    EXPECT_DOUBLE_EQ(axis.at(10.0), 110.0);
    EXPECT_DOUBLE_EQ(axis.at(1e9), 210.0);
    EXPECT_DOUBLE_EQ(axis.at(0.0), 10.0);
    EXPECT_DOUBLE_EQ(axis.at(-1.0), 10.0);
    EXPECT_EQ(axis.marks().size(), 3U) << "1, 10 and 100: there is no room for more";
}

TEST(LabelPlaces, labels_of_one_place_do_not_cover_each_other) {
    LabelPlaces places({0.0, 0.0, 400.0, 300.0});
    places.avoid(200.0, 150.0, 10.0);
    std::vector<LabelPlace> placed;
    for (int k = 0; k < 3; ++k) placed.push_back(places.place(200.0, 150.0, 80.0, 15.0));
    for (std::size_t a = 0; a < placed.size(); ++a) {
        EXPECT_GE(placed[a].left, 0.0);
        EXPECT_LE(placed[a].left + 80.0, 400.0);
        for (std::size_t b = 0; b < a; ++b) {
            const bool apart =
                std::abs(placed[a].left - placed[b].left) >= 79.0 || std::abs(placed[a].top - placed[b].top) >= 14.0;
            EXPECT_TRUE(apart) << a << " and " << b;
        }
    }
}

}  // namespace
}  // namespace hanei
