#include "engine/study/study.h"
#include "engine/study/value_stage.h"
#include "engine/transport/balance.h"
#include "engine/transport/factors.h"

#include <array>

namespace hanei {

namespace {

/// Interreflected light at one receiver from a mesh's exitances.
void gathered_at(const Receiver& receiver, const Mesh& mesh, const OccluderSet* occluders,
                 std::initializer_list<std::pair<std::span<const double>, double*>> wanted) {
    const std::array<Receiver, 1> receivers{receiver};
    const auto factors = patch_factors(mesh, receivers, Work{});
    std::optional<Visibility> visibility;
    if (occluders) visibility = patch_visibility(mesh, receivers, *occluders, Work{});
    for (const auto& [exitance, into] : wanted)
        *into = gather(*factors, visibility ? &*visibility : nullptr, exitance, Work{}).front();
}

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
    if (!solution.patch_exitance.empty() && solution.plan.simulates(Effect::interreflection)) {
        gathered_at(
            receiver, *solution.mesh, occluders,
            {{solution.patch_exitance, &parts.interreflected}, {solution.patch_exitance_half_width, &parts.iteration}});
        if (solution.coarse_mesh && !solution.coarse_exitance.empty())
            gathered_at(receiver, *solution.coarse_mesh, occluders, {{solution.coarse_exitance, &parts.coarse}});
    }
    parts.typical_mesh_error = solution.typical_mesh_error;
    parts.skipped = solution.plan.skipped_bound_lux();
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
