#include "engine/project/gltf_own.h"

#include "engine/project/luminaire_axes.h"
#include "engine/project/project_reader.h"
#include "engine/scene/placement.h"
#include "engine/scene/scene_check.h"

#include <algorithm>
#include <map>

namespace hanei {
namespace {

const JsonValue* own_extras(const JsonValue& object) {
    const JsonValue* const extras = object.find("extras");
    const JsonValue* const own = extras == nullptr ? nullptr : extras->find("hanei");
    return own != nullptr && own->is(JsonValue::Kind::object) ? own : nullptr;
}

/// Photometries of the part hold their tables: none is read from another file.
bool names_no_file(JsonReading& reading, const JsonValue& part) {
    const JsonValue* const list = part.find("photometries");
    if (list == nullptr) return true;
    for (std::size_t k = 0; k < list->items.size(); ++k) {
        const JsonValue* const file = list->items[k].find("file");
        if (file == nullptr) continue;
        reading.error(*file, "extras.hanei.project.photometries[" + std::to_string(k) + "].file",
                      "a photometry names another file; only tables are read here");
        return false;
    }
    return true;
}

bool agree(const Vec3& a, const Vec3& b) {
    constexpr double single_precision = 1e-6;
    return glm::distance(a, b) <= single_precision * (1.0 + glm::length(a));
}

Vec3 upright(const Vec3& v) { return {v.x, -v.z, v.y}; }

}  // namespace

GltfOwnNode own_node(GltfDocument& document, std::size_t node) {
    GltfOwnNode result;
    const JsonValue* const own = own_extras(document.root().find("nodes")->items[node]);
    if (own == nullptr) return result;
    Fields fields(document.reading(), *own, "nodes[" + std::to_string(node) + "].extras.hanei");
    int id = 0;
    fields.optional("kind", result.kind);
    fields.optional("id", id);
    result.luminaire.value = static_cast<std::uint32_t>(std::max(0, id));
    if (fields.optional("exitance_lm_m2", result.own_exitance.value) && !(result.own_exitance.value >= 0.0))
        fields.error("exitance_lm_m2", "found " + described(*own->find("exitance_lm_m2")) + ", it cannot be negative");
    return result;
}

std::optional<std::size_t> own_scene(GltfDocument& document) {
    const JsonValue* const own = own_extras(document.root());
    const JsonValue* const number = own == nullptr ? nullptr : own->find("scene");
    const JsonValue* const scenes = document.root().find("scenes");
    if (number == nullptr) return std::nullopt;
    return take_index(document.reading(), *number, "extras.hanei.scene", scenes == nullptr ? 0 : scenes->items.size());
}

std::optional<Scene> own_project(GltfDocument& document) {
    const JsonValue* const own = own_extras(document.root());
    const JsonValue* const part = own == nullptr ? nullptr : own->find("project");
    JsonReading& reading = document.reading();
    if (part == nullptr || !names_no_file(reading, *part)) return std::nullopt;
    const std::size_t before = reading.findings.size();
    Fields fields(reading, *part, "");
    SceneReader reader{reading, {}, {}, {}};
    reader.scene.last_id = greatest_id(*part);
    fields.optional("title", reader.scene.title);
    fields.optional("maintenance_factor", reader.scene.maintenance_factor);
    read_materials(reader, fields);
    read_room(reader, fields);
    read_photometries(reader, fields);
    read_control_groups(reader, fields);
    read_luminaires(reader, fields);
    read_calculation(reader, fields);
    read_views(reader, fields);
    const auto is_new_error = [](const Diagnostic& finding) { return finding.severity == Severity::error; };
    const bool readable = std::none_of(reading.findings.begin() + static_cast<std::ptrdiff_t>(before),
                                       reading.findings.end(), is_new_error);
    for (std::size_t k = before; k < reading.findings.size(); ++k)
        reading.findings[k].place.field = "extras.hanei.project." + reading.findings[k].place.field;
    for (Diagnostic& finding : readable ? check_scene(reader.scene) : Diagnostics{}) {
        if (finding.severity != Severity::error) continue;  // warnings come with the scene
        finding.place = {reading.file, part->line, "extras.hanei.project." + finding.place.field, 0};
        reading.findings.push_back(std::move(finding));
    }
    return has_errors(reading.findings) ? std::nullopt : std::optional{std::move(reader.scene)};
}

void place_own_luminaires(GltfDocument& document, const std::vector<GltfNode>& nodes, Scene& scene) {
    std::map<ObjectId, const GltfNode*> node_of;
    for (const GltfNode& node : nodes) {
        const GltfOwnNode own = own_node(document, node.number);
        if (own.kind == "luminaire") node_of[own.luminaire] = &node;
    }
    std::erase_if(scene.luminaires, [&](Luminaire& luminaire) {
        const auto found = node_of.find(luminaire.id);
        if (found == node_of.end()) return true;
        const glm::dmat4& there = found->second->to_world;
        const Vec3 x = upright(Vec3{there[0]}), z = upright(Vec3{there[2]});
        const Placement placed = placement(luminaire);
        const Vec3 position = upright(Vec3{there[3]});
        if (!agree(luminaire.position, position)) luminaire.position = position;
        const double size = glm::length(x) * glm::length(z);
        if (!(glm::length(glm::cross(x, z)) > 1e-6 * size) || !(size > 0.0)) return false;  // no direction to take
        const Vec3 c0 = glm::normalize(x), up = glm::normalize(z);
        if (!agree(placed.direction({1.0, 0.0, 0.0}), c0) || !agree(placed.direction({0.0, 0.0, 1.0}), up))
            aim(luminaire, -up, c0);
        return false;
    });
}

}  // namespace hanei
