#include "engine/project/gltf_objects.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace hanei {
namespace {

/// How converters call the root that they put above everything.
bool is_wrapper(const std::string& name) {
    constexpr std::string_view names[] = {
        "Sketchfab_model", "RootNode", "GLTF_SceneRootNode", "AuxScene", "root", "Root", "Scene", "scene",
        "world",           "World"};
    return std::any_of(std::begin(names), std::end(names), [&](std::string_view known) { return known == name; }) ||
           name.ends_with(".fbx") || name.ends_with(".obj") || name.ends_with(".dae");
}

class Grouping {
public:
    Grouping(GltfDocument& document, const std::vector<GltfNode>& nodes) : document_(document), nodes_(nodes) {
        for (const GltfNode& node : nodes_) {
            if (node.parent)
                children_[*node.parent].push_back(&node);
            else
                roots_.push_back(&node);
        }
    }

    /// Top-level nodes; and of every node the top-level node above it.
    void find(bool look_into_root) {
        std::size_t levels = 0;
        while (roots_.size() == 1 && levels++ < nodes_.size()) {
            const JsonValue& object = json(*roots_[0]);
            const auto children = children_.find(roots_[0]->number);
            const bool empty = object.find("mesh") == nullptr && object.find("extensions") == nullptr;
            if (!empty || children == children_.end()) break;
            if (!look_into_root && !is_wrapper(name_of(*roots_[0]))) break;
            roots_ = children->second;
        }
        for (const GltfNode& node : nodes_)
            if (is_own_object(node) && std::find(roots_.begin(), roots_.end(), &node) == roots_.end())
                roots_.push_back(&node);
        for (const GltfNode* const root : roots_) top_[root->number] = root->number;
        for (const GltfNode& node : nodes_)
            if (node.parent && top_.count(node.number) == 0 && top_.count(*node.parent) > 0)
                top_[node.number] = top_[*node.parent];
    }

    /// Lamps are no objects: they hang below whatever their node is below.
    bool is_own_object(const GltfNode& node) const {
        const std::string kind = own_node(document_, node.number).kind;
        return kind == "room" || kind == "furniture" || kind == "surface";
    }

    const std::vector<const GltfNode*>& roots() const { return roots_; }

    bool is_below(std::size_t node, std::size_t root) const {
        const auto found = top_.find(node);
        return found != top_.end() && found->second == root;
    }

    const JsonValue& json(const GltfNode& node) const { return document_.root().find("nodes")->items[node.number]; }

    std::string name_of(const GltfNode& node) const {
        const JsonValue* const name = json(node).find("name");
        if (name != nullptr && !name->text.empty()) return name->text;
        const JsonValue* const index = json(node).find("mesh");
        const JsonValue* const meshes = document_.root().find("meshes");
        const bool has_mesh =
            index != nullptr && meshes != nullptr && index->number < static_cast<double>(meshes->items.size());
        const JsonValue* const own =
            has_mesh ? meshes->items[static_cast<std::size_t>(index->number)].find("name") : nullptr;
        return own != nullptr && !own->text.empty() ? own->text : "node " + std::to_string(node.number);
    }

private:
    GltfDocument& document_;
    const std::vector<GltfNode>& nodes_;
    std::map<std::size_t, std::vector<const GltfNode*>> children_;
    std::vector<const GltfNode*> roots_;
    std::map<std::size_t, std::size_t> top_;
};

/// About the vertical, of a node that does not tilt; else 0.
double bearing_of(const GltfNode& node, const GltfAxes& axes) {
    constexpr double level = 1e-6;
    const Vec3 x = axes.direction(Vec3{node.to_world[0]});
    const Vec3 up = axes.direction(Vec3{axes.z_up ? node.to_world[2] : node.to_world[1]});
    const bool upright = glm::length(Vec2{up}) <= level * glm::length(up) && std::abs(x.z) <= level * glm::length(x);
    return upright ? std::atan2(x.y, x.x) : 0.0;
}

void append(TriangleSoup& soup, const GltfPrimitive& primitive, const GltfAxes& axes, int label) {
    const auto first = static_cast<int>(soup.vertices.size());
    for (const Vec3& vertex : primitive.vertices) soup.vertices.push_back(axes.place(vertex));
    for (const auto& corners : primitive.triangles) {
        Triangle& triangle = soup.triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) triangle.corner[k] = first + static_cast<int>(corners[k]);
        triangle.label = label;
    }
}

}  // namespace

std::vector<GltfObject> gltf_objects(GltfDocument& document, const std::vector<GltfNode>& nodes,
                                     const std::vector<GltfPrimitive>& primitives, const GltfAxes& axes,
                                     const std::function<int(std::optional<std::size_t>)>& label_of,
                                     bool look_into_root, double weld) {
    Grouping grouping(document, nodes);
    grouping.find(look_into_root);
    std::vector<GltfObject> objects;
    for (const GltfNode* const root : grouping.roots()) {
        GltfObject object{grouping.name_of(*root),
                          "nodes[" + std::to_string(root->number) + ']',
                          grouping.json(*root).line,
                          own_node(document, root->number),
                          axes.place(Vec3{root->to_world[3]}),
                          bearing_of(*root, axes),
                          {}};
        const bool own = grouping.is_own_object(*root);
        const JsonValue* const name = grouping.json(*root).find("name");
        object.named = name != nullptr && !name->text.empty();
        object.to_world = root->to_world;
        std::vector<TriangleSoup> soups;
        for (const GltfPrimitive& primitive : primitives) {
            if (!grouping.is_below(primitive.node, root->number)) continue;
            if (soups.empty() || object.own.kind == "furniture") soups.emplace_back();
            append(soups.back(), primitive, axes, label_of(primitive.material));
            if (own) append(object.shown, primitive, axes, label_of(primitive.material));
        }
        for (TriangleSoup& soup : soups) object.meshes.push_back(mesh_object(object.name, std::move(soup), weld));
        if (own || !object.meshes.empty()) objects.push_back(std::move(object));
    }
    return objects;
}

}  // namespace hanei
