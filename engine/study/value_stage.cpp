#include "engine/study/value_stage.h"

#include <algorithm>
#include <cmath>

namespace hanei {

std::size_t CalculationPlaces::size() const {
    std::size_t count = points.size();
    for (const GridResult& grid : grids) count += grid.points.size();
    return count;
}

CalculationPlaces places_of(const Scene& scene) {
    CalculationPlaces places;
    for (const CalculationPoint& point : scene.points) {
        PointResult result;
        result.point = point.id;
        result.position = point.position;
        result.normal = point.normal;
        places.points.push_back(result);
    }
    for (const CalculationGrid& grid : scene.grids) places.grids.push_back(layout_of(grid));
    return places;
}

std::vector<Receiver> receivers_at(CalculationPlaces& places, const Mesh& mesh) {
    std::vector<Receiver> receivers;
    receivers.reserve(places.size());
    places.for_each([&](PointResult& point) {
        receivers.push_back(locate(mesh, point.position, glm::normalize(point.normal)).receiver);
    });
    return receivers;
}

bool is_covered(const OccluderSet& occluders, const Vec3& position, const Vec3& normal) {
    // Just above the surface a desk's foot is around the point, a desk's top is not.
    constexpr double just_above = 10.0;  // tolerances: clear of the body's own skin
    return occluders.containing(position + just_above * occluders.same_place() * glm::normalize(normal)) >= 0;
}

PointValue value_from(const ValueParts& parts) {
    PointValue value;
    value.direct = {parts.direct};
    value.interreflected = {parts.interreflected};
    value.error.iteration = parts.iteration;
    if (parts.coarse >= 0.0)
        value.error.mesh = std::max(std::abs(parts.interreflected - parts.coarse), 0.5 * parts.typical_mesh_error);
    value.error.skipped = parts.skipped;
    value.error.sampling = parts.sampling;
    return value;
}

std::map<SurfaceRef, PointValue> face_means(const Mesh& mesh, const PatchLight& light, double skipped_lux) {
    std::map<SurfaceRef, PointValue> means;
    for (const MeshFace& face : mesh.faces) {
        double area = 0.0, direct = 0.0, interreflected = 0.0;
        for (std::size_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p) {
            const double patch_area = mesh.patches[p].area;
            area += patch_area;
            direct += patch_area * light.direct[p];
            interreflected += patch_area * light.interreflected[p];
        }
        if (area <= 0.0) continue;
        PointValue& mean = means[face.face.ref];
        mean.direct = {direct / area};
        mean.interreflected = {interreflected / area};
        mean.error.skipped = skipped_lux;
    }
    return means;
}

EnergyBalance energy_of(const Scene& scene, const Mesh& mesh, const PatchLight& light) {
    EnergyBalance energy;
    for (const WeightedEmitter& weighted : emitters_of(scene))
        energy.emitted += weighted.share * weighted.emitter.flux().value;
    const PerPatch<double> reflectance = reflectances(mesh, scene);
    for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
        const Patch& patch = mesh.patches[p];
        energy.emitted += patch.area * patch.own_exitance.value;
        energy.absorbed += patch.area * (1.0 - reflectance.all()[p]) * (light.direct[p] + light.interreflected[p]);
    }
    energy.escaped = energy.emitted - energy.absorbed;
    return energy;
}

}  // namespace hanei
