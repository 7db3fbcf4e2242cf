/// What must hold of any right answer, looked for in this one: figures, each with a limit that follows from
/// what the answer claims of itself.
#pragma once

#include "engine/base/progress.h"
#include "engine/solution/solution.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hanei {

enum class TrustState { holds, fails, not_asked };

/// One figure against its limit, both in one unit.
struct TrustFigure {
    double found = 0.0, allowed = 0.0;
    bool asked = true;  ///< false: the scene or the answer has nothing to look at
    TrustState state() const {
        return !asked ? TrustState::not_asked : found <= allowed ? TrustState::holds : TrustState::fails;
    }
};

/// lm. What luminaires emit arrives on surfaces (the sum over patches) or on other luminaires. A scene without
/// a room is open: then it may be less, never more. Allowed is by how much the means over patches claim to be off.
struct DirectTrust {
    double emitted = 0.0, arrived = 0.0, on_luminaires = 0.0, error = 0.0;
    bool open = false;
    ObjectId worst{};  ///< the luminaire most of whose light is missing
    double worst_emitted = 0.0, worst_missing = 0.0;
    double missing() const { return emitted - arrived - on_luminaires; }
    TrustFigure figure() const;
};

/// lm. All that is emitted is absorbed, escapes, or is on its way still. Light on its way is what the last
/// reflection sends and nobody has received: explained when the reflections were stopped as set, else no more
/// than the bound of the iteration. Where light between surfaces was scaled so that as much arrives as was sent,
/// allowed is what the answer says that scaling may misplace; else the error bar of the mean interreflected light
/// of all surfaces, worked out as that of any value; and the error of direct light.
struct EnergyTrust {
    EnergyBalance energy;
    double direct_missing = 0.0;  ///< judged by DirectTrust, and not again
    double under_way = 0.0;
    double iteration_bound = 0.0;  ///< on it, when the iteration ended by its accuracy
    bool converged = true;
    int bounces = 0;
    double received = 0.0;  ///< by surfaces from surfaces
    bool scaled = true;     ///< so that as much arrives as was sent; the paper's methods are not
    double error = 0.0;     ///< of `received`
    double direct_error = 0.0;
    bool asked = true;  ///< false: there is no interreflection to account for
    double explained() const;
    double unexplained() const;
    TrustFigure figure() const;
};

/// Light that faces pass to each other through the whole room, with all reflections: what arrives at b, lm, when a
/// emits 1 lm/m2, against what arrives at a when b does. Both are one number in any room (m2). Allowed is that 95
/// of 100 pairs agree within the error bars of the two, as error bars promise: told from patches twice as wide.
struct ReciprocityTrust {
    struct Pair {
        SurfaceRef a, b;
        double there = 0.0, back = 0.0, error = 0.0;  ///< m2
        double ratio() const;                         ///< of their difference to what is allowed
    };
    std::vector<Pair> pairs;
    double rows_apart = 0.0;  ///< sum of |A_i F_ij - A_j F_ji| over that of A_i F_ij, of single patches
    std::size_t rows_compared = 0;
    double gain = 0.0;       ///< share by which light between surfaces was scaled for it: |gain - 1|
    double misplaced = 0.0;  ///< share of interreflected light that this may have misplaced, in error bars
    bool asked = true;
    const Pair* worst() const;
    std::size_t within() const;
    TrustFigure figure() const;  ///< shares of pairs that disagree
};

/// What a patch sends arrives: the row sums that the balance uses against the share of what the patch sees that is
/// a surface. That share is worked out twice, by exact form factors of the visible parts and by counting rays.
struct ClosureTrust {
    double least = 1.0, greatest = 1.0;  ///< row sums as used
    Vec3 greatest_place{0.0};
    double misplaced = 0.0;      ///< mean of |used - seen| by area, over 1 - mean reflectance; nothing sees more than 1
    double error_share = 0.0;    ///< error bars of interreflected light, a share of it
    double greatest_seen = 1.0;  ///< never above 1 but for rounding
    std::size_t places = 0, rays = 0;               ///< looked from; in so many directions each
    double seen_by_rows = 1.0, seen_by_rays = 1.0;  ///< means over these places
    double worst_deviation = 0.0;                   ///< in standard errors of counting, of any place
    static constexpr double most_deviation = 5.0;   ///< one place in two million
    bool asked = true;
    bool rays_agree() const { return worst_deviation <= most_deviation; }
    TrustFigure figure() const;  ///< misplaced; fails too where no row may be as it is
};

/// Half of the luminaires alone and the other half alone make the light of all.
struct AdditivityTrust {
    std::size_t points = 0, within = 0, odd = 0, even = 0;
    bool same_patches = false;  ///< then the mesh is no reason to differ, and its error bar is left out
    double worst_ratio = 0.0;   ///< of a difference to what is allowed there
    double worst_apart = 0.0, worst_allowed = 0.0, worst_value = 0.0;  ///< lx, at that point
    Vec3 worst_place{0.0};
    bool asked() const { return odd > 0 && even > 0 && points > 0; }
    TrustFigure figure() const;  ///< shares of points that disagree
};

struct ThreadsTrust {
    std::array<int, 2> threads{1, 3};
    std::size_t values = 0, others = 0;
    TrustFigure figure() const { return {static_cast<double>(others), 0.0, values > 0}; }
};

struct TrustReport {
    SolutionSnapshot solution;
    DirectTrust direct;
    EnergyTrust energy;
    ReciprocityTrust reciprocity;
    ClosureTrust closure;
    AdditivityTrust additivity;
    ThreadsTrust threads;
    int done = 0;  ///< of these six, in this order
    static constexpr int checks = 6;
    bool holds() const;
};

/// Calls `told` with the report so far after every check.
///
/// Needs     a scene without errors.
/// Returns   empty when stopped.
/// Cost      the study four times over, the balance once more for each of six faces.
std::optional<TrustReport> trust_in(const SceneSnapshot& scene, const Settings& settings, const Work& work,
                                    const std::function<void(const TrustReport&)>& told = nullptr);

/// The values of a whole against the sums of its parts, point by point; those inside solids are left out.
AdditivityTrust sum_of_parts(const Solution& whole, const Solution& odd, const Solution& even);

/// How many figures of two answers differ in a bit.
ThreadsTrust same_bits(const Solution& one, const Solution& other);

}  // namespace hanei
