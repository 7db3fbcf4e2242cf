#include "engine/edit/furniture_piece.h"

#include <algorithm>

namespace hanei {
namespace {

constexpr FurnitureSize top_thickness{"top", "Top", "Thickness of the table top", 0.025, 0.01, 0.1};

/// Four square legs below a top, flush with its corners.
void four_legs(Piece& piece, int finish, double width, double depth, double leg, double height) {
    for (const double x : {-0.5 * width, 0.5 * width - leg})
        for (const double y : {-0.5 * depth, 0.5 * depth - leg})
            piece.box(finish, {x, y, 0.0}, {x + leg, y + leg, height});
}

double leg_of(double width, double depth, double wished) { return std::min(wished, 0.15 * std::min(width, depth)); }

void desk(Piece& piece) {
    const double width = piece["width"], depth = piece["depth"], under = piece["height"] - piece["top"];
    const double leg = leg_of(width, depth, 0.05);
    piece.box(0, {-0.5 * width, -0.5 * depth, under}, {0.5 * width, 0.5 * depth, piece["height"]});
    four_legs(piece, 1, width, depth, leg, under);
    const double panel = std::min(piece["panel"], under - 0.05);
    const double back = 0.5 * depth - leg;
    piece.box(2, {leg - 0.5 * width, back, under - panel}, {0.5 * width - leg, back + std::min(0.018, leg), under});
}

void desk_with_drawers(Piece& piece) {
    const double width = piece["width"], depth = piece["depth"], under = piece["height"] - piece["top"];
    const double side = 0.02, front = 0.02;
    const double drawers = std::min(piece["drawers"], 0.5 * width);
    piece.box(0, {-0.5 * width, -0.5 * depth, under}, {0.5 * width, 0.5 * depth, piece["height"]});
    piece.box(1, {-0.5 * width, -0.5 * depth, 0.0}, {side - 0.5 * width, 0.5 * depth, under});
    piece.box(1, {0.5 * width - drawers, front - 0.5 * depth, 0.0}, {0.5 * width, 0.5 * depth, under});
    piece.box(2, {0.5 * width - drawers, -0.5 * depth, 0.08}, {0.5 * width, front - 0.5 * depth, under});
    piece.box(1, {side - 0.5 * width, 0.5 * depth - side, 0.4 * under}, {0.5 * width - drawers, 0.5 * depth, under});
}

void conference_table(Piece& piece) {
    const double width = piece["width"], depth = piece["depth"], under = piece["height"] - piece["top"];
    const double panel = 0.04, inset = 0.15 * width, deep = 0.3 * depth;
    piece.box(0, {-0.5 * width, -0.5 * depth, under}, {0.5 * width, 0.5 * depth, piece["height"]});
    for (const double x : {inset - 0.5 * width, 0.5 * width - inset - panel})
        piece.box(1, {x, -deep, 0.0}, {x + panel, deep, under});
    piece.box(1, {inset - 0.5 * width + panel, -0.5 * panel, 0.35 * under},
              {0.5 * width - inset - panel, 0.5 * panel, 0.85 * under});
}

void round_table(Piece& piece) {
    const double diameter = piece["diameter"], under = piece["height"] - piece["top"];
    const int sides = piece.count("sides");
    const double foot = 0.025;
    piece.disc(0, {0.0, 0.0}, diameter, sides, under, piece["height"]);
    piece.disc(1, {0.0, 0.0}, std::min(0.1, 0.2 * diameter), 8, foot, under);
    piece.disc(1, {0.0, 0.0}, 0.5 * diameter, sides, 0.0, foot);
}

void school_desk(Piece& piece) {
    const double width = piece["width"], depth = piece["depth"], under = piece["height"] - piece["top"];
    const double leg = leg_of(width, depth, 0.035);
    piece.box(0, {-0.5 * width, -0.5 * depth, under}, {0.5 * width, 0.5 * depth, piece["height"]});
    four_legs(piece, 1, width, depth, leg, under);
    const double board = 0.012, shelf = under - std::min(0.14, 0.3 * under);
    piece.box(1, {leg - 0.5 * width, -0.5 * depth + leg, shelf}, {0.5 * width - leg, 0.5 * depth - leg, shelf + board});
    piece.box(1, {-0.5 * width, -0.5 * depth + leg, shelf},
              {leg - 0.5 * width, 0.5 * depth - leg, shelf + 2.0 * board});
    piece.box(1, {0.5 * width - leg, -0.5 * depth + leg, shelf}, {0.5 * width, 0.5 * depth - leg, shelf + 2.0 * board});
}

void reception(Piece& piece) {
    const double width = piece["width"], depth = piece["depth"], height = piece["height"];
    const double panel = 0.03, shelf = std::min(0.35, 0.5 * depth), desk_top = std::min(0.74, height - 0.2);
    piece.box(1, {-0.5 * width, -0.5 * depth, 0.0}, {0.5 * width, panel - 0.5 * depth, height - panel});
    for (const double x : {-0.5 * width, 0.5 * width - panel})
        piece.box(1, {x, panel - 0.5 * depth, 0.0}, {x + panel, 0.5 * depth, desk_top - panel});
    piece.box(0, {-0.5 * width, panel - 0.5 * depth, desk_top - panel}, {0.5 * width, 0.5 * depth, desk_top});
    piece.box(0, {-0.5 * width, -0.5 * depth, height - panel}, {0.5 * width, shelf - 0.5 * depth, height});
}

}  // namespace

std::vector<FurnitureKind> table_pieces() {
    return {
        {"desk",
         "Desk",
         "Office",
         "Table top on four legs with a modesty panel",
         {{"width", "Width", "From left to right", 1.6, 0.5, 3.0},
          {"depth", "Depth", "From front to back", 0.8, 0.4, 1.5},
          {"height", "Height", "Of the top: EN 527-1 has 0.74 m for fixed desks, up to 1.25 m to stand at", 0.74, 0.4,
           1.3},
          top_thickness,
          {"panel", "Panel", "Height of the modesty panel; 0: none", 0.35, 0.0, 1.0}},
         {{"Top", "Wood, light"}, {"Legs", "Steel, grey"}, {"Panel", "Grey laminate"}},
         desk},
        {"desk-drawers",
         "Desk with drawers",
         "Office",
         "Writing desk with a chest of drawers at the right",
         {{"width", "Width", "From left to right", 1.6, 0.8, 3.0},
          {"depth", "Depth", "From front to back", 0.8, 0.4, 1.5},
          {"height", "Height", "Of the top", 0.74, 0.5, 1.3},
          top_thickness,
          {"drawers", "Drawers", "Width of the chest of drawers", 0.43, 0.2, 0.8}},
         {{"Top", "Wood, light"}, {"Body", "Wood, light"}, {"Fronts", "White laminate"}},
         desk_with_drawers},
        {"conference-table",
         "Conference table",
         "Office",
         "Long table on two panels",
         {{"width", "Width", "From left to right", 2.4, 0.8, 8.0},
          {"depth", "Depth", "From front to back", 1.1, 0.5, 3.0},
          {"height", "Height", "Of the top", 0.74, 0.3, 1.3},
          {"top", "Top", "Thickness of the table top", 0.03, 0.01, 0.1}},
         {{"Top", "Wood, medium"}, {"Base", "Dark plastic"}},
         conference_table},
        {"round-table",
         "Round table",
         "Office",
         "Table top with the corners of a regular polygon on a column",
         {{"diameter", "Diameter", "Over the corners", 1.2, 0.3, 4.0},
          {"height", "Height", "Of the top", 0.74, 0.3, 1.3},
          {"top", "Top", "Thickness of the table top", 0.025, 0.01, 0.1},
          {"sides", "Sides", "More of them are rounder and take longer to light", 12.0, 4.0, 32.0, true}},
         {{"Top", "Wood, light"}, {"Base", "Steel, grey"}},
         round_table},
        {"school-desk",
         "School desk",
         "School",
         "Double desk with a tray below its top",
         {{"width", "Width", "From left to right: 1.3 m for two pupils, 0.7 m for one", 1.3, 0.5, 2.0},
          {"depth", "Depth", "From front to back", 0.55, 0.35, 1.0},
          {"height", "Height", "Of the top, by the pupils' age: EN 1729-1 has 0.53 to 0.82 m", 0.76, 0.4, 1.0},
          {"top", "Top", "Thickness of the table top", 0.02, 0.01, 0.06}},
         {{"Top", "Wood, light"}, {"Frame", "Steel, grey"}},
         school_desk},
        {"reception",
         "Reception counter",
         "Office",
         "Counter with a desk behind it; visitors stand in front",
         {{"width", "Width", "From left to right", 2.0, 0.8, 6.0},
          {"depth", "Depth", "From front to back", 0.85, 0.5, 1.5},
          {"height", "Height", "Of the counter", 1.1, 0.8, 1.4}},
         {{"Tops", "White laminate"}, {"Body", "Wood, medium"}},
         reception},
    };
}

}  // namespace hanei
