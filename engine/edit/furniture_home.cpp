#include "engine/edit/furniture_piece.h"

#include <algorithm>

namespace hanei {
namespace {

void bed(Piece& piece) {
    const double width = piece["width"], length = piece["length"], height = piece["height"];
    const double frame = 0.6 * height, head = 0.05, foot = 0.5 * height * 0.6, leg = 0.06;
    const double back = 0.5 * length - head;
    for (const double x : {-0.5 * width, 0.5 * width - leg})
        for (const double y : {-0.5 * length, back - leg}) piece.box(0, {x, y, 0.0}, {x + leg, y + leg, foot});
    piece.box(0, {-0.5 * width, -0.5 * length, foot}, {0.5 * width, back, frame});
    piece.box(1, {-0.5 * width, -0.5 * length, frame}, {0.5 * width, back, height});
    piece.box(0, {-0.5 * width, back, 0.0}, {0.5 * width, 0.5 * length, std::max(piece["head"], height)});
    const int pillows = width > 1.2 ? 2 : 1;
    const double each = width / pillows, pillow = std::min(0.7, 0.85 * each);
    for (int k = 0; k < pillows; ++k) {
        const double middle = -0.5 * width + (k + 0.5) * each;
        piece.box(1, {middle - 0.5 * pillow, back - 0.42, height}, {middle + 0.5 * pillow, back - 0.04, height + 0.1});
    }
}

void bedside_table(Piece& piece) {
    const double width = piece["width"], depth = piece["depth"], height = piece["height"];
    const double side = 0.018, middle = 0.55 * height;
    piece.box(0, {-0.5 * width, -0.5 * depth, height - side}, {0.5 * width, 0.5 * depth, height});
    for (const double x : {-0.5 * width, 0.5 * width - side})
        piece.box(0, {x, -0.5 * depth, 0.0}, {x + side, 0.5 * depth, height - side});
    piece.box(1, {side - 0.5 * width, -0.5 * depth, middle}, {0.5 * width - side, 0.5 * depth, height - side});
    piece.box(0, {side - 0.5 * width, -0.5 * depth, 0.05}, {0.5 * width - side, 0.5 * depth, 0.05 + side});
}

void kitchen(Piece& piece) {
    const double width = piece["width"], depth = piece["depth"], height = piece["height"];
    const double plinth = 0.1, top = 0.04, front = 0.02, over = 0.03;
    const double face = -0.5 * depth + over;
    piece.box(2, {-0.5 * width, face + 0.06, 0.0}, {0.5 * width, 0.5 * depth, plinth});
    piece.box(1, {-0.5 * width, face, plinth}, {0.5 * width, 0.5 * depth, height - top});
    piece.box(0, {-0.5 * width, -0.5 * depth, height - top}, {0.5 * width, 0.5 * depth, height});
    const double cupboards = piece["cupboards"];
    if (cupboards < 0.1) return;
    const double low = height + piece["gap"], deep = std::min(0.35, 0.7 * depth);
    piece.box(1, {-0.5 * width, 0.5 * depth - deep, low}, {0.5 * width, 0.5 * depth, low + cupboards});
    piece.box(3, {-0.5 * width, 0.5 * depth - front, height}, {0.5 * width, 0.5 * depth, low});
}

void plant(Piece& piece) {
    const double height = piece["height"], width = piece["width"], pot = 0.25 * height;
    const int sides = 8;
    const Vec2 middle{0.0, 0.0};
    const double rim = std::min(0.5 * width, 1.4 * pot);
    piece.frustum(0, regular_polygon(middle, 0.7 * rim, sides), regular_polygon(middle, rim, sides), 0.0, pot);
    const double trunk = pot + 0.15 * height, wide = trunk + 0.25 * height;
    piece.disc(1, middle, 0.3 * rim, sides, pot, trunk);
    piece.frustum(2, regular_polygon(middle, 0.4 * width, sides), regular_polygon(middle, width, sides), trunk, wide);
    piece.frustum(2, regular_polygon(middle, width, sides), regular_polygon(middle, 0.3 * width, sides), wide, height);
}

void person(Piece& piece) {
    const double h = piece["height"];
    const double leg = 0.47 * h, shoulder = 0.82 * h, neck = 0.86 * h, half = 0.1 * h, arm = 0.045 * h,
                 deep = 0.065 * h;
    for (const double side : {-1.0, 1.0}) {
        const double inner = side * 0.01 * h, outer = side * half;
        piece.box(1, {std::min(inner, outer), -0.8 * deep, 0.0}, {std::max(inner, outer), 0.8 * deep, leg});
        const double from = side * 1.15 * half, to = side * (1.15 * half + arm);
        piece.box(0, {std::min(from, to), -0.6 * deep, 0.42 * h}, {std::max(from, to), 0.6 * deep, shoulder});
    }
    piece.box(0, {-1.15 * half, -deep, leg}, {1.15 * half, deep, shoulder});
    piece.disc(2, {0.0, 0.0}, 0.07 * h, 8, shoulder, neck);
    piece.disc(2, {0.0, 0.0}, 0.115 * h, 8, neck, h);
}

}  // namespace

std::vector<FurnitureKind> home_pieces() {
    return {
        {"bed",
         "Bed",
         "Home and care",
         "Bed with its head at the back",
         {{"width", "Width", "1.0 m for one, 1.6 m for two", 1.0, 0.7, 2.2},
          {"length", "Length", "From head to foot", 2.1, 1.4, 2.4},
          {"height", "Height", "Of the mattress", 0.5, 0.3, 1.0},
          {"head", "Headboard", "Height of its upper edge", 0.95, 0.3, 1.6}},
         {{"Frame", "Wood, light"}, {"Bedding", "Bed linen"}},
         bed},
        {"bedside-table",
         "Bedside table",
         "Home and care",
         "Small table with a drawer",
         {{"width", "Width", "From left to right", 0.45, 0.3, 0.8},
          {"depth", "Depth", "From front to back", 0.4, 0.25, 0.6},
          {"height", "Height", "Over all", 0.5, 0.3, 0.9}},
         {{"Body", "Wood, light"}, {"Drawer", "White laminate"}},
         bedside_table},
        {"kitchen",
         "Kitchen counter",
         "Home and care",
         "Worktop on cupboards, wall cupboards above it",
         {{"width", "Width", "From left to right", 2.4, 0.6, 8.0},
          {"depth", "Depth", "Of the worktop", 0.62, 0.5, 1.0},
          {"height", "Height", "Of the worktop", 0.92, 0.7, 1.1},
          {"cupboards", "Cupboards", "Height of the wall cupboards; below 0.1 m: none", 0.7, 0.0, 1.2},
          {"gap", "Gap", "From the worktop to the wall cupboards", 0.55, 0.3, 0.9}},
         {{"Worktop", "Wood, medium"},
          {"Fronts", "White laminate"},
          {"Plinth", "Dark plastic"},
          {"Back", "Tiles, light"}},
         kitchen},
        {"plant",
         "Plant",
         "Home and care",
         "Plant in a pot",
         {{"height", "Height", "Over all", 1.3, 0.3, 3.0}, {"width", "Width", "Of the crown", 0.7, 0.2, 2.0}},
         {{"Pot", "Grey laminate"}, {"Trunk", "Wood, dark"}, {"Leaves", "Leaves"}},
         plant},
        {"person",
         "Person",
         "Home and care",
         "Somebody who stands there, for scale and shadows",
         {{"height", "Height", "Over all", 1.72, 0.8, 2.1}},
         {{"Upper clothes", "Fabric, grey"}, {"Trousers", "Fabric, dark"}, {"Skin", "Skin"}},
         person},
    };
}

}  // namespace hanei
