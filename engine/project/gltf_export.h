/// A project as a glTF 2.0 file for other programs, and with its light as colours at vertices.
#pragma once

#include "engine/base/diagnostic.h"
#include "engine/project/project_file.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hanei {

/// Surfaces of one object in the colours of their light.
struct LitSurface {
    ObjectId object;
    std::vector<Vec3> places;                             ///< m, in the scene's coordinates
    std::vector<std::array<float, 3>> colours;            ///< linear red, green and blue, 0 to 1; one a place
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise seen from the lit side
};

/// The light of a whole scene as colours.
struct LitPicture {
    std::vector<LitSurface> surfaces;  ///< one an object
    std::string colours;               ///< "photo", "false-colour"
    double low = 0.0, high = 0.0;      ///< lx, ends of the scale of false colours
};

/// The scene in metres, y up, as programs that read glTF expect it:
///
///   - a node an object, with its name: the room's faces seen from inside, furniture where it stands, free
///     surfaces; baseColorFactor is reflectance x tint, emissive surfaces state their luminance
///     (KHR_materials_emissive_strength);
///   - a node a luminaire: its opening, and a light of KHR_lights_punctual of the same luminous flux, a
///     point, or a spot of a half space (I0 cos^2) where less than a twentieth goes upward; beside it the
///     intensities themselves as a profile of EXT_lights_ies (ies_profile.h), times what it burns at;
///   - with a `picture`, a scene that is shown first in which the objects have its colours (COLOR_0,
///     KHR_materials_unlit), beside the plain one;
///   - what import_gltf needs to give the same project back (gltf_own.h). Nothing of it is left out.
///
/// Returns   the file's bytes: binary (.glb) or text with its buffer in it (.gltf).
std::string gltf_file(const Project& project, const LitPicture* picture, bool binary);

/// Written whole or not at all; binary unless the name ends in .gltf. Returns what went wrong, or nothing.
std::optional<Diagnostic> write_gltf(const Project& project, const LitPicture* picture,
                                     const std::filesystem::path& file);

}  // namespace hanei
