#include "engine/mesh/contact.h"
#include "engine/mesh/mesh.h"
#include "engine/mesh/pieces.h"
#include "engine/plan/places.h"

#include <numeric>

namespace hanei {

OccluderSet occluders_of(const Scene& scene) {
    const Contacts contacts(scene);
    std::vector<ConvexBody> bodies;
    for (const SolidBody& solid : contacts.solids()) bodies.push_back(solid.body);
    const std::vector<Vec3> places = places_of(scene, contacts.faces());
    for (std::size_t f = 0; f < contacts.faces().size(); ++f) {
        if (contacts.solid_of(f) >= 0) continue;
        const Face& face = contacts.faces()[f];
        if (!has_something_behind(face, places, contacts.same_place())) continue;
        for (Polygon& piece : pieces_of(face.region, face.normal)) {
            std::vector<int> loop(piece.size());
            std::iota(loop.begin(), loop.end(), 0);
            bodies.push_back({std::move(piece), {std::move(loop)}, face.ref.object.value});
        }
    }
    for (const ConvexBody& opening : contacts.openings()) bodies.push_back(opening);
    return OccluderSet(std::move(bodies));
}

}  // namespace hanei
