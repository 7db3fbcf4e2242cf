/// Interreflection solved at one resolution, with every stage's value kept for the next time.
#pragma once

#include "engine/plan/plan.h"
#include "engine/study/direct_stage.h"
#include "engine/study/gather_stage.h"
#include "engine/study/light_groups.h"
#include "engine/study/light_mix.h"
#include "engine/study/light_sides.h"
#include "engine/study/rows_stage.h"
#include "engine/study/stage_cache.h"
#include "engine/study/stage_clock.h"
#include "engine/transport/energy.h"
#include "engine/transport/nodes.h"

#include <functional>

namespace hanei {

/// The request of one run.
struct LevelInput {
    const Scene* scene = nullptr;
    const Settings* settings = nullptr;
    const EffectsPlan* plan = nullptr;
    std::shared_ptr<const OccluderSet> occluders;        ///< of direct light; null: nothing casts shadows
    std::shared_ptr<const OccluderSet> patch_occluders;  ///< of light between surfaces; null: nothing stands between
    Accuracy direct_accuracy;                            ///< of each luminaire's direct light
    bool warm = false;  ///< start from the last solution: sooner there, and not the same bits as from nothing
};

/// One resolution's answer.
struct LevelAnswer {
    std::vector<MixPart> parts;        ///< of every group and band; values at the unknowns
    std::vector<double> patch_direct;  ///< lx, mean over each patch
    int bounces = 0;                   ///< the most of any part
    bool converged = true;
    double greatest_row_sum = 0.0;
    double greatest_gain = 0.0;  ///< by which light between surfaces was scaled, of any part: |gain - 1|
    std::string refusal;  ///< why there is no balance: then there is no interreflected light; empty when there is one
};

/// Needs     cut() before anything else.
class Level {
public:
    struct Cut {
        std::shared_ptr<const Mesh> mesh;
        std::shared_ptr<const Nodes> nodes;  ///< that light is gathered from; of the paper's methods one a patch
    };
    /// Cuts the scene into patches of this width, wider ones on furniture that the plan takes as black; the same
    /// objects while nothing that shapes them changes.
    Cut cut(const Scene& scene, double max_patch, Method method, std::span<const ObjectId> black);
    Cut cut(std::shared_ptr<const Mesh> mesh, Method method);  ///< a mesh made elsewhere

    /// `on_way` sees direct light with an ambient estimate of the rest before interreflection is computed.
    /// Returns   empty when stopped.
    std::optional<LevelAnswer> solve(const LevelInput& input, const Work& work, StageClock& clock,
                                     const std::function<void(const LevelAnswer&)>& on_way = nullptr);

    /// Where the light of an answer with interreflection goes; empty when stopped.
    std::optional<FluxAccount> flux(const LevelAnswer& answer, const Scene& scene, const EffectsPlan& plan,
                                    const Work& work);

    /// Light from this level's surfaces at other places, kept as long as it is the same. `slot` numbers
    /// the set of receivers (0: calculation points, 1: vertices).
    /// Returns   empty when stopped.
    std::optional<GatheredLight> gather(int slot, std::span<const MixPart> parts,
                                        const std::shared_ptr<const std::vector<Receiver>>& receivers,
                                        const LevelInput& input, const Work& work, StageClock& clock);

    /// What has these values at the unknowns: as means over patches, at the nodes that light is gathered
    /// from, at the mesh's vertices. No values at all: all are 0.
    std::vector<double> patch_values(std::span<const double> at_unknowns) const;
    std::vector<double> node_values(std::span<const double> at_unknowns) const;
    std::vector<double> vertex_values(std::span<const double> at_unknowns) const;

    /// Rows from the nodes to other places, made for once.
    /// Needs     a solve() before. Empty when stopped.
    std::optional<StoredRows> rows_to(std::span<const Receiver> receivers, const LevelInput& input,
                                      const Work& work) const;

    /// The exitance of a part of the last answer, reflection by reflection, at the nodes that light is
    /// gathered from: what the part emits or what of its direct light is reflected, then what of that is
    /// reflected again, and so on. All of them together are the part's exitance.
    /// Returns   empty when stopped.
    std::optional<std::vector<std::vector<double>>> reflections(const MixPart& part, const LevelInput& input,
                                                                std::size_t count, const Work& work) const;

    const Cut& now() const { return cut_; }
    const StoredRows* rows() const { return rows_.now(); }  ///< between the unknowns, of the last solve; may be null

private:
    struct MeshKey {
        Scene surfaces;  ///< with the opaque luminaires, which cover what they lie on
        double max_patch = 0.0;
        Method method = Method::patch;
        std::vector<ObjectId> black = {};
        bool operator==(const MeshKey&) const = default;
    };

    LightReceivers receivers_at_nodes(const LevelInput& input, const Work& work) const;
    LightReceivers receivers_at_vertices(const LevelInput& input, const Work& work) const;
    std::optional<std::vector<double>> means_of_patches(const Emitter& emitter, std::span<const std::uint32_t> which,
                                                        const LevelInput& input, const Work& work) const;
    std::optional<std::vector<double>> means_of_quarters(const Emitter& emitter, std::span<const std::uint32_t> which,
                                                         const LevelInput& input, const Work& work) const;
    std::vector<double> reflectances(const Scene& scene, const EffectsPlan& plan, int band) const;
    std::vector<double> own_exitances() const;
    std::vector<double> unknown_areas() const;
    std::optional<std::vector<SideInput>> side_inputs(const LevelInput& input, const Work& work);
    std::optional<std::vector<double>> patch_direct(const LevelInput& input, std::span<const SideInput> sides,
                                                    const Work& work);
    std::optional<std::string> refusal(std::span<const SideInput> sides, const Exchange& exchange, const Scene& scene,
                                       const Work& work) const;
    RowsInput rows_between_surfaces(const LevelInput& input) const;
    LevelAnswer first_guess(std::span<const SideInput> sides, std::vector<double> patch_direct,
                            bool with_ambient) const;

    StageCache<MeshKey, std::shared_ptr<const Mesh>> meshes_;
    Cut cut_;
    std::shared_ptr<const Mesh> seen_;  ///< what visible shares are of: the patches, or the quarters that have a node
    std::shared_ptr<const void> geometry_;  ///< the same object as long as the shapes and nodes are
    bool of_the_paper_ = false;
    std::vector<Receiver> unknowns_;
    std::vector<MixPart> levels_;  ///< one a side of the last solve, without light
    DirectStage direct_, patch_direct_;
    RowsStage rows_;
    StageCache<std::shared_ptr<const void>, std::vector<double>> row_sums_;
    LightSides sides_;
    GatherStage gathering_[2];
};

}  // namespace hanei
