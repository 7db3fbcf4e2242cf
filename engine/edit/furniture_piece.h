/// Builds the parts of one piece of furniture from its sizes.
#pragma once

#include "engine/edit/furniture_library.h"

namespace hanei {

class Piece {
public:
    Piece(const FurnitureKind& kind, const FurnitureModel& model) : kind_(kind), model_(model) {}

    double operator[](std::string_view size) const { return size_of(kind_, model_, size); }
    int count(std::string_view size) const { return static_cast<int>((*this)[size]); }

    /// From corner to corner; nothing when there is no space between them.
    void box(int finish, const Vec3& low, const Vec3& high);
    /// An upright prism over a convex outline, counter-clockwise seen from above.
    void prism(int finish, const std::vector<Vec2>& outline, double low, double high);
    /// An upright prism over a regular polygon whose corners lie on the circle.
    void disc(int finish, const Vec2& middle, double diameter, int sides, double low, double high);
    /// A bar along x over a convex outline (y, z), counter-clockwise seen from +x.
    void bar(int finish, const std::vector<Vec2>& outline, double low, double high);
    /// A solid between two convex outlines with as many corners, in the planes of two heights.
    void frustum(int finish, const std::vector<Vec2>& below, const std::vector<Vec2>& above, double low, double high);

    std::vector<ModelPart> take() { return std::move(parts_); }

private:
    void solid(int finish, SolidShape shape);

    const FurnitureKind& kind_;
    const FurnitureModel& model_;
    std::vector<ModelPart> parts_;
};

std::vector<Vec2> regular_polygon(const Vec2& middle, double diameter, int sides);

// The library, by the files that build it.
std::vector<FurnitureKind> table_pieces();
std::vector<FurnitureKind> seat_pieces();
std::vector<FurnitureKind> storage_pieces();
std::vector<FurnitureKind> device_pieces();
std::vector<FurnitureKind> home_pieces();
std::vector<FurnitureKind> building_pieces();

}  // namespace hanei
