/// Furniture and rooms of glTF 2.0 files (.gltf, .glb) as a scene.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/plan/settings.h"
#include "engine/project/gltf_uri.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <string_view>

namespace hanei {

enum class GltfUpAxis { y, z };                      ///< y is glTF's own
enum class GltfKind { automatic, furniture, room };  ///< automatic: what looks like a room is one

struct GltfImportOptions {
    double metres_per_unit = 1.0;  ///< glTF's own unit is the metre
    GltfUpAxis up = GltfUpAxis::y;
    GltfKind kind = GltfKind::automatic;
    double weld = 0.0;  ///< m: places nearer to each other are one; 0: mesh_object chooses
};

struct GltfImport {
    std::optional<Scene> scene;        ///< empty with errors: nothing is half imported
    std::optional<Settings> settings;  ///< of the project that the exporter wrote
    Vec3 size{0.0};                    ///< m, of the meshes' bounds
    int solids = 0, sheets = 0, luminaires = 0;
    Diagnostics findings;
};

/// The scene that the file shows first:
///
///   - every top-level node with meshes below it becomes one piece of furniture of its closed shells
///     (mesh_shapes.h), standing on the middle of its footprint and turned as its node; open ones become
///     free surfaces. A lone empty root above lights or a room, or named as converters
///     name it, is no object: its children are.
///   - the room's shell (mesh_room.h) becomes the Room if it is an extruded plan, else free surfaces
///     that face inward. Shells around it are left out.
///   - lights become luminaires where their nodes hang them (gltf_lights.h).
///   - what the exporter wrote (gltf_export.h) comes back as it was, where the meshes still agree.
///
/// Returns   a scene that check_scene passes, with ids of its own; a finding with its JSON path for all
///           that was repaired, simplified or left out, and for a model larger than 100 m or smaller
///           than 5 cm the unit it was probably drawn in.
/// Cost      about a second for 100 000 triangles.
GltfImport import_gltf(std::string_view bytes, std::string_view name, const GltfNeighbour& neighbour,
                       const GltfImportOptions& wanted);

/// The same from a file of at most 256 MB.
GltfImport import_gltf(const std::filesystem::path& file, const GltfImportOptions& wanted);

}  // namespace hanei
