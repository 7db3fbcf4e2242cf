#include "engine/edit/furniture_piece.h"

#include <algorithm>
#include <cmath>

namespace hanei {
namespace {

void monitor(Piece& piece, double y) {
    const double width = piece["width"], height = piece["height"], lift = piece["lift"];
    const double frame = 0.012, housing = 0.04, foot = std::min(0.25, 0.6 * width);
    piece.box(0, {-0.5 * foot, y - 0.09, 0.0}, {0.5 * foot, y + 0.09, 0.012});
    piece.box(0, {-0.03, y, 0.012}, {0.03, y + 0.03, lift + 0.5 * height});
    piece.box(0, {-0.5 * width, y - housing, lift}, {0.5 * width, y, lift + height});
    piece.box(1, {frame - 0.5 * width, y - housing - 0.004, lift + frame},
              {0.5 * width - frame, y - housing, lift + height - frame});
}

void computer(Piece& piece) {
    monitor(piece, 0.16);
    piece.box(2, {-0.22, -0.22, 0.0}, {0.22, -0.07, 0.02});
}

void television(Piece& piece) {
    const double width = piece["width"], height = piece["height"], lift = piece["lift"];
    const double frame = 0.012, depth = 0.05;
    if (lift > 0.04) {
        piece.box(0, {-0.25 * width, -0.12, 0.0}, {0.25 * width, 0.12, 0.02});
        piece.box(0, {-0.06, -0.5 * depth, 0.02}, {0.06, 0.5 * depth, lift});
    }
    const double low = lift > 0.04 ? lift : 0.0;
    piece.box(0, {-0.5 * width, -0.5 * depth, low}, {0.5 * width, 0.5 * depth, low + height});
    piece.box(1, {frame - 0.5 * width, -0.5 * depth - 0.004, low + frame},
              {0.5 * width - frame, -0.5 * depth, low + height - frame});
}

void laptop(Piece& piece) {
    const double width = piece["width"], depth = piece["depth"], base = 0.018, leaf = 0.008;
    constexpr double open = 0.35;  // rad that the screen leans back
    piece.box(0, {-0.5 * width, -0.5 * depth, 0.0}, {0.5 * width, 0.5 * depth, base});
    const double back = depth * std::sin(open), top = base + depth * std::cos(open);
    const double rear = 0.5 * depth, front = rear - leaf;
    piece.bar(0, {{front, base}, {rear, base}, {rear + back, top}, {front + back, top}}, -0.5 * width, 0.5 * width);
    // The screen, a veneer on the leaf's front that leaves a frame.
    const double edge = 0.06, thin = 0.002;
    const auto at = [&](double share) { return Vec2{front + share * back, base + share * (top - base)}; };
    const Vec2 low = at(edge), high = at(1.0 - edge), out{-thin, 0.0};
    piece.bar(1, {low, high, high + out, low + out}, 0.01 - 0.5 * width, 0.5 * width - 0.01);
}

void printer(Piece& piece) {
    const double width = piece["width"], depth = piece["depth"], height = piece["height"];
    const double lid = 0.12 * height, tray = 0.6 * height;
    piece.box(0, {-0.5 * width, -0.5 * depth, 0.0}, {0.5 * width, 0.5 * depth, tray});
    piece.box(1, {-0.5 * width, -0.2 * depth, tray}, {0.5 * width, 0.5 * depth, height - lid});
    piece.box(0, {-0.5 * width, -0.5 * depth, height - lid}, {0.5 * width, 0.5 * depth, height});
    piece.box(0, {-0.5 * width, -0.5 * depth, tray}, {0.03 - 0.5 * width, -0.2 * depth, height - lid});
}

void machine(Piece& piece) {
    const double width = piece["width"], depth = piece["depth"], height = piece["height"];
    const double table = 0.45 * height, head = 0.4 * depth, left = -0.5 * width, right = 0.5 * width;
    const double panel = std::min(0.3, 0.2 * width);
    piece.box(0, {left, -0.5 * depth, 0.0}, {right - panel, 0.5 * depth, table});
    piece.box(0, {left, 0.5 * depth - head, table}, {right - panel, 0.5 * depth, height});
    piece.box(1, {left + 0.25 * width, -0.1 * depth, 0.7 * height},
              {left + 0.45 * width, 0.5 * depth - head, 0.95 * height});
    piece.box(1, {left + 0.1 * width, -0.4 * depth, table}, {left + 0.6 * width, 0.0, table + 0.06 * height});
    piece.box(1, {right - panel, -0.3 * depth, 0.0}, {right, 0.3 * depth, 0.8 * height});
    piece.box(2, {right - 0.9 * panel, -0.3 * depth - 0.01, 0.6 * height},
              {right - 0.1 * panel, -0.3 * depth, 0.75 * height});
}

}  // namespace

std::vector<FurnitureKind> device_pieces() {
    return {
        {"computer",
         "Computer",
         "Devices",
         "Screen on a foot with a keyboard before it",
         {{"width", "Width", "Of the screen", 0.6, 0.3, 1.3},
          {"height", "Height", "Of the screen", 0.35, 0.2, 0.8},
          {"lift", "Lift", "From the desk to the screen's lower edge", 0.12, 0.03, 0.5}},
         {{"Housing", "Dark plastic"}, {"Screen", "Black screen"}, {"Keyboard", "Dark plastic"}},
         computer,
         true},
        {"laptop",
         "Laptop",
         "Devices",
         "Open laptop",
         {{"width", "Width", "From left to right", 0.34, 0.25, 0.45},
          {"depth", "Depth", "Of its base", 0.24, 0.17, 0.32}},
         {{"Housing", "Grey laminate"}, {"Screen", "Black screen"}},
         laptop,
         true},
        {"television",
         "Television",
         "Devices",
         "Large screen on a foot, or by itself to hang on a wall",
         {{"width", "Width", "Of the screen", 1.45, 0.5, 3.0},
          {"height", "Height", "Of the screen", 0.83, 0.3, 1.8},
          {"lift", "Lift", "Height of its lower edge above the foot; below 0.05 m: without a foot", 0.1, 0.0, 2.0}},
         {{"Housing", "Dark plastic"}, {"Screen", "Black screen"}},
         television,
         true},
        {"printer",
         "Printer",
         "Devices",
         "Printer or copier",
         {{"width", "Width", "From left to right", 0.5, 0.3, 1.5},
          {"depth", "Depth", "From front to back", 0.5, 0.3, 1.0},
          {"height", "Height", "Over all: 1.1 m for one that stands on the floor", 0.45, 0.2, 1.5}},
         {{"Housing", "White laminate"}, {"Works", "Grey laminate"}},
         printer,
         true},
        {"machine",
         "Machine",
         "Industry",
         "Machine tool with a head, a table and a switch cabinet",
         {{"width", "Width", "From left to right", 2.0, 0.8, 6.0},
          {"depth", "Depth", "From front to back", 1.4, 0.6, 4.0},
          {"height", "Height", "Over all", 1.9, 1.0, 4.0}},
         {{"Body", "Light grey (RAL 7035)"}, {"Works", "Dusty grey (RAL 7037)"}, {"Screen", "Black screen"}},
         machine},
    };
}

}  // namespace hanei
