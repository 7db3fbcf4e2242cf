#include "engine/study/study.h"
#include "engine/study/value_stage.h"
#include "engine/transport/factor_rows.h"
#include "engine/transport/factors.h"
#include "engine/transport/visible_shares.h"

#include <vector>

namespace hanei {

namespace {

/// Rows from the nodes of a mesh to one receiver.
class OneRow {
public:
    OneRow(const Receiver& receiver, const Mesh& mesh, int nodes_a_patch, const OccluderSet* occluders)
        : nodes_(nodes_of(mesh, nodes_a_patch == 1 ? Elements::constant : Elements::linear)),
          factors_(nodes_.size(), 0.0F),
          shares_(mesh.patches.size(), 1.0F) {
        const std::span receivers(&receiver, 1);
        FactorRows(mesh, nodes_).write(receivers, factors_.data());
        if (occluders) VisibleShares(mesh, *occluders).write(receivers, shares_.data());
    }
    double gathered(const std::vector<double>& exitance) const {
        double sum = 0.0;
        for (std::size_t j = 0; j < factors_.size(); ++j)
            sum += exitance[j] * static_cast<double>(factors_[j]) * static_cast<double>(shares_[j / nodes_.per_patch]);
        return sum;
    }

private:
    Nodes nodes_;
    std::vector<float> factors_, shares_;
};

}  // namespace

PointValue value_at(const Solution& solution, const Vec3& position, const Vec3& normal) {
    PointValue inside;
    inside.inside_solid = true;
    if (is_covered(*solution.occluders, position, normal)) return inside;

    const Receiver receiver = locate(*solution.mesh, position, glm::normalize(normal)).receiver;
    const bool shadows = solution.plan.simulates(Effect::occlusion_direct);
    const bool patch_shadows = solution.plan.simulates(Effect::occlusion_patches);
    ValueParts parts;
    for (const WeightedEmitter& weighted : emitters_of(*solution.scene)) {
        const Estimate direct = weighted.emitter.estimate(receiver, shadows ? solution.occluders.get() : nullptr);
        parts.direct += weighted.share * direct.value;
        parts.sampling += weighted.share * direct.error;
    }
    const OccluderSet* occluders = patch_shadows ? solution.occluders.get() : nullptr;
    if (!solution.exitance.empty() && solution.plan.simulates(Effect::interreflection)) {
        const OneRow row(receiver, *solution.mesh, solution.nodes_a_patch, occluders);
        parts.interreflected = row.gathered(solution.exitance);
        parts.iteration = row.gathered(solution.exitance_half_width);
        if (solution.coarse_mesh && !solution.coarse_exitance.empty()) {
            const OneRow coarse(receiver, *solution.coarse_mesh, solution.nodes_a_patch, occluders);
            parts.coarse = coarse.gathered(solution.coarse_exitance);
        }
    }
    parts.typical_mesh_error = solution.typical_mesh_error;
    parts.reflected_error = solution.reflected_error;
    parts.skipped = solution.plan.skipped_at(position, glm::normalize(normal));
    return value_from(parts);
}

double form_factor_between(const Scene& scene, const Region& from, const Region& to) {
    // The corners become places of the scene: what can stand between them is then a shadow caster.
    Scene with_corners = scene;
    for (const Region* region : {&from, &to})
        for (const Vec3& corner : region->outline)
            with_corners.points.push_back({with_corners.new_id(), "", corner, {0.0, 0.0, 1.0}, {}});
    return form_factor(from, to, occluders_of(with_corners));
}

}  // namespace hanei
