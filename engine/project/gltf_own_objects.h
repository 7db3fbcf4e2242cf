/// Objects the exporter wrote, held against what the file shows of them now.
#pragma once

#include "engine/project/gltf_material.h"
#include "engine/project/gltf_objects.h"

#include <functional>
#include <map>
#include <set>

namespace hanei {

/// The meshes win:
///
///   - a node that shows its object as it was written changes nothing, bit by bit;
///   - one that shows it moved and turned moves it: furniture about the vertical, surfaces in any way;
///   - one whose mesh or materials were changed is read as any mesh is. The object keeps its id, name and
///     groups; furniture loses its model, a room its sub-areas, which is said;
///   - a copy of a node is a copy of its object;
///   - objects that no node shows any more are left out with what refers to them, which is said.
class GltfOwnObjects {
public:
    /// `scene` is what was written, and is changed. `material_of` gives the material of a label.
    GltfOwnObjects(GltfDocument& document, Scene& scene, std::function<const GltfMaterial&(int)> material_of);

    /// Settles what can be settled without reading meshes.
    /// Returns   the objects whose meshes are to be read, those of other programs among them.
    std::vector<const GltfObject*> rest_of(const std::vector<GltfObject>& objects);

    // What the meshes of this node are to be read into; null when they make something new.
    Furniture* furniture_of(const GltfObject& object);
    FreeSurface* surface_of(const GltfObject& object);
    Room* room_of(const GltfObject& object);

    /// Takes out what no node shows.
    void finish();

private:
    bool settles(const GltfObject& object, bool as_written);
    bool settles_room(const GltfObject& object, bool as_written);
    template <class Object>
    bool settles_one_of(std::vector<Object>& list, const GltfObject& object, bool as_written);
    TriangleSoup shown_by(const GltfObject& object) const;
    bool is_claimed(ObjectId id) const { return claimed_.count(id) > 0; }
    ObjectId read_into(const GltfObject& object);
    void change(const GltfObject& object, const std::string& loses);

    GltfDocument& document_;
    Scene& scene_;
    std::function<const GltfMaterial&(int)> material_of_;
    std::vector<std::pair<ObjectId, std::string>> written_;
    std::set<ObjectId> claimed_;               ///< shown by a node
    std::map<std::string, ObjectId> changed_;  ///< whose meshes are to be read
    std::set<ObjectId> unread_;                ///< of those
};

}  // namespace hanei
