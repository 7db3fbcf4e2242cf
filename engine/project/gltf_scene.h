/// The scene that grows out of a glTF file's objects, lights and materials.
#pragma once

#include "engine/project/gltf_import.h"
#include "engine/project/gltf_lights.h"
#include "engine/project/gltf_objects.h"
#include "engine/project/gltf_own_objects.h"

#include <map>

namespace hanei {

class GltfScene {
public:
    /// `own`: what the exporter wrote beside the meshes, not yet held against them.
    GltfScene(GltfDocument& document, GltfKind kind, std::optional<Scene> own);

    /// The number by which triangles know a material of the file; none: of those without.
    int label_of(std::optional<std::size_t> material);

    void add(std::vector<GltfLight> lights);
    void add(const std::vector<GltfObject>& objects);

    /// The scene and its counts; an error when there is nothing in it.
    void finish(GltfImport& result);

private:
    ObjectId material_in_scene(Material material);
    ObjectId own_material(const Material& material);
    ObjectId photometry_in_scene(Photometry photometry);
    const TriangleShell* find_room(const std::vector<GltfObject>& objects);
    void add_read(const GltfObject& object);
    void make_room(const GltfObject& object, const MeshObject& mesh, const TriangleShell& shell);
    void add_object(GltfObject object);
    void add_furniture(const GltfObject& object, std::vector<MeshSolid> solids);
    void add_sheet(const GltfObject& object, FreeSurface sheet);
    void group(const GltfObject& object);
    void tell(const GltfObject& object, Severity severity, const std::string& sentence);

    GltfDocument& document_;
    GltfKind kind_;
    Scene scene_;
    std::optional<GltfOwnObjects> own_;
    std::set<ObjectId> repainted_;     ///< of the exporter's materials
    std::vector<ObjectId> of_object_;  ///< made of the meshes of one node
    std::vector<Vec3> light_places_;
    std::map<std::optional<std::size_t>, int> labels_;
    std::vector<GltfMaterial> materials_;  ///< by label
    const TriangleShell* room_ = nullptr;
};

}  // namespace hanei
