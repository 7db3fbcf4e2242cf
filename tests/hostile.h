/// Errors of many hostile cases against a reference, class by class: held to limits, and printed as a
/// table when asked.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace hanei::testing {

/// Cases of a class: HANEI_HOSTILE when set (the table is printed then), else `usual`.
inline int hostile_count(int usual) {
    const char* wanted = std::getenv("HANEI_HOSTILE");
    return wanted ? std::atoi(wanted) : usual;
}

/// Errors of one class of cases.
class Errors {
public:
    /// `moved`: how far one rounding of the input moves the expected value; 0 when not known.
    void add(double got, double expected, double moved) {
        if (!(got >= 0.0) || !std::isfinite(got)) {
            ++broken;
            return;
        }
        const double error = std::abs(got - expected);
        absolute = std::max(absolute, error);
        if (expected > 0.0) relative_.push_back(error / expected);
        if (moved > 0.0 && moved <= 1e-15 * expected) well_conditioned = std::max(well_conditioned, error / expected);
    }

    double relative(double quantile) {
        if (relative_.empty()) return 0.0;
        const auto rank = static_cast<std::ptrdiff_t>(quantile * static_cast<double>(relative_.size() - 1));
        std::nth_element(relative_.begin(), relative_.begin() + rank, relative_.end());
        return relative_[static_cast<std::size_t>(rank)];
    }
    /// One row: name, cases that shine, broken, relative error's median, p99 and greatest, the greatest of
    /// the well-conditioned (0 when none is known), greatest absolute error.
    void print(const std::string& name) {
        if (!std::getenv("HANEI_HOSTILE")) return;
        std::printf("%s,%zu,%d,%.1e,%.1e,%.1e,%.1e,%.1e\n", name.c_str(), relative_.size(), broken, relative(0.5),
                    relative(0.99), relative(1.0), well_conditioned, absolute);
    }

    double absolute = 0.0;
    double well_conditioned = 0.0;  ///< greatest relative error where a rounding of the input moves it by 1e-15
    int broken = 0;                 ///< negative, infinite or not a number

private:
    std::vector<double> relative_;
};

}  // namespace hanei::testing
