#include "engine/project/gltf_nodes.h"

#include "engine/project/gltf_document.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace hanei {
namespace {

const JsonValue no_nodes = json_list();

const JsonValue& list_of(const JsonValue& object, std::string_view key) {
    const JsonValue* const list = object.find(key);
    return list != nullptr ? *list : no_nodes;
}

std::string path_of(std::size_t node) { return "nodes[" + std::to_string(node) + ']'; }

/// Who is whose child, checked: a forest.
class Forest {
public:
    Forest(JsonReading& reading, const JsonValue& nodes) : reading_(reading), nodes_(nodes) {}

    bool read() {
        children_.resize(nodes_.items.size());
        parent_.resize(nodes_.items.size());
        for (std::size_t node = 0; node < nodes_.items.size(); ++node)
            if (!read_children(node)) return false;
        return has_no_cycle();
    }
    const std::vector<std::size_t>& children(std::size_t node) const { return children_[node]; }
    bool is_root(std::size_t node) const { return !parent_[node].has_value(); }

private:
    bool read_children(std::size_t node) {
        const JsonValue& list = list_of(nodes_.items[node], "children");
        const std::string path = path_of(node) + ".children";
        if (!take_list(reading_, list, path)) return false;
        for (std::size_t k = 0; k < list.items.size(); ++k) {
            const std::string place = path + '[' + std::to_string(k) + ']';
            const auto child = take_index(reading_, list.items[k], place, nodes_.items.size());
            if (!child) return false;
            if (parent_[*child]) {
                reading_.error(list.items[k], place, "node " + std::to_string(*child) + " has a parent already");
                return false;
            }
            parent_[*child] = node;
            children_[node].push_back(*child);
        }
        return true;
    }

    /// Walks up from every node; a walk that meets itself goes in a circle.
    bool has_no_cycle() {
        std::vector<std::size_t> walk_of(parent_.size(), 0);
        for (std::size_t node = 0; node < parent_.size(); ++node) {
            std::optional<std::size_t> at = node;
            while (at && walk_of[*at] == 0) {
                walk_of[*at] = node + 1;
                at = parent_[*at];
            }
            if (!at || walk_of[*at] != node + 1) continue;
            reading_.error(nodes_, "nodes", "node " + std::to_string(*at) + " is among its own children's children");
            return false;
        }
        return true;
    }

    JsonReading& reading_;
    const JsonValue& nodes_;
    std::vector<std::vector<std::size_t>> children_;
    std::vector<std::optional<std::size_t>> parent_;
};

/// The roots of the scene that is shown; without scenes, of everything.
std::optional<std::vector<std::size_t>> scene_roots(JsonReading& reading, const JsonValue& root, const Forest& forest,
                                                    std::optional<std::size_t> wanted) {
    const std::size_t count = list_of(root, "nodes").items.size();
    std::vector<std::size_t> roots;
    const JsonValue& scenes = list_of(root, "scenes");
    if (scenes.items.empty()) {
        for (std::size_t node = 0; node < count; ++node)
            if (forest.is_root(node)) roots.push_back(node);
        return roots;
    }
    const JsonValue* const shown = root.find("scene");
    const auto number = wanted             ? wanted
                        : shown == nullptr ? std::optional<std::size_t>{0}
                                           : take_index(reading, *shown, "scene", scenes.items.size());
    if (!number) return std::nullopt;
    const std::string path = "scenes[" + std::to_string(*number) + "].nodes";
    const JsonValue& list = list_of(scenes.items[*number], "nodes");
    if (!take_list(reading, list, path)) return std::nullopt;
    std::vector<bool> taken(count, false);
    for (std::size_t k = 0; k < list.items.size(); ++k) {
        const std::string place = path + '[' + std::to_string(k) + ']';
        const auto node = take_index(reading, list.items[k], place, count);
        if (!node) return std::nullopt;
        const bool again = taken[*node];
        if (again || !forest.is_root(*node)) {
            reading.error(list.items[k], place,
                          "node " + std::to_string(*node) +
                              (again ? " stands in the scene twice" : " has a parent; a scene lists the others alone"));
            return std::nullopt;
        }
        taken[*node] = true;
        roots.push_back(*node);
    }
    return roots;
}

/// `target.size()` numbers, or the target as it is when the field is absent.
template <std::size_t count>
bool take_numbers(Fields& fields, std::string_view key, std::array<double, count>& target) {
    std::vector<double> numbers;
    if (!fields.has(key)) return true;
    if (!fields.optional(key, numbers)) return false;
    if (numbers.size() != count) {
        fields.error(key, "expected " + std::to_string(count) + " numbers");
        return false;
    }
    std::copy(numbers.begin(), numbers.end(), target.begin());
    return true;
}

bool all_finite(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row])) return false;
    return true;
}

std::optional<glm::dmat4> local_matrix(Fields& fields) {
    if (fields.has("matrix")) {
        std::array<double, 16> m{};
        if (!take_numbers(fields, "matrix", m)) return std::nullopt;
        return glm::dmat4{m[0], m[1], m[2],  m[3],  m[4],  m[5],  m[6],  m[7],
                          m[8], m[9], m[10], m[11], m[12], m[13], m[14], m[15]};
    }
    std::array<double, 3> translation{};
    std::array<double, 4> rotation{0.0, 0.0, 0.0, 1.0};
    std::array<double, 3> scale{1.0, 1.0, 1.0};
    const bool taken = take_numbers(fields, "translation", translation) && take_numbers(fields, "rotation", rotation) &&
                       take_numbers(fields, "scale", scale);
    if (!taken) return std::nullopt;
    const glm::dquat turn{rotation[3], rotation[0], rotation[1], rotation[2]};
    const double length = glm::length(turn);
    constexpr double least = 1e-3;  // a unit quaternion is asked for; files round it
    if (!(length > least && length < 1.0 / least)) {
        fields.error("rotation", "a unit quaternion [x, y, z, w] is needed");
        return std::nullopt;
    }
    const glm::dmat4 moved = glm::translate(glm::dmat4{1.0}, Vec3{translation[0], translation[1], translation[2]});
    return glm::scale(moved * glm::mat4_cast(turn / length), Vec3{scale[0], scale[1], scale[2]});
}

}  // namespace

std::vector<GltfNode> placed_nodes(JsonReading& reading, const JsonValue& root, std::optional<std::size_t> scene) {
    const JsonValue& nodes = list_of(root, "nodes");
    if (!take_list(reading, nodes, "nodes")) return {};
    Forest forest{reading, nodes};
    if (!forest.read()) return {};
    const auto roots = scene_roots(reading, root, forest, scene);
    if (!roots) return {};
    std::vector<GltfNode> placed;
    std::vector<GltfNode> waiting;
    const auto wait = [&](const std::vector<std::size_t>& children, const glm::dmat4& to_world,
                          std::optional<std::size_t> parent) {
        for (auto child = children.rbegin(); child != children.rend(); ++child)
            waiting.push_back({*child, to_world, parent});
    };
    wait(*roots, glm::dmat4{1.0}, {});
    while (!waiting.empty()) {
        GltfNode node = waiting.back();
        waiting.pop_back();
        Fields fields(reading, nodes.items[node.number], path_of(node.number));
        const auto local = local_matrix(fields);
        if (!local) return {};
        node.to_world = node.to_world * *local;
        if (!all_finite(node.to_world)) {
            reading.error(fields.value(), fields.path(), "where it stands is too far away for a number");
            return {};
        }
        wait(forest.children(node.number), node.to_world, node.number);
        placed.push_back(node);
    }
    return placed;
}

}  // namespace hanei
