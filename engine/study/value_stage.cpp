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
    constexpr double rounding = 1e-12;  // of a value: some thousand terms
    value.error.iteration = parts.iteration + rounding * (parts.direct + parts.interreflected);
    constexpr double of_difference = 1.6, of_typical = 0.6;  // so that 95 of 100 values of all reference cases hold
    if (parts.coarse >= 0.0)
        value.error.mesh = std::max({of_difference * std::abs(parts.interreflected - parts.coarse),
                                     of_typical * parts.typical_mesh_error, parts.misplaced}) +
                           parts.reflected_error * parts.interreflected;
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

EnergyBalance energy_of(const Scene& scene, const FluxAccount& account, double from_luminaires, double on_luminaires) {
    EnergyBalance energy;
    energy.on_luminaires = on_luminaires;
    energy.emitted = from_luminaires + account.own;
    energy.absorbed = account.absorbed;
    energy.escaped = account.escaped;
    if (!scene.room) energy.escaped += std::max(0.0, from_luminaires - account.direct - energy.on_luminaires);
    return energy;
}

}  // namespace hanei
