/// The parts of a project file, each read into the scene. One reader a part.
#pragma once

#include "engine/plan/settings.h"
#include "engine/project/json_fields.h"
#include "engine/project/project_file.h"
#include "engine/scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace hanei {

inline constexpr int project_version = 1;

/// A scene on its way in.
struct SceneReader {
    JsonReading& reading;
    std::filesystem::path folder;  ///< what relative photometric files are beside
    Scene scene;
    std::map<std::uint32_t, std::string> ids;  ///< given so far, and to which object

    /// The object's "id", unique in the file; a new one when the file gives none.
    ObjectId take_id(Fields& fields);
};

/// Whether this is a project and of no later version than this program; an error when not.
bool is_readable_version(JsonReading& reading, const JsonValue& root);

/// All parts, windings and furniture models put right; not yet held against check_scene.
Project read_project_fields(JsonReading& reading, const JsonValue& root, const std::filesystem::path& folder);

/// Whether the value can be an object's id.
bool is_id(const JsonValue& value);
/// The greatest id the file gives to an object, so that new ones start above it.
std::uint32_t greatest_id(const JsonValue& root);

// In this order: references go to what was read before.
void read_materials(SceneReader& reader, Fields& root);
void read_room(SceneReader& reader, Fields& root);
void read_furniture(SceneReader& reader, Fields& root);
void read_surfaces(SceneReader& reader, Fields& root);
void read_photometries(SceneReader& reader, Fields& root);
void read_control_groups(SceneReader& reader, Fields& root);
void read_luminaires(SceneReader& reader, Fields& root);
void read_light_scenes(SceneReader& reader, Fields& root);
void read_arrangements(SceneReader& reader, Fields& root);
void read_object_groups(SceneReader& reader, Fields& root);
void read_calculation(SceneReader& reader, Fields& root);  ///< grids and points
void read_views(SceneReader& reader, Fields& root);
void read_colour_scale(SceneReader& reader, Fields& root);

/// Unknown settings come back as a member "settings" of `kept`.
void read_settings(Settings& settings, Fields& root, JsonValue& kept);

/// A reference by unique name or by id; missing, unknown and ambiguous ones are noted.
ObjectId take_material(SceneReader& reader, Fields& fields, std::string_view key);
ObjectId material_of(SceneReader& reader, const JsonValue& value, const std::string& path);
ObjectId take_photometry(SceneReader& reader, Fields& fields, std::string_view key);
/// A name that no control group has yet makes one; absent or empty it is none.
ObjectId take_control_group(SceneReader& reader, Fields& fields, std::string_view key);
ObjectId take_known_control_group(SceneReader& reader, Fields& fields, std::string_view key);
ObjectId luminaire_of(SceneReader& reader, const JsonValue& value, const std::string& path);

/// Adds a child's unknown fields to those kept with its parent.
void keep_unknown(Fields& child, std::string_view key, JsonValue& kept);
/// A parent's own unknown fields and those kept for its children, as text.
std::string unknown_of(Fields& fields, JsonValue kept);

}  // namespace hanei
