/// How a scene shall be computed: one list of settings for command line, panel and project file.
#pragma once

#include <string>
#include <string_view>
#include <tuple>

namespace hanei {

/// Methods of interreflection. `paper`: grid points, point-to-point form factors, row visibility,
/// a fixed number of bounces (Nishita and Nakamae 1985). `patch`: patch centres, analytic form
/// factors of the visible part.
enum class Method { paper, patch };

std::string_view name_of(Method method);

struct Settings {
    Method method = Method::patch;
    double max_patch = 0.5;    ///< m, wished patch width (the paper's W)
    int bounces = 1000;        ///< interreflections at most; the accuracy usually ends them earlier
    double accuracy = 0.001;   ///< share of the value that the iteration may leave unknown
    double tolerance_lux = 0.0;  ///< lx, effects may be skipped while their bounds sum to less
    int threads = 0;           ///< 0: all of the machine's
    bool operator==(const Settings&) const = default;
};

/// One setting that is a number, as every door shows it. The project file and the command line use
/// `name`, in `unit`; the stored value times `scale` is the shown one.
template <class T>
struct Option {
    std::string_view name;
    std::string_view unit;
    std::string_view help;
    T Settings::*member;
    T low;   ///< allowed, as shown
    T high;
    double scale = 1.0;
};

/// All numeric settings; `method` is the one choice beside them.
inline constexpr std::tuple options{
    Option<double>{"max-patch", "m", "Wished patch width", &Settings::max_patch, 0.01, 50.0},
    Option<int>{"bounces", "", "Stop after this many interreflections at the latest", &Settings::bounces, 0, 100'000},
    Option<double>{"accuracy", "percent", "Stop iterating when this much of each value at most is unknown",
                   &Settings::accuracy, 1e-7, 50.0, 100.0},
    Option<double>{"tolerance", "lx", "Skip effects while their bounds sum to less than this",
                   &Settings::tolerance_lux, 0.0, 1e6},
    Option<int>{"threads", "", "Threads to compute with; 0 takes all", &Settings::threads, 0, 1024},
};

}  // namespace hanei
