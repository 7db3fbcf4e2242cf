/// The light that surfaces pass to each other in an answer, asked in other ways than the answer itself did.
#pragma once

#include "engine/study/level.h"
#include "engine/study/trust.h"

namespace hanei {

/// Needs     a solution with interreflection and its coarser one; a scene and work that outlive it.
/// Returns   of each: empty when stopped.
class ExchangeTrust {
public:
    ExchangeTrust(const Solution& solution, const Work& work);

    /// Solves the scene again; the others need it.
    bool solve();
    std::optional<EnergyTrust> energy(const DirectTrust& direct);
    std::optional<ReciprocityTrust> reciprocity();
    std::optional<ClosureTrust> closure();

private:
    struct Passed {
        std::vector<double> to;  ///< m2, one a face
        double misplaced = 0.0, left_by_iteration = 0.0;
    };
    LevelInput input() const;
    std::vector<double> areas() const;
    std::vector<Receiver> unknowns() const;
    double mean_reflectance() const;
    void look_at_bars(const LevelAnswer& coarse);
    double mean_received(const Level& level, const LevelAnswer& answer) const;
    std::optional<Passed> passed(Level& level, const Mesh& mesh, const SurfaceRef& from,
                                 std::span<const SurfaceRef> to) const;
    bool pair_by_pair(ReciprocityTrust& trust) const;
    bool compare_with_seen(ClosureTrust& trust);
    bool compare_with_rays(ClosureTrust& trust);

    const Solution& solution_;
    const Work& work_;
    Scene dark_;  ///< no luminaire shines
    Level level_, coarse_;
    std::optional<LevelAnswer> answer_;
    double mean_ = 0.0, error_ = 0.0;  ///< lx: interreflected light in the mean over all surfaces, and its error bar
    double area_ = 0.0;                ///< m2, of these
};

}  // namespace hanei
