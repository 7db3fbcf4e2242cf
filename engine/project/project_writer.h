/// A project as a JSON tree, in the order in which people read it.
#pragma once

#include "engine/project/json_value.h"
#include "engine/project/project_file.h"

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

namespace hanei {

/// How an object is referred to: by its name when that is unique, else by its id.
class References {
public:
    template <class Object>
    explicit References(const std::vector<Object>& objects) {
        std::map<std::string_view, int> uses;
        for (const Object& object : objects) ++uses[object.name];
        for (const Object& object : objects)
            if (!object.name.empty() && uses[object.name] == 1) names_.emplace(object.id.value, object.name);
    }
    JsonValue of(ObjectId id) const;

private:
    std::map<std::uint32_t, std::string> names_;
};

JsonValue json_of(const Project& project);
JsonValue json_of(const Photometry& photometry);
JsonValue json_of(const Luminaire& luminaire, const References& photometries, const References& groups);
JsonValue json_of(const ControlGroup& group);
JsonValue json_of(const ObjectGroup& group);
JsonValue json_of(const LightScene& light_scene, const References& groups);
JsonValue json_of(const Arrangement& arrangement, const References& luminaires);
JsonValue json_of(const Room& room, const References& materials);
JsonValue json_of(const Furniture& furniture, const References& materials);
JsonValue json_of(const FreeSurface& surface, const References& materials);
JsonValue json_of(const Settings& settings);
JsonValue json_of(const Material& material);
JsonValue json_of(const CalculationGrid& grid);
JsonValue json_of(const CalculationPoint& point);
JsonValue json_of(const View& view);
JsonValue json_of(const ColourScale& scale);

JsonValue json_of(double number);
JsonValue json_of(int number);
JsonValue json_of(const std::string& text);
JsonValue json_of(const Vec2& vector);
JsonValue json_of(const Vec3& vector);
template <class T>
JsonValue json_of(const std::vector<T>& values) {
    JsonValue list = json_list();
    list.items.reserve(values.size());
    for (const T& value : values) list.items.push_back(json_of(value));
    return list;
}

/// Why the tree cannot be written to the file: it holds a figure that is infinite or no number.
std::optional<Diagnostic> unwritable(const JsonValue& root, const std::filesystem::path& file);

/// {"id": ..., "name": ...}, what every object begins with.
JsonValue json_object(ObjectId id, const std::string& name);
void add_region(JsonValue& object, const Region& region);
void add_angle(JsonValue& object, std::string_view key, double angle);  ///< left out when exactly 0
/// Puts back the fields that no version so far knows.
void add_unknown(JsonValue& object, const UnknownFields& unknown);

}  // namespace hanei
