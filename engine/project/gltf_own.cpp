#include "engine/project/gltf_own.h"

#include "engine/edit/arrangements.h"
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

/// What the luminaire stands by and where its node has it.
struct NodeAxes {
    Vec3 position, x, z;
    explicit NodeAxes(const GltfNode& node)
        : position(upright(Vec3{node.to_world[3]})),
          x(upright(Vec3{node.to_world[0]})),
          z(upright(Vec3{node.to_world[2]})) {}
    bool have_direction() const {
        const double size = glm::length(x) * glm::length(z);
        return size > 0.0 && glm::length(glm::cross(x, z)) > 1e-6 * size;
    }
};

/// Hangs the luminaire where its node is; false when it hangs there already.
bool hang(Luminaire& luminaire, const GltfNode& node) {
    const NodeAxes axes(node);
    const Placement placed = placement(luminaire);
    const bool there = agree(luminaire.position, axes.position);
    if (!there) luminaire.position = axes.position;
    if (!axes.have_direction()) return !there;
    const Vec3 c0 = glm::normalize(axes.x), up = glm::normalize(axes.z);
    const bool turned = !agree(placed.direction({1.0, 0.0, 0.0}), c0) || !agree(placed.direction({0.0, 0.0, 1.0}), up);
    if (turned) aim(luminaire, -up, c0);
    return turned || !there;
}

bool hangs_at(Luminaire luminaire, const GltfNode& node) { return !hang(luminaire, node); }

std::string names_of(const std::vector<std::string>& names) {
    constexpr std::size_t most = 5;
    std::string text;
    for (std::size_t k = 0; k < std::min(most, names.size()); ++k) text += (k == 0 ? "" : ", ") + json_quoted(names[k]);
    return names.size() > most ? text + ", ..." : text;
}

template <class Object>
bool holds(const std::vector<Object>& list, ObjectId id) {
    return std::any_of(list.begin(), list.end(), [id](const Object& object) { return object.id == id; });
}

bool holds(const Scene& scene, const GltfOwnNode& node) {
    if (node.kind == "furniture") return holds(scene.furniture, node.id);
    if (node.kind == "surface") return holds(scene.surfaces, node.id);
    if (node.kind == "luminaire") return holds(scene.luminaires, node.id);
    return scene.room && scene.room->id == node.id;
}

}  // namespace

GltfOwnNode own_node(const GltfDocument& document, std::size_t node) {
    const JsonValue* const own = own_extras(document.root().find("nodes")->items[node]);
    const JsonValue* const kind = own == nullptr ? nullptr : own->find("kind");
    const JsonValue* const id = own == nullptr ? nullptr : own->find("id");
    GltfOwnNode result;
    if (kind != nullptr && kind->is(JsonValue::Kind::text)) result.kind = kind->text;
    if (id != nullptr && is_id(*id)) result.id.value = static_cast<std::uint32_t>(id->number);
    return result;
}

void check_own_nodes(GltfDocument& document, const Scene* own) {
    const JsonValue* const nodes = document.root().find("nodes");
    if (nodes == nullptr) return;
    for (std::size_t k = 0; k < nodes->items.size(); ++k) {
        const JsonValue* const extras = own_extras(nodes->items[k]);
        if (extras == nullptr) continue;
        Fields fields(document.reading(), *extras, "nodes[" + std::to_string(k) + "].extras.hanei");
        std::string kind;
        if (!fields.optional("kind", kind)) continue;
        if (kind != "room" && kind != "furniture" && kind != "surface" && kind != "luminaire") {
            fields.error("kind", "found " + json_quoted(kind) +
                                     ", expected \"room\", \"furniture\", \"surface\" or \"luminaire\"");
            continue;
        }
        const JsonValue* const id = fields.take("id");
        if (id == nullptr) continue;
        if (!is_id(*id))
            fields.error("id", "found " + described(*id) + ", expected a whole number from 1 to 4294967294");
        else if (own != nullptr && !holds(*own, own_node(document, k)))
            fields.error("id", "found " + described(*id) + ", which is no " + kind + " of extras.hanei.project");
    }
}

std::optional<std::size_t> own_scene(GltfDocument& document) {
    const JsonValue* const own = own_extras(document.root());
    const JsonValue* const number = own == nullptr ? nullptr : own->find("scene");
    const JsonValue* const scenes = document.root().find("scenes");
    if (number == nullptr) return std::nullopt;
    return take_index(document.reading(), *number, "extras.hanei.scene", scenes == nullptr ? 0 : scenes->items.size());
}

std::optional<Project> own_project(GltfDocument& document) {
    const JsonValue* const own = own_extras(document.root());
    const JsonValue* const part = own == nullptr ? nullptr : own->find("project");
    JsonReading& reading = document.reading();
    if (part == nullptr || !names_no_file(reading, *part)) return std::nullopt;
    JsonReading its{reading.file, {}};
    std::optional<Project> project;
    if (part->find("format") == nullptr || is_readable_version(its, *part))
        project = read_project_fields(its, *part, {});
    if (project && !has_errors(its.findings))
        for (Diagnostic& finding : check_scene(project->scene))
            if (finding.severity == Severity::error) {  // warnings come with the scene
                finding.place.file = reading.file;
                finding.place.line = line_of(*part, finding.place.field);
                its.findings.push_back(std::move(finding));
            }
    const bool sound = project && !has_errors(its.findings);
    for (Diagnostic& finding : its.findings) {
        finding.place.field = "extras.hanei.project" + (finding.place.field.empty() ? "" : '.' + finding.place.field);
        reading.findings.push_back(std::move(finding));
    }
    if (!sound) project.reset();
    return project;
}

void place_own_luminaires(GltfDocument& document, const std::vector<GltfNode>& nodes, Scene& scene) {
    std::map<ObjectId, std::vector<const GltfNode*>> nodes_of;
    for (const GltfNode& node : nodes) {
        const GltfOwnNode own = own_node(document, node.number);
        if (own.kind == "luminaire" && own.id) nodes_of[own.id].push_back(&node);
    }
    std::vector<Luminaire> copies;
    std::vector<std::pair<ObjectId, std::string>> gone;
    bool any_moved = false;
    for (Luminaire& luminaire : scene.luminaires) {
        std::vector<const GltfNode*>& its = nodes_of[luminaire.id];
        if (its.empty()) {
            gone.emplace_back(luminaire.id, luminaire.name);
            continue;
        }
        std::stable_partition(its.begin(), its.end(), [&](const GltfNode* node) { return hangs_at(luminaire, *node); });
        for (std::size_t k = 1; k < its.size(); ++k) {
            Luminaire& copy = copies.emplace_back(luminaire);
            copy.id = scene.new_id();
            hang(copy, *its[k]);
        }
        any_moved = hang(luminaire, *its[0]) || any_moved;
    }
    std::move(copies.begin(), copies.end(), std::back_inserter(scene.luminaires));
    std::vector<std::string> names;
    for (const auto& [id, name] : gone) {
        scene = removed(std::move(scene), id);
        names.push_back(name);
    }
    tell_gone(document, names);
    if (any_moved) scene = with_arrangements_kept(std::move(scene));
}

void tell_gone(GltfDocument& document, const std::vector<std::string>& names) {
    if (names.empty()) return;
    document.reading().warn(document.root(), "nodes",
                            "no node shows " + names_of(names) + " any more; left out, with what refers to " +
                                (names.size() == 1 ? "it" : "them"));
}

}  // namespace hanei
