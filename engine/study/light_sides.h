/// Groups' light in colour bands, solved when what it was solved from changes.
#pragma once

#include "engine/study/direct_stage.h"
#include "engine/study/light_mix.h"
#include "engine/transport/balance.h"

#include <map>
#include <string>
#include <utility>

namespace hanei {

/// Everything one side of light is solved from.
struct SideInput {
    std::pair<ObjectId, int> name;            ///< the group's first luminaire (none: surfaces), and the band
    std::vector<DirectStage::Values> direct;  ///< lx at the unknowns, one list a member of the group
    std::vector<double> shares;               ///< of these, by dimming within the group and colour
    std::vector<double> reflectance;          ///< one an unknown
    std::vector<double> own_exitance;         ///< lm/m2; empty: none
    std::shared_ptr<const void> rows;         ///< stands for the rows' content
    BalanceLimits limits;
    bool operator==(const SideInput& other) const;

    std::vector<double> direct_sum() const;
};

/// What passes between surfaces in one reflection.
struct SurfaceExchange {
    Exchange exchange;
    std::vector<double> areas;     ///< m2, one an unknown
    std::vector<double> row_sums;  ///< share of what each sees that is a surface
    bool conserves = true;         ///< light that arrives is scaled to what left: rows at nodes gain or lose some
};

class LightSides {
public:
    /// The solved light of each input. Inputs that are as they were cost nothing; the others are
    /// solved together.
    /// `warm`: they start from the last solution under their name, and scale as it did. Without it no light
    /// is given out that was solved so.
    /// Returns   empty when stopped.
    std::optional<std::vector<std::shared_ptr<const SideLight>>> get(std::vector<SideInput> inputs,
                                                                     const SurfaceExchange& surfaces, bool warm,
                                                                     const Work& work);
    void forget_others(std::span<const std::pair<ObjectId, int>> names);
    bool reused() const { return reused_; }  ///< the last get() solved nothing

private:
    struct Kept {
        SideInput input;
        std::shared_ptr<const SideLight> light;
        bool is_warm = false;  ///< not the same bits as solved from nothing
    };
    std::map<std::pair<ObjectId, int>, Kept> kept_;
    bool reused_ = false;
};

}  // namespace hanei
