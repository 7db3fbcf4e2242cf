/// How a computed value stands against a reference.
#pragma once

#include "engine/project/reference_case.h"
#include "engine/report/validation_report.h"

#include <string>
#include <string_view>
#include <vector>

namespace hanei {

/// One expected value and what came out, in lx (form factors: of 1).
struct Judged {
    std::string id, set;
    double expected = 0.0, got = 0.0;
    double allowed_top = 0.0, allowed_pass = 0.0;  ///< absolute
    double uncertainty = 0.0;                      ///< of the expected value
    double error_bar = -1.0;                       ///< what we said the error is at most; negative where none is said
    double relative_error() const;                 ///< of the expected value; 0 when both are 0
    Grade grade() const;
};

/// |got - expected| <= max(relative * expected, absolute, 2 * uncertainty); in the sets of a
/// furnished scene, whose uncertainty is two standard errors, <= max(relative * expected, absolute)
/// + uncertainty (reference README).
Judged judge(std::string id, std::string set, double expected, double got, double uncertainty,
             const ReferenceGrade& top, const ReferenceGrade& pass);

struct CaseVerdict {
    std::string id, category, unsupported;
    std::vector<Judged> judged;
    double seconds = 0.0;
    std::size_t patches = 0;
    std::string method = {};  ///< of interreflection; empty where none was asked for
    Grade grade() const;      ///< the worst of its points
};

/// Case, points, worst and mean error, time, grade; a line more for every set of a furnished scene
/// (mean, 95th percentile, greatest relative error).
std::string line_of(const CaseVerdict& verdict);

/// The case as a line of the signed-off table.
ValidationRow row_of(const CaseVerdict& verdict, const std::string& proves, const std::string& source);

/// How often what we say of our errors holds: values within their error bar (and the uncertainty of what
/// is expected), and the median of error bar over error where the error is more than that uncertainty.
std::string error_bars_text(const std::vector<CaseVerdict>& verdicts);

/// Cases and points by category: how many reach which grade; closes with "N passed, N failed".
std::string categories_text(const std::vector<CaseVerdict>& verdicts);

}  // namespace hanei
