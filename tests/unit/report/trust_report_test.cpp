#include "engine/report/trust_report.h"

#include "tests/box_room.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace hanei {
namespace {

const TrustReport& report() {
    static const TrustReport made = [] {
        Settings settings;
        settings.max_patch = 0.8;
        settings.threads = 1;
        return *trust_in(std::make_shared<const Scene>(test::small_office()), settings, Work{});
    }();
    return made;
}

bool says(const TrustReport& of, const std::string& words) { return trust_text(of).find(words) != std::string::npos; }

TEST(TrustReport, says_of_every_check_what_must_hold_what_was_found_and_what_is_allowed) {
    const auto rows = trust_rows(report());
    ASSERT_EQ(rows.size(), static_cast<std::size_t>(TrustReport::checks));
    for (const TrustRow& row : rows) {
        EXPECT_STRNE(row.must, "") << row.name;
        EXPECT_FALSE(row.found.english().empty()) << row.name;
        EXPECT_FALSE(row.allowed.english().empty()) << row.name;
        EXPECT_EQ(row.state, TrustState::holds) << row.name;
        EXPECT_TRUE(row.advice.english().empty()) << row.name;
    }
    EXPECT_EQ(trust_verdict(report()).english(), "All 6 checks hold.");
    EXPECT_TRUE(says(report(), "7200 lm emitted"));
}

TEST(TrustReport, tells_what_to_do_about_each_that_fails) {
    TrustReport bad = report();
    bad.direct.arrived -= 500.0;
    bad.direct.worst = report().solution->scene->luminaires.front().id;
    bad.energy.energy.absorbed *= 0.5;
    bad.reciprocity.pairs.front().back *= 2.0;
    bad.closure.misplaced = 0.9;
    bad.additivity.within = 0;
    bad.threads.others = 3;
    for (const TrustRow& row : trust_rows(bad)) {
        EXPECT_EQ(row.state, TrustState::fails) << row.name;
        EXPECT_FALSE(row.advice.english().empty()) << row.name;
    }
    EXPECT_EQ(trust_verdict(bad).english(), "6 of 6 checks fail.");
    EXPECT_FALSE(nlohmann::json::parse(trust_json(bad))["holds"].get<bool>());
}

TEST(TrustReport, names_the_bounces_when_they_left_light_on_its_way) {
    EXPECT_FALSE(says(report(), "stopped after"));
    TrustReport stopped = report();
    stopped.energy.converged = false;
    stopped.energy.bounces = 4;
    stopped.energy.under_way = 301.0;
    EXPECT_TRUE(says(stopped, "stopped after 4, as set"));
    EXPECT_TRUE(says(stopped, "301 on their way"));
}

TEST(TrustReport, shows_those_that_are_done) {
    TrustReport early = report();
    early.done = 2;
    EXPECT_EQ(trust_rows(early).size(), 2U);
}

TEST(TrustReport, is_read_by_programs_by_the_names_of_its_checks) {
    const auto json = nlohmann::json::parse(trust_json(report()));
    EXPECT_TRUE(json["holds"].get<bool>());
    for (const char* check : {"direct", "energy", "reciprocity", "closure", "additivity", "threads"}) {
        EXPECT_EQ(json["checks"][check]["state"], "holds") << check;
        EXPECT_LE(json["checks"][check]["found"].get<double>(), json["checks"][check]["allowed"].get<double>());
    }
    EXPECT_NEAR(json["checks"]["energy"]["emitted_lm"].get<double>(), 7200.0, 1e-6);
}

}  // namespace
}  // namespace hanei
