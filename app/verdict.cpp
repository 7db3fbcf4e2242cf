#include "app/verdict.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace hanei {

namespace {

struct Spread {
    double mean = 0.0, p95 = 0.0, worst = 0.0;
};

Spread spread_of(std::vector<double> errors) {
    Spread spread;
    if (errors.empty()) return spread;
    std::sort(errors.begin(), errors.end());
    for (const double error : errors) spread.mean += error / static_cast<double>(errors.size());
    spread.p95 = errors[std::min(errors.size() - 1, errors.size() * 95 / 100)];
    spread.worst = errors.back();
    return spread;
}

std::map<std::string, std::vector<double>> errors_by_set(const CaseVerdict& verdict) {
    std::map<std::string, std::vector<double>> sets;
    for (const Judged& judged : verdict.judged) sets[judged.set].push_back(judged.relative_error());
    return sets;
}

int count_grade(const CaseVerdict& verdict, Grade grade) {
    return static_cast<int>(std::count_if(verdict.judged.begin(), verdict.judged.end(),
                                          [&](const Judged& judged) { return judged.grade() == grade; }));
}

}  // namespace

double Judged::relative_error() const {
    const double error = std::abs(got - expected);
    if (error == 0.0) return 0.0;
    return expected != 0.0 ? error / std::abs(expected) : error;
}

Grade Judged::grade() const {
    const double error = std::abs(got - expected);  // not a number fails both
    if (error <= allowed_top) return Grade::top;
    if (error <= allowed_pass) return Grade::pass;
    return Grade::fail;
}

Judged judge(std::string id, std::string set, double expected, double got, double uncertainty,
             const ReferenceGrade& top, const ReferenceGrade& pass) {
    const auto allowed = [&](const ReferenceGrade& grade) {
        const double tolerance = std::max(grade.relative * std::abs(expected), grade.absolute);
        return set.empty() ? std::max(tolerance, 2.0 * uncertainty) : tolerance + uncertainty;
    };
    return {std::move(id), set, expected, got, allowed(top), allowed(pass), uncertainty};
}

Grade CaseVerdict::grade() const {
    if (!unsupported.empty()) return Grade::unsupported;
    Grade worst = Grade::top;
    for (const Judged& point : judged) worst = std::max(worst, point.grade());
    return worst;
}

std::string line_of(const CaseVerdict& verdict) {
    if (!verdict.unsupported.empty()) return fmt::format("{:<28} unsupported: {}\n", verdict.id, verdict.unsupported);
    std::vector<double> errors;
    const Judged* worst = nullptr;
    for (const Judged& judged : verdict.judged) {
        errors.push_back(judged.relative_error());
        if (judged.grade() == Grade::fail && (!worst || judged.relative_error() > worst->relative_error()))
            worst = &judged;
    }
    const Spread all = spread_of(errors);
    std::string text = fmt::format("{:<28} {:>4} points  mean {:>8.2e}  worst {:>8.2e}  {:>6} patches {:>7.2f} s  {}\n",
                                   verdict.id, verdict.judged.size(), all.mean, all.worst, verdict.patches,
                                   verdict.seconds, name_of(verdict.grade()));
    if (worst)
        text += fmt::format("    worst: {}: expected {:.9g}, got {:.9g}, allowed +- {:.2g}\n", worst->id,
                            worst->expected, worst->got, worst->allowed_pass);
    for (const auto& [set, set_errors] : errors_by_set(verdict)) {
        if (set.empty()) continue;
        const Spread spread = spread_of(set_errors);
        text += fmt::format("    {:<12} {:>4} points  mean {:.3f} %  p95 {:.3f} %  max {:.2f} %\n", set,
                            set_errors.size(), 100 * spread.mean, 100 * spread.p95, 100 * spread.worst);
    }
    return text;
}

ValidationRow row_of(const CaseVerdict& verdict, const std::string& proves, const std::string& source) {
    ValidationRow row{verdict.id, proves, source, verdict.judged.size()};
    row.seconds = verdict.seconds;
    row.grade = verdict.grade();
    row.fault = verdict.unsupported;
    double greatest = 0.0, most_used = -1.0;
    for (const Judged& judged : verdict.judged) greatest = std::max(greatest, std::abs(judged.expected));
    for (const Judged& judged : verdict.judged) {
        const double error = std::abs(judged.got - judged.expected);
        const double whole = std::max(std::abs(judged.expected), greatest / 1000.0);
        const double share = whole > 0.0 ? error / whole : error;
        row.mean += share / static_cast<double>(row.points);
        const double used = std::isnan(error) ? HUGE_VAL : error == 0.0 ? 0.0 : error / judged.allowed_pass;
        if (used <= most_used) continue;
        most_used = used;
        row.worst = share;
        row.allowed = whole > 0.0 ? judged.allowed_pass / whole : judged.allowed_pass;
        if (judged.grade() == Grade::fail)
            row.fault = fmt::format("worst: {}: expected {:.9g}, got {:.9g}, allowed +- {:.2g}", judged.id,
                                    judged.expected, judged.got, judged.allowed_pass);
    }
    return row;
}

std::string error_bars_text(const std::vector<CaseVerdict>& verdicts) {
    std::size_t said = 0, held = 0;
    std::vector<double> over_error;
    for (const CaseVerdict& verdict : verdicts) {
        for (const Judged& judged : verdict.judged) {
            if (judged.error_bar < 0.0) continue;
            const double error = std::abs(judged.got - judged.expected);
            ++said;
            held += error <= judged.error_bar + judged.uncertainty;
            if (error > judged.uncertainty) over_error.push_back(judged.error_bar / error);
        }
    }
    if (said == 0) return {};
    std::string text = fmt::format("error bars hold at {} of {} points ({:.1f} %)", held, said,
                                   100.0 * static_cast<double>(held) / static_cast<double>(said));
    if (!over_error.empty()) {
        const auto middle = over_error.begin() + static_cast<std::ptrdiff_t>(over_error.size() / 2);
        std::nth_element(over_error.begin(), middle, over_error.end());
        text += fmt::format("; in the median they are {:.3g} times the error", *middle);
    }
    return text + '\n';
}

std::string categories_text(const std::vector<CaseVerdict>& verdicts) {
    struct Count {
        int cases = 0, top = 0, pass = 0, unsupported = 0;
        int points = 0, points_top = 0, points_pass = 0;
    };
    std::map<std::string, Count> categories;
    int passed = 0;
    for (const CaseVerdict& verdict : verdicts) {
        const Grade grade = verdict.grade();
        const bool good = grade == Grade::top || grade == Grade::pass;
        Count& count = categories[verdict.category];
        ++count.cases;
        count.top += grade == Grade::top;
        count.pass += good;
        count.unsupported += grade == Grade::unsupported;
        count.points += static_cast<int>(verdict.judged.size());
        count.points_top += count_grade(verdict, Grade::top);
        count.points_pass += count_grade(verdict, Grade::top) + count_grade(verdict, Grade::pass);
        passed += good;
    }
    std::string text = fmt::format("\n{:<44} {:>6} {:>6} {:>6} {:>12} {:>9} {:>10} {:>10}\n", "category", "cases",
                                   "pass", "top", "unsupported", "points", "pass", "top");
    for (const auto& [category, count] : categories)
        text += fmt::format("{:<44} {:>6} {:>6} {:>6} {:>12} {:>9} {:>10} {:>10}\n", category, count.cases, count.pass,
                            count.top, count.unsupported, count.points, count.points_pass, count.points_top);
    return text + fmt::format("{} passed, {} failed\n", passed, static_cast<int>(verdicts.size()) - passed);
}

}  // namespace hanei
