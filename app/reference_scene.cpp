#include "app/reference_scene.h"

#include "engine/geometry/polygon.h"
#include "engine/scene/faces.h"

#include <cmath>

namespace hanei {

SceneSnapshot scene_with_points(const ReferenceCase& reference) {
    Scene scene = reference.scene;
    scene.grids.clear();
    scene.points.clear();
    for (const ReferencePoint& point : reference.points)
        scene.points.push_back({scene.new_id(), point.id, point.position, glm::normalize(point.normal), {}});
    return std::make_shared<const Scene>(std::move(scene));
}

double suitable_patch(const Scene& scene, double unknowns) {
    double area = 0.0;
    for (const Face& face : faces_of(scene)) area += glm::length(vector_area(face.region));
    return area > 0.0 ? std::sqrt(area / unknowns) : 1.0;
}

}  // namespace hanei
