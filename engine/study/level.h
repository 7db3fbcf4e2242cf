/// Interreflection solved at one resolution, with every stage's value kept for the next time.
#pragma once

#include "engine/plan/plan.h"
#include "engine/study/direct_stage.h"
#include "engine/study/stage_cache.h"
#include "engine/study/stage_clock.h"
#include "engine/study/visibility_stage.h"
#include "engine/transport/balance.h"
#include "engine/transport/factors.h"

#include <functional>

namespace hanei {

/// One resolution's answer, patch by patch. For the paper's method the unknowns are the vertices;
/// a patch then has the mean of its corners.
struct LevelAnswer {
    std::vector<double> direct;                 ///< lx, mean over each patch
    std::vector<double> interreflected;         ///< lx
    std::vector<double> exitance;               ///< lm/m2
    std::vector<double> exitance_half_width;    ///< lm/m2
    std::vector<double> vertex_direct;          ///< lx; the paper's method only
    std::vector<double> vertex_interreflected;  ///< lx; the paper's method only
    int bounces = 0;
    bool converged = true;
    double greatest_row_sum = 0.0;
};

/// The request of one run.
struct LevelInput {
    const Scene* scene = nullptr;
    const Settings* settings = nullptr;
    const EffectsPlan* plan = nullptr;
    double max_patch = 0.5;                              ///< m
    std::shared_ptr<const OccluderSet> occluders;        ///< of direct light; null: nothing casts shadows
    std::shared_ptr<const OccluderSet> patch_occluders;  ///< of light between surfaces; null: nothing stands between
};

class Level {
public:
    /// Mesh for the scene at this patch width.
    std::shared_ptr<const Mesh> mesh(const Scene& scene, double max_patch);

    /// `on_direct` sees the direct light before interreflection is computed.
    /// Returns   empty when stopped.
    std::optional<LevelAnswer> solve(const LevelInput& input, const Work& work, StageClock& clock,
                                     const std::function<void(const LevelAnswer&)>& on_direct = nullptr);

    /// What other places need to gather interreflected light from this level's patches; kept as long
    /// as the receivers, the mesh's shapes and the occluders are the same. `slot` numbers the set of
    /// receivers (0: calculation points, 1: vertices).
    /// Returns   null factors when stopped.
    struct GatherRows {
        const DenseRows* factors = nullptr;
        const Visibility* visibility = nullptr;
    };
    GatherRows rows_to(int slot, const std::shared_ptr<const std::vector<Receiver>>& receivers,
                       const std::shared_ptr<const OccluderSet>& occluders, const Work& work, StageClock& clock);

private:
    /// Stands for the shapes of the mesh: the same object as long as form factors stay valid.
    using Geometry = std::shared_ptr<const Mesh>;
    struct FactorKey {
        Geometry geometry;
        Method method = Method::patch;
        bool operator==(const FactorKey&) const = default;
    };
    struct VisibilityKey {
        FactorKey factors;
        std::shared_ptr<const OccluderSet> occluders;
        bool operator==(const VisibilityKey&) const = default;
    };
    struct GatherKey {
        Geometry geometry;
        std::shared_ptr<const std::vector<Receiver>> receivers;
        bool operator==(const GatherKey&) const = default;
    };
    struct MeshKey {
        Scene surfaces;  ///< with the opaque luminaires, which cover what they lie on
        double max_patch = 0.0;
        bool operator==(const MeshKey&) const = default;
    };
    struct BalanceKey {
        VisibilityKey visibility;
        std::vector<double> reflectance, direct, own_exitance;
        int bounces = 0;
        double accuracy = 0.0;
        bool operator==(const BalanceKey&) const = default;
    };
    struct Gathering {
        StageCache<GatherKey, DenseRows> factors;
        VisibilityStage visibility;
    };

    std::optional<std::vector<double>> patch_direct(const LevelInput& input, const Work& work, StageClock& clock);
    std::optional<std::vector<double>> vertex_direct(const LevelInput& input, const Work& work, StageClock& clock);
    const Visibility* visibility(const LevelInput& input, const VisibilityKey& key, const Mesh& mesh, const Work& work,
                                 StageClock& clock);
    const Balance* solve_balance(const LevelInput& input, const std::vector<double>& direct, const Work& work,
                                 StageClock& clock);

    StageCache<MeshKey, std::shared_ptr<const Mesh>> mesh_;
    Geometry geometry_;
    DirectStage patch_direct_, vertex_direct_;
    StageCache<FactorKey, DenseRows> factors_;
    StageCache<VisibilityKey, Visibility> paper_visibility_;
    VisibilityStage patch_visibility_;
    StageCache<BalanceKey, Balance> balance_;
    Gathering gathering_[2];
};

}  // namespace hanei
