#include "engine/edit/furniture_piece.h"

#include <algorithm>

namespace hanei {
namespace {

void box(Piece& piece) {
    piece.box(0, {-0.5 * piece["width"], -0.5 * piece["depth"], 0.0},
              {0.5 * piece["width"], 0.5 * piece["depth"], piece["height"]});
}

void round_column(Piece& piece) {
    piece.disc(0, {0.0, 0.0}, piece["diameter"], piece.count("sides"), 0.0, piece["height"]);
}

void partition(Piece& piece) {
    const double width = piece["width"], height = piece["height"], thick = piece["thickness"];
    const double lift = std::min(0.1, 0.2 * height), foot = 0.02, reach = 0.22, post = std::min(0.04, 0.1 * width);
    for (const double x : {0.1 * width - 0.5 * width, 0.4 * width - post}) {
        piece.box(1, {x, -reach, 0.0}, {x + post, reach, foot});
        piece.box(1, {x, -0.5 * thick, foot}, {x + post, 0.5 * thick, lift});
    }
    piece.box(0, {-0.5 * width, -0.5 * thick, lift}, {0.5 * width, 0.5 * thick, height});
}

void board_on_stand(Piece& piece) {
    const double width = piece["width"], height = piece["height"], low = piece["lift"];
    const double thick = 0.03, post = 0.05, foot = 0.04, reach = 0.3;
    for (const double x : {-0.5 * width, 0.5 * width - post}) {
        piece.box(1, {x, -reach, 0.0}, {x + post, reach, foot});
        piece.box(1, {x, 0.0, foot}, {x + post, post, low + height});
    }
    piece.box(0, {-0.5 * width, -thick, low}, {0.5 * width, 0.0, low + height});
    piece.box(1, {-0.5 * width, -thick - 0.06, low - 0.02}, {0.5 * width, 0.0, low});
}

void stairs(Piece& piece) {
    const double width = piece["width"], rise = piece["rise"], tread = piece["tread"];
    const int steps = piece.count("steps");
    const double front = -0.5 * steps * tread;
    for (int k = 0; k < steps; ++k)
        piece.box(0, {-0.5 * width, front + k * tread, 0.0}, {0.5 * width, front + (k + 1) * tread, (k + 1) * rise});
}

}  // namespace

std::vector<FurnitureKind> building_pieces() {
    return {
        {"partition",
         "Partition",
         "Office",
         "Free-standing screen between workplaces",
         {{"width", "Width", "From left to right", 1.6, 0.4, 4.0},
          {"height", "Height", "Over all", 1.5, 0.5, 2.5},
          {"thickness", "Thickness", "Of the screen", 0.05, 0.01, 0.2}},
         {{"Screen", "Fabric, grey"}, {"Feet", "Steel, grey"}},
         partition},
        {"board-stand",
         "Board on a stand",
         "School",
         "Whiteboard or chalkboard on two feet; its face looks to the front",
         {{"width", "Width", "Of the board", 2.0, 0.6, 5.0},
          {"height", "Height", "Of the board", 1.2, 0.4, 2.0},
          {"lift", "Lift", "From the floor to the board's lower edge", 0.8, 0.2, 1.5}},
         {{"Board", "Whiteboard"}, {"Stand", "Steel, grey"}},
         board_on_stand},
        {"box",
         "Box",
         "Building",
         "Anything that is a box",
         {{"width", "Width", "From left to right", 1.2, 0.01, 100.0},
          {"depth", "Depth", "From front to back", 0.6, 0.01, 100.0},
          {"height", "Height", "Over all", 0.75, 0.01, 100.0}},
         {{"Body", "Grey laminate"}},
         box},
        {"column",
         "Column",
         "Building",
         "Column of rectangular section",
         {{"width", "Width", "From left to right", 0.4, 0.1, 3.0},
          {"depth", "Depth", "From front to back", 0.4, 0.1, 3.0},
          {"height", "Height", "Over all", 2.8, 0.5, 30.0}},
         {{"Column", "Plaster"}},
         box},
        {"round-column",
         "Round column",
         "Building",
         "Column with the section of a regular polygon",
         {{"diameter", "Diameter", "Over the corners", 0.4, 0.1, 3.0},
          {"height", "Height", "Over all", 2.8, 0.5, 30.0},
          {"sides", "Sides", "More of them are rounder and take longer to light", 12.0, 4.0, 32.0, true}},
         {{"Column", "Plaster"}},
         round_column},
        {"stairs",
         "Stairs",
         "Building",
         "Straight flight of solid steps, rising to the back",
         {{"width", "Width", "From left to right", 1.2, 0.5, 6.0},
          {"rise", "Rise", "Height of a step", 0.17, 0.1, 0.25},
          {"tread", "Tread", "Depth of a step", 0.29, 0.2, 0.5},
          {"steps", "Steps", "How many", 6.0, 1.0, 25.0, true}},
         {{"Steps", "Concrete"}},
         stairs},
    };
}

}  // namespace hanei
