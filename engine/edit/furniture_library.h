/// Parametric furniture: what the program knows to build, from a few sizes.
///
/// A piece stands on its own z = 0 about its own z axis: x runs along its width, its front looks
/// towards -y, its back stands against a wall at +y. Parts touch and never share space, whatever sizes
/// within their ranges are chosen.
#pragma once

#include "engine/scene/scene.h"

#include <span>
#include <string_view>
#include <vector>

namespace hanei {

/// One size that can be chosen.
struct FurnitureSize {
    std::string_view name;   ///< in files and on the command line: "width"
    std::string_view label;  ///< on screen: "Width"
    std::string_view help;
    double usual, low, high;  ///< m; a plain number when it counts something
    bool counts = false;      ///< whole numbers: levels, seats
};

/// Parts of one kind of surface: the top, the legs. They share a material until one is changed by itself.
struct FurnitureFinish {
    std::string_view label;     ///< "Top"
    std::string_view material;  ///< of the palette (material_palette.h)
};

class Piece;

struct FurnitureKind {
    std::string_view kind;   ///< "desk-drawers", in files and on the command line
    std::string_view label;  ///< "Desk with drawers"
    std::string_view group;  ///< "Office"
    std::string_view help;   ///< one sentence
    std::vector<FurnitureSize> sizes;
    std::vector<FurnitureFinish> finishes;
    void (*build)(Piece& piece);
    bool stands_on_furniture = false;  ///< a computer: placed on a desk rather than on the floor
};

/// All kinds, those of one group together.
std::span<const FurnitureKind> furniture_library();
/// Null when the library has none of this name.
const FurnitureKind* find_furniture_kind(std::string_view kind);

const FurnitureSize* find_size(const FurnitureKind& kind, std::string_view name);
/// As the model says, else the usual one; brought into the size's range, counts to whole numbers.
double size_of(const FurnitureKind& kind, const FurnitureModel& model, std::string_view name);

/// A part and which of its kind's finishes it has.
struct ModelPart {
    Part part;  ///< without a material
    int finish = 0;
};

/// The parts that follow from a model.
///
/// Returns   nothing for a model whose kind the library does not know.
std::vector<ModelPart> parts_of(const FurnitureModel& model);

}  // namespace hanei
