#include "engine/project/gltf_pieces.h"

#include "engine/base/tolerance.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/opening_shape.h"

#include <algorithm>

namespace hanei {
namespace {

/// What later areas leave of convex pieces.
std::vector<Polygon> uncovered(std::vector<Polygon> pieces, const std::vector<FaceArea>& areas, std::size_t from,
                               double thickness) {
    for (std::size_t k = from; k < areas.size(); ++k) {
        std::vector<Polygon> left;
        for (const Polygon& piece : pieces)
            for (Polygon& rest : subtracted(piece, areas[k].outline, thickness)) left.push_back(std::move(rest));
        pieces = std::move(left);
    }
    return pieces;
}

const Photometry* photometry_of(const Luminaire& luminaire, const Scene& scene) {
    const auto* const measured = std::get_if<Measured>(&luminaire.distribution);
    if (measured == nullptr) return nullptr;
    const auto found = std::find_if(scene.photometries.begin(), scene.photometries.end(),
                                    [&](const Photometry& each) { return each.id == measured->photometry; });
    return found == scene.photometries.end() ? nullptr : &*found;
}

}  // namespace

void TriangleList::add(const Polygon& convex) {
    const auto first = static_cast<std::uint32_t>(places.size());
    places.insert(places.end(), convex.begin(), convex.end());
    for (std::uint32_t k = 2; k < convex.size(); ++k) corners.insert(corners.end(), {first, first + k - 1, first + k});
}

void TriangleList::add(const Region& region) {
    for (const Polygon& piece : convex_pieces(region)) add(piece);
}

std::map<ObjectId, TriangleList> room_pieces(const Scene& scene) {
    std::map<ObjectId, TriangleList> lists;
    if (!scene.room) return lists;
    Scene alone;
    alone.room = scene.room;
    for (const Face& face : faces_of(alone)) {
        const double thickness = tolerance::same_place * diameter(face.region.outline);
        for (const Polygon& piece : uncovered(convex_pieces(face.region), face.areas, 0, thickness))
            lists[face.material].add(piece);
        for (std::size_t k = 0; k < face.areas.size(); ++k)
            for (const Polygon& piece : uncovered({face.areas[k].outline}, face.areas, k + 1, thickness))
                lists[face.areas[k].material].add(piece);
    }
    return lists;
}

std::vector<TriangleList> furniture_pieces(const Furniture& furniture) {
    Scene alone;
    alone.furniture.push_back(furniture);
    alone.furniture[0].position = Vec3{0.0};
    alone.furniture[0].rotation = 0.0;
    std::vector<TriangleList> lists;
    for (const Shell& shell : shells_of(alone)) {
        TriangleList& list = lists.emplace_back();
        for (const std::vector<int>& face : shell.faces) {
            Region region;
            for (const int vertex : face) region.outline.push_back(shell.vertices[static_cast<std::size_t>(vertex)]);
            list.add(region);
        }
    }
    return lists;
}

TriangleList opening_pieces(const Luminaire& luminaire, const Scene& scene) {
    TriangleList list;
    if (const auto* const polygon = std::get_if<PolygonOpening>(&luminaire.opening)) list.add(polygon->region);
    if (const auto* const solid = std::get_if<PolyhedronOpening>(&luminaire.opening))
        for (const std::vector<int>& face : solid->faces) {
            Region region;
            for (const int vertex : face) region.outline.push_back(solid->vertices[static_cast<std::size_t>(vertex)]);
            list.add(region);
        }
    const Photometry* const photometry = photometry_of(luminaire, scene);
    if (std::holds_alternative<MeasuredOpening>(luminaire.opening) && photometry != nullptr) {
        const Polygon flat = flat_opening(photometry->opening);
        if (flat.size() >= 3) list.add(flat);
    }
    return list;
}

}  // namespace hanei
