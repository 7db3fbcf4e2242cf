#include "engine/report/validation_report.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace hanei {
namespace {

Validation table() {
    Validation validation{"9.9", "2030-01-02", "linear", 1, 1.25, {}};
    validation.rows.push_back({"A", "Something, \"quoted\"", "closed form", 3, 1e-4, 1e-3, 5e-5, 0.5, Grade::top});
    validation.rows.push_back({"B", "Something else", "own reference", 4, 2e-4, 1e-3, 5e-5, 0.5, Grade::pass});
    return validation;
}

TEST(ValidationReport, the_verdict_names_who_signs_and_how_many_cases_hold) {
    EXPECT_EQ(verdict_line(table()),
              "Hanei 9.9, 2030-01-02, method linear, 1 thread: all 2 cases hold (7 points, 1.2 s)");
    EXPECT_TRUE(table().holds());
}

TEST(ValidationReport, one_case_that_fails_or_cannot_be_computed_spoils_the_verdict) {
    for (const Grade grade : {Grade::fail, Grade::unsupported}) {
        Validation validation = table();
        validation.rows[0].grade = grade;
        validation.rows[0].fault = "worst: point 3";
        EXPECT_FALSE(validation.holds());
        EXPECT_NE(verdict_line(validation).find("1 of 2 cases fail"), std::string::npos) << verdict_line(validation);
        EXPECT_NE(validation_text(validation).find("\n    worst: point 3\n"), std::string::npos);
    }
}

TEST(ValidationReport, a_table_of_no_cases_proves_nothing) { EXPECT_FALSE(Validation{}.holds()); }

TEST(ValidationReport, the_csv_has_a_row_a_case_and_quotes_what_needs_it) {
    const std::string csv = validation_csv(table());
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
    EXPECT_NE(csv.find("A,\"Something, \"\"quoted\"\"\",closed form,3,0.0001,0.001,5e-05,top"), std::string::npos)
        << csv;
}

}  // namespace
}  // namespace hanei
