/// The parts of a reference case, each read into the scene.
#pragma once

#include "engine/project/json_fields.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <map>
#include <string>

namespace hanei {

/// The scene of a case on its way in.
struct ReferenceScene {
    JsonReading& reading;
    std::filesystem::path folder;  ///< what photometric files are beside
    Scene scene;
    std::map<double, ObjectId> materials;          ///< by reflectance: black comes first
    std::map<std::string, ObjectId> photometries;  ///< by file name
    std::string unsupported;                       ///< why the case cannot be computed

    ObjectId material(double reflectance);
};

/// Surfaces become free surfaces named by their ids.
void read_reference_surfaces(ReferenceScene& target, Fields& scene);

/// Sources become luminaires; a parallel beam becomes exitance of the one surface it lights.
void read_reference_sources(ReferenceScene& target, Fields& scene);

/// An outline with its holes, which may run either way in the file.
Region take_reference_region(Fields& fields);

/// Null when there is none of that name.
FreeSurface* find_surface(Scene& scene, const std::string& name);

}  // namespace hanei
