/// How a scene shall be computed: one list of settings for command line, panel and project file.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>

namespace hanei {

/// Methods of interreflection.
///   paper         grid points, point-to-point form factors, row visibility, a fixed number of bounces
///                 (Nishita and Nakamae 1985)
///   paper-closed  the same with every row scaled to what the point really sees
///   patch         patch centres, analytic form factors of the visible part
///   linear        patches over which the exitance slopes, crowded towards edges
enum class Method { paper, paper_closed, patch, linear };

inline constexpr std::array methods{Method::paper, Method::paper_closed, Method::patch, Method::linear};

std::string_view name_of(Method method);  ///< as every door writes it
std::optional<Method> method_named(std::string_view name);

/// Unknowns at grid points, as in the paper.
bool is_of_the_paper(Method method);

/// Who decides whether an effect is simulated.
enum class EffectChoice {
    by_bound,  ///< the plan: skipped while the bounds of all that is skipped stay within the tolerance
    always,    ///< the user: simulated however little it may add
    never,     ///< the user: skipped however much; its bound is in every error bar
};

inline constexpr std::array effect_choices{EffectChoice::by_bound, EffectChoice::always, EffectChoice::never};

std::string_view name_of(EffectChoice choice);  ///< "by-bound", "always", "never"
std::optional<EffectChoice> effect_choice_named(std::string_view name);

struct Settings {
    Method method = Method::patch;
    double max_patch = 0.5;      ///< m, wished patch width (the paper's W)
    int bounces = 1000;          ///< interreflections at most; the accuracy usually ends them earlier
    double accuracy = 0.001;     ///< share of the value that the iteration and sampled direct light may leave unknown
    double tolerance_lux = 0.0;  ///< lx, effects may be skipped while their bounds sum to less
    int threads = 0;             ///< 0: all of the machine's
    int memory_mb = 1024;        ///< form factors past this go to a file and are read back row by row
    EffectChoice interreflection = EffectChoice::by_bound;
    EffectChoice furniture = EffectChoice::by_bound;  ///< as a reflector, every piece by itself
    EffectChoice colour = EffectChoice::by_bound;     ///< three bands where one might do
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
    T low;  ///< allowed, as shown
    T high;
    double scale = 1.0;
};

/// All numeric settings; `method` is the one choice beside them.
inline constexpr std::tuple options{
    Option<double>{"max-patch", "m", "Wished patch width", &Settings::max_patch, 0.01, 50.0},
    Option<int>{"bounces", "", "Stop after this many interreflections at the latest", &Settings::bounces, 0, 100'000},
    Option<double>{"accuracy", "percent", "Share of each value that iterating and sampling may leave unknown",
                   &Settings::accuracy, 1e-7, 50.0, 100.0},
    Option<double>{"tolerance", "lx", "Skip effects while their bounds sum to less than this", &Settings::tolerance_lux,
                   0.0, 1e6},
    Option<int>{"memory", "MB", "Form factors that need more memory than this are read from disk", &Settings::memory_mb,
                16, 1'000'000},
    Option<int>{"threads", "", "Threads to compute with; 0 takes all", &Settings::threads, 0, 1024},
};

/// An effect that may be skipped, as every door names it.
struct EffectOption {
    std::string_view name;
    std::string_view help;
    EffectChoice Settings::*member;
};

inline constexpr std::array effect_options{
    EffectOption{"interreflection", "Light that surfaces pass on to each other", &Settings::interreflection},
    EffectOption{"furniture", "Light that furniture reflects", &Settings::furniture},
    EffectOption{"colour", "Light in three bands of colour, where one might do", &Settings::colour},
};

}  // namespace hanei
