#include "engine/edit/furniture_library.h"

#include "engine/edit/furniture_piece.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace hanei {
namespace {

std::vector<FurnitureKind> all_pieces() {
    std::vector<FurnitureKind> all;
    for (const auto pieces : {table_pieces, seat_pieces, storage_pieces, device_pieces, home_pieces, building_pieces}) {
        std::vector<FurnitureKind> some = pieces();
        std::move(some.begin(), some.end(), std::back_inserter(all));
    }
    return all;
}

}  // namespace

std::span<const FurnitureKind> furniture_library() {
    static const std::vector<FurnitureKind> library = all_pieces();
    return library;
}

const FurnitureKind* find_furniture_kind(std::string_view kind) {
    for (const FurnitureKind& entry : furniture_library())
        if (entry.kind == kind) return &entry;
    return nullptr;
}

const FurnitureSize* find_size(const FurnitureKind& kind, std::string_view name) {
    for (const FurnitureSize& size : kind.sizes)
        if (size.name == name) return &size;
    return nullptr;
}

double size_of(const FurnitureKind& kind, const FurnitureModel& model, std::string_view name) {
    const FurnitureSize* const size = find_size(kind, name);
    if (size == nullptr) return 0.0;
    double chosen = size->usual;
    for (const ModelSize& stated : model.sizes)
        if (stated.name == name && std::isfinite(stated.metres)) chosen = stated.metres;
    chosen = std::clamp(chosen, size->low, size->high);
    return size->counts ? std::round(chosen) : chosen;
}

std::vector<ModelPart> parts_of(const FurnitureModel& model) {
    const FurnitureKind* const kind = find_furniture_kind(model.kind);
    if (kind == nullptr) return {};
    Piece piece(*kind, model);
    kind->build(piece);
    return piece.take();
}

}  // namespace hanei
