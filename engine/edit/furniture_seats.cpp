#include "engine/edit/furniture_piece.h"

#include <algorithm>

namespace hanei {
namespace {

void chair(Piece& piece) {
    const double width = piece["width"], depth = piece["depth"], seat = piece["seat"];
    const double leg = 0.035, thick = 0.04, back = 0.03;
    piece.box(0, {-0.5 * width, -0.5 * depth, seat - thick}, {0.5 * width, 0.5 * depth, seat});
    for (const double x : {-0.5 * width, 0.5 * width - leg})
        for (const double y : {-0.5 * depth, 0.5 * depth - leg})
            piece.box(1, {x, y, 0.0}, {x + leg, y + leg, seat - thick});
    const double top = std::max(piece["back"], seat + 0.1), gap = 0.3 * (top - seat);
    for (const double x : {-0.5 * width, 0.5 * width - leg})
        piece.box(1, {x, 0.5 * depth - back, seat}, {x + leg, 0.5 * depth, seat + gap});
    piece.box(0, {-0.5 * width, 0.5 * depth - back, seat + gap}, {0.5 * width, 0.5 * depth, top});
}

void office_chair(Piece& piece) {
    const double width = piece["width"], seat = piece["seat"];
    const double cushion = 0.08, foot = 0.07, arm = 0.05, half = 0.5 * width;
    const double reach = std::min(0.32, 0.6 * width);
    piece.box(1, {-reach, -0.5 * arm, 0.0}, {reach, 0.5 * arm, foot});
    piece.box(1, {-0.5 * arm, 0.5 * arm, 0.0}, {0.5 * arm, reach, foot});
    piece.box(1, {-0.5 * arm, -reach, 0.0}, {0.5 * arm, -0.5 * arm, foot});
    piece.box(1, {-0.5 * arm, -0.5 * arm, foot}, {0.5 * arm, 0.5 * arm, seat - cushion});
    piece.box(0, {-half, -half, seat - cushion}, {half, half, seat});
    const double top = std::max(piece["back"], seat + 0.2), lift = std::min(0.12, 0.3 * (top - seat));
    piece.box(1, {-0.5 * arm, half - arm, seat}, {0.5 * arm, half, seat + lift});
    piece.box(0, {-0.85 * half, half - 0.06, seat + lift}, {0.85 * half, half, top});
    const double armrest = piece["armrest"];
    if (!(armrest > seat - cushion + 0.1)) return;
    for (const double side : {-1.0, 1.0}) {
        const double inner = side * half, outer = side * (half + arm);
        piece.box(1, {std::min(inner, outer), -0.5 * arm, seat - cushion},
                  {std::max(inner, outer), 0.5 * arm, armrest - 0.03});
        piece.box(1, {std::min(inner, outer), -0.5 * half, armrest - 0.03},
                  {std::max(inner, outer), 0.5 * half, armrest});
    }
}

/// Arms, back and one cushion a seat on a base.
void seats(Piece& piece, int count) {
    const double width = piece["width"], depth = piece["depth"], height = piece["height"], seat = piece["seat"];
    const double arm = std::min(0.16, 0.2 * width), back = std::min(0.18, 0.3 * depth), foot = 0.06;
    const double base = foot + 0.5 * (seat - foot), arm_top = seat + 0.5 * (height - seat);
    const double inner = 0.5 * width - arm;
    piece.box(1, {0.05 - 0.5 * width, 0.05 - 0.5 * depth, 0.0}, {0.5 * width - 0.05, 0.5 * depth - 0.05, foot});
    piece.box(0, {-0.5 * width, -0.5 * depth, foot}, {0.5 * width, 0.5 * depth, base});
    for (const double x : {-0.5 * width, inner})
        piece.box(0, {x, -0.5 * depth, base}, {x + arm, 0.5 * depth - back, arm_top});
    piece.box(0, {-0.5 * width, 0.5 * depth - back, base}, {0.5 * width, 0.5 * depth, height});
    for (int k = 0; k < count; ++k) {
        const double from = -inner + 2.0 * inner * k / count, to = -inner + 2.0 * inner * (k + 1) / count;
        piece.box(0, {from, -0.5 * depth, base}, {to, 0.5 * depth - back, seat});
    }
}

void armchair(Piece& piece) { seats(piece, 1); }
void sofa(Piece& piece) { seats(piece, piece.count("seats")); }

void stool(Piece& piece) {
    const double diameter = piece["diameter"], height = piece["height"], thick = 0.04, foot = 0.02;
    piece.disc(0, {0.0, 0.0}, diameter, 8, height - thick, height);
    piece.disc(1, {0.0, 0.0}, 0.06, 8, foot, height - thick);
    piece.disc(1, {0.0, 0.0}, 0.9 * diameter, 8, 0.0, foot);
}

}  // namespace

std::vector<FurnitureKind> seat_pieces() {
    const FurnitureSize seat{"seat", "Seat", "Height of the seat", 0.46, 0.25, 0.85};
    return {
        {"chair",
         "Chair",
         "Seats",
         "Plain chair on four legs",
         {{"width", "Width", "From left to right", 0.45, 0.3, 0.8},
          {"depth", "Depth", "From front to back", 0.48, 0.3, 0.8},
          seat,
          {"back", "Back", "Height of the backrest's upper edge", 0.85, 0.4, 1.3}},
         {{"Seat", "Wood, light"}, {"Frame", "Steel, grey"}},
         chair},
        {"office-chair",
         "Office chair",
         "Seats",
         "Swivel chair on a crossed foot",
         {{"width", "Width", "Of the seat, as deep as wide", 0.5, 0.35, 0.7},
          {"seat", "Seat", "Height of the seat", 0.48, 0.35, 0.7},
          {"back", "Back", "Height of the backrest's upper edge", 1.0, 0.6, 1.5},
          {"armrest", "Armrests", "Height of their upper edges; below the seat: none", 0.68, 0.0, 0.9}},
         {{"Cushions", "Fabric, dark"}, {"Frame", "Dark plastic"}},
         office_chair},
        {"armchair",
         "Armchair",
         "Seats",
         "Upholstered seat for one",
         {{"width", "Width", "From left to right", 0.85, 0.6, 1.4},
          {"depth", "Depth", "From front to back", 0.85, 0.5, 1.3},
          {"height", "Height", "Of the back", 0.8, 0.55, 1.3},
          {"seat", "Seat", "Height of the seat", 0.42, 0.25, 0.5}},
         {{"Upholstery", "Fabric, grey"}, {"Feet", "Dark plastic"}},
         armchair},
        {"sofa",
         "Sofa",
         "Seats",
         "Upholstered seats side by side",
         {{"width", "Width", "From left to right", 2.0, 1.0, 5.0},
          {"depth", "Depth", "From front to back", 0.9, 0.5, 1.3},
          {"height", "Height", "Of the back", 0.8, 0.55, 1.3},
          {"seat", "Seat", "Height of the seat", 0.42, 0.25, 0.5},
          {"seats", "Seats", "Cushions side by side", 3.0, 1.0, 8.0, true}},
         {{"Upholstery", "Fabric, grey"}, {"Feet", "Dark plastic"}},
         sofa},
        {"stool",
         "Stool",
         "Seats",
         "Round seat on a column",
         {{"diameter", "Diameter", "Of the seat, over its corners", 0.38, 0.25, 0.7},
          {"height", "Height", "Of the seat: 0.45 m at tables, 0.75 m at bars", 0.45, 0.3, 0.95}},
         {{"Seat", "Wood, light"}, {"Foot", "Steel, grey"}},
         stool},
    };
}

}  // namespace hanei
