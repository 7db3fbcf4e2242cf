#include "engine/edit/furniture_piece.h"

#include <algorithm>

namespace hanei {
namespace {

constexpr FurnitureSize levels{"levels", "Levels", "Compartments one above the other", 5.0, 1.0, 12.0, true};

/// Two sides and a board below and above each level. Calls `fill(low, high)` with the heights of each.
template <class Fill>
void boards(Piece& piece, double inner_back, const Fill& fill) {
    const double width = piece["width"], depth = piece["depth"], height = piece["height"];
    const int count = piece.count("levels");
    const double board = std::min(0.02, 0.2 * height / (count + 1));
    for (const double x : {-0.5 * width, 0.5 * width - board})
        piece.box(0, {x, -0.5 * depth, 0.0}, {x + board, 0.5 * depth, height});
    const double step = (height - board) / count;
    for (int k = 0; k <= count; ++k) {
        piece.box(0, {board - 0.5 * width, -0.5 * depth, k * step},
                  {0.5 * width - board, inner_back, k * step + board});
        if (k < count) fill(board - 0.5 * width, 0.5 * width - board, k * step + board, (k + 1) * step);
    }
}

void shelf(Piece& piece) {
    boards(piece, 0.5 * piece["depth"], [](double, double, double, double) {});
}

void bookcase(Piece& piece) {
    const double depth = piece["depth"], back = 0.5 * depth - 0.01;
    boards(piece, back, [&](double left, double right, double low, double high) {
        const double books = left + piece["filled"] * (right - left), top = low + 0.8 * (high - low);
        piece.box(1, {left, -0.4 * depth, low}, {books, back, top});
    });
    const double width = piece["width"], board = std::min(0.02, 0.2 * piece["height"] / (piece.count("levels") + 1));
    piece.box(2, {board - 0.5 * width, back, 0.0}, {0.5 * width - board, 0.5 * depth, piece["height"]});
}

/// A body with doors side by side in front, on a plinth that stands back.
void doors(Piece& piece, double plinth) {
    const double width = piece["width"], depth = piece["depth"], height = piece["height"];
    const int count = piece.count("doors");
    const double front = 0.02, gap = std::min(0.004, 0.1 * width / count), back = std::min(0.05, 0.3 * depth);
    piece.box(2, {-0.5 * width, back - 0.5 * depth, 0.0}, {0.5 * width, 0.5 * depth, plinth});
    piece.box(0, {-0.5 * width, front - 0.5 * depth, plinth}, {0.5 * width, 0.5 * depth, height});
    for (int k = 0; k < count; ++k) {
        const double from = -0.5 * width + width * k / count, to = -0.5 * width + width * (k + 1) / count;
        piece.box(1, {k == 0 ? from : from + 0.5 * gap, -0.5 * depth, plinth},
                  {k + 1 == count ? to : to - 0.5 * gap, front - 0.5 * depth, height - gap});
    }
}

void cabinet(Piece& piece) { doors(piece, 0.06); }
void wardrobe(Piece& piece) { doors(piece, 0.08); }

void pallet_rack(Piece& piece) {
    const double bay = piece["bay"], depth = piece["depth"], height = piece["height"];
    const int bays = piece.count("bays"), rows = piece.count("levels");
    const double post = 0.1, beam = 0.12, left = -0.5 * (bays * bay + (bays + 1) * post);
    for (int k = 0; k <= bays; ++k) {
        const double x = left + k * (bay + post);
        for (const double y : {-0.5 * depth, 0.5 * depth - post})
            piece.box(0, {x, y, 0.0}, {x + post, y + post, height});
    }
    for (int k = 0; k < bays; ++k) {
        const double x = left + post + k * (bay + post);
        for (int row = 0; row < rows; ++row) {
            const double floor = height * row / rows, next = height * (row + 1) / rows;
            const double stands = row == 0 ? 0.0 : floor;
            if (row > 0)
                for (const double y : {-0.5 * depth, 0.5 * depth - post})
                    piece.box(1, {x, y, floor - beam}, {x + bay, y + post, floor});
            const double room = next - (row + 1 < rows ? beam : 0.0) - stands;
            const double load = std::min(piece["load"], room - 0.08);
            if (load < 0.2) continue;
            const int pallets = std::max(1, static_cast<int>(bay / 0.9));
            const double pitch = bay / pallets, width = std::min(0.8, pitch - 0.06);
            for (int p = 0; p < pallets; ++p) {
                const double from = x + (p + 0.5) * pitch - 0.5 * width;
                piece.box(3, {from, -0.5 * depth, stands}, {from + width, 0.5 * depth, stands + 0.144});
                piece.box(2, {from, -0.5 * depth, stands + 0.144}, {from + width, 0.5 * depth, stands + load});
            }
        }
    }
}

}  // namespace

std::vector<FurnitureKind> storage_pieces() {
    return {
        {"shelf",
         "Shelf",
         "Storage",
         "Open shelf of boards between two sides",
         {{"width", "Width", "From left to right", 0.8, 0.3, 3.0},
          {"depth", "Depth", "From front to back", 0.35, 0.15, 1.0},
          {"height", "Height", "Over all", 1.9, 0.3, 4.0},
          levels},
         {{"Boards", "Wood, light"}},
         shelf},
        {"bookcase",
         "Bookcase",
         "Storage",
         "Shelf with a back, its levels filled with books",
         {{"width", "Width", "From left to right", 0.9, 0.3, 3.0},
          {"depth", "Depth", "From front to back", 0.32, 0.2, 0.6},
          {"height", "Height", "Over all", 2.1, 0.3, 4.0},
          levels,
          {"filled", "Filled", "Share of each level that holds books, 0 to 1", 0.8, 0.0, 1.0}},
         {{"Boards", "Wood, medium"}, {"Books", "Books and paper"}, {"Back", "Wood, medium"}},
         bookcase},
        {"cabinet",
         "Cabinet",
         "Storage",
         "Closed cabinet with doors",
         {{"width", "Width", "From left to right", 0.8, 0.3, 3.0},
          {"depth", "Depth", "From front to back", 0.42, 0.2, 1.0},
          {"height", "Height", "Over all", 1.2, 0.3, 3.0},
          {"doors", "Doors", "Side by side", 2.0, 1.0, 8.0, true}},
         {{"Body", "Grey laminate"}, {"Doors", "White laminate"}, {"Plinth", "Dark plastic"}},
         cabinet},
        {"wardrobe",
         "Wardrobe",
         "Storage",
         "Tall cupboard with doors",
         {{"width", "Width", "From left to right", 1.5, 0.5, 5.0},
          {"depth", "Depth", "From front to back", 0.6, 0.3, 1.0},
          {"height", "Height", "Over all", 2.1, 1.0, 3.5},
          {"doors", "Doors", "Side by side", 3.0, 1.0, 10.0, true}},
         {{"Body", "Wood, light"}, {"Doors", "White laminate"}, {"Plinth", "Wood, light"}},
         wardrobe},
        {"pallet-rack",
         "Pallet rack",
         "Industry",
         "Rack of bays and levels with loaded pallets",
         {{"bay", "Bay", "Clear width between posts: 2.7 m takes three pallets", 2.7, 0.9, 4.0},
          {"depth", "Depth", "From front to back", 1.1, 0.6, 1.5},
          {"height", "Height", "Over all", 4.5, 1.5, 12.0},
          {"bays", "Bays", "Side by side", 2.0, 1.0, 10.0, true},
          {"levels", "Levels", "Pallets one above the other", 3.0, 1.0, 6.0, true},
          {"load", "Load", "Height of a loaded pallet; below 0.2 m: none", 1.1, 0.0, 2.5}},
         {{"Posts", "Steel, grey"}, {"Beams", "Red paint"}, {"Loads", "Cardboard"}, {"Pallets", "Wood, light"}},
         pallet_rack},
    };
}

}  // namespace hanei
