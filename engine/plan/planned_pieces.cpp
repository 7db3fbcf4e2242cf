#include "engine/plan/planned_pieces.h"

#include "engine/geometry/polygon.h"
#include "engine/scene/colour.h"

#include <algorithm>
#include <map>

namespace hanei {
namespace {

double greatest_reflectance(const Scene& scene, const Face& face) {
    double greatest = 0.0;
    const auto include = [&](ObjectId id) {
        if (const Material* material = find_material(scene, id))
            for (const double band : band_reflectances(*material)) greatest = std::max(greatest, band);
    };
    include(face.material);
    for (const FaceArea& area : face.areas) include(area.material);
    return greatest;
}

}  // namespace

std::vector<PlannedPiece> planned_pieces(const Scene& scene, std::span<const Face> faces, const CostModel& cost) {
    std::vector<PlannedPiece> pieces(scene.furniture.size());
    std::map<ObjectId, PlannedPiece*> piece_of;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        pieces[k].object = scene.furniture[k].id;
        pieces[k].name = scene.furniture[k].name;
        piece_of[pieces[k].object] = &pieces[k];
    }
    std::vector<double> fewer(pieces.size(), 0.0);  // patches when it is black
    for (const Face& face : faces) {
        const auto found = piece_of.find(face.ref.object);
        if (found == piece_of.end()) continue;
        const double area = glm::length(vector_area(face.region));
        fewer[static_cast<std::size_t>(found->second - pieces.data())] +=
            CostModel::patches_of(area, cost.width) - CostModel::patches_of(area, wider_when_black * cost.width);
        found->second->area += area;
        found->second->reflectance = std::max(found->second->reflectance, greatest_reflectance(scene, face));
    }
    const double pairs = cost.factors_ms() + cost.patch_occlusion_ms();
    for (std::size_t k = 0; k < pieces.size(); ++k)  // their rows and columns
        pieces[k].predicted_ms = 2.0 * pairs * fewer[k] / std::max(cost.patches, 1.0);
    return pieces;
}

}  // namespace hanei
