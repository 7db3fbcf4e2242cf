#include "engine/edit/furniture_edits.h"

#include "engine/edit/free_place.h"
#include "engine/edit/material_palette.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

std::string numbered_name(const Scene& scene, std::string_view label) {
    for (std::size_t k = 1;; ++k) {
        const std::string name = k == 1 ? std::string(label) : fmt::format("{} {}", label, k);
        const auto taken = [&](const Furniture& furniture) { return furniture.name == name; };
        if (std::none_of(scene.furniture.begin(), scene.furniture.end(), taken)) return name;
    }
}

/// A column reaches from the floor to the ceiling unless somebody said how high it is.
FurnitureModel fitted(const Scene& scene, FurnitureModel model) {
    const auto is_height = [](const ModelSize& size) { return size.name == "height"; };
    const bool column = model.kind == "column" || model.kind == "round-column";
    if (column && scene.room && std::none_of(model.sizes.begin(), model.sizes.end(), is_height))
        model.sizes.push_back({"height", scene.room->height});
    return model;
}

bool same_shape(const Part& a, const Part& b) {
    return a.shape == b.shape && a.position == b.position && a.rotation == b.rotation;
}

}  // namespace

Furniture made_furniture(Scene& scene, const FurnitureModel& model) {
    const FurnitureKind& kind = *find_furniture_kind(model.kind);
    Furniture furniture;
    furniture.model = model;
    furniture.name = numbered_name(scene, kind.label);
    std::vector<ObjectId> materials;
    for (const FurnitureFinish& finish : kind.finishes) materials.push_back(material_named(scene, finish.material));
    for (ModelPart& made : parts_of(model)) {
        made.part.material = materials[static_cast<std::size_t>(made.finish)];
        furniture.parts.push_back(std::move(made.part));
    }
    return furniture;
}

Added with_furniture(Scene scene, const FurnitureModel& model, const Vec3& place, double rotation) {
    if (find_furniture_kind(model.kind) == nullptr) return {std::move(scene), {}};
    Furniture furniture = made_furniture(scene, fitted(scene, model));
    furniture.id = scene.new_id();
    furniture.position = place;
    furniture.rotation = rotation;
    const ObjectId id = furniture.id;
    scene.furniture.push_back(std::move(furniture));
    return {std::move(scene), id};
}

Added with_furniture(Scene scene, const FurnitureModel& model, ObjectId chosen) {
    const FurnitureKind* const kind = find_furniture_kind(model.kind);
    if (kind == nullptr) return {std::move(scene), {}};
    const Furniture piece = [&] {
        Scene tried = scene;
        return made_furniture(tried, fitted(scene, model));
    }();
    double rotation = 0.0;
    Vec3 place = free_place(scene, own_bounds(piece));
    for (const Furniture& below : scene.furniture) {
        if (below.id != chosen || !kind->stands_on_furniture) continue;
        place = {below.position.x, below.position.y, below.position.z + own_bounds(below).high.z};
        rotation = below.rotation;
    }
    return with_furniture(std::move(scene), model, place, rotation);
}

bool follows_model(const Furniture& furniture) {
    const std::vector<ModelPart> made = parts_of(furniture.model);
    return std::equal(made.begin(), made.end(), furniture.parts.begin(), furniture.parts.end(),
                      [](const ModelPart& a, const Part& b) { return same_shape(a.part, b); });
}

void set_model_size(Furniture& furniture, std::string_view size, double value) {
    const FurnitureKind* const kind = find_furniture_kind(furniture.model.kind);
    if (kind == nullptr || find_size(*kind, size) == nullptr || !std::isfinite(value)) return;
    const std::vector<ModelPart> before = parts_of(furniture.model);
    std::erase_if(furniture.model.sizes, [&](const ModelSize& stated) { return stated.name == size; });
    furniture.model.sizes.push_back({std::string(size), value});
    furniture.model.sizes.back().metres = size_of(*kind, furniture.model, size);
    std::vector<Part> parts;
    std::vector<std::size_t> seen(kind->finishes.size(), 0);  // parts of each finish so far
    for (ModelPart& made : parts_of(furniture.model)) {
        const std::size_t wanted = ++seen[static_cast<std::size_t>(made.finish)];
        std::size_t count = 0;
        for (std::size_t k = 0; k < before.size() && k < furniture.parts.size(); ++k) {
            if (before[k].finish != made.finish) continue;
            made.part.material = furniture.parts[k].material;
            made.part.unknown = furniture.parts[k].unknown;
            if (++count == wanted) break;
        }
        if (count < wanted) made.part.unknown.clear();
        parts.push_back(std::move(made.part));
    }
    // A finish that had no part before (a panel of no height) is covered as the piece's first part.
    for (Part& part : parts)
        if (!part.material && !furniture.parts.empty()) part.material = furniture.parts.front().material;
    furniture.parts = std::move(parts);
}

void set_finish(Furniture& furniture, int finish, ObjectId material) {
    const std::vector<ModelPart> made = parts_of(furniture.model);
    for (std::size_t k = 0; k < made.size() && k < furniture.parts.size(); ++k)
        if (made[k].finish == finish) furniture.parts[k].material = material;
}

ObjectId material_of_finish(const Furniture& furniture, int finish) {
    const std::vector<ModelPart> made = parts_of(furniture.model);
    ObjectId material;
    for (std::size_t k = 0; k < made.size() && k < furniture.parts.size(); ++k) {
        if (made[k].finish != finish) continue;
        if (material && furniture.parts[k].material != material) return {};
        material = furniture.parts[k].material;
    }
    return material;
}

Diagnostics settle_models(Scene& scene) {
    Diagnostics findings;
    for (std::size_t i = 0; i < scene.furniture.size(); ++i) {
        Furniture& furniture = scene.furniture[i];
        const bool known = find_furniture_kind(furniture.model.kind) != nullptr;
        if (furniture.model.kind.empty() || (known && follows_model(furniture))) continue;
        Diagnostic finding{Severity::warning, {"", 0, fmt::format("furniture[{}].model", i), furniture.id.value}, {}};
        finding.message =
            known ? fmt::format(
                        "furniture \"{}\": its parts are not those of the library's \"{}\" in these "
                        "sizes; they are kept as they are, and the model is left out",
                        furniture.name, furniture.model.kind)
                  : fmt::format("furniture \"{}\": the library has no \"{}\"; its parts are kept as they are",
                                furniture.name, furniture.model.kind);
        findings.push_back(std::move(finding));
        if (known) furniture.model = {};
    }
    return findings;
}

Bounds own_bounds(const Furniture& furniture) {
    Scene alone;
    alone.furniture.push_back(furniture);
    alone.furniture.back().position = Vec3{0.0};
    alone.furniture.back().rotation = 0.0;
    return bounds_of(alone);
}

}  // namespace hanei
