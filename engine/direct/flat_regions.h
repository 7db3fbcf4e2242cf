/// Regions of a plane: unions and differences of polygons, on Clipper's grid of whole numbers.
#pragma once

#include "engine/scene/faces.h"

#include <polyclipping/clipper.hpp>
#include <span>
#include <vector>

namespace hanei {

/// Takes polygons between a face's plane and a grid a billionth of the face wide. Private to the room.
class FlatRegions {
public:
    explicit FlatRegions(const Face& face);

    /// A rectangle around the face, wider by a tenth all round.
    Polygon around() const;

    ClipperLib::Path flat(const Polygon& polygon) const;  ///< counter-clockwise
    /// The face without its holes and without the covers.
    ClipperLib::Paths face_without(std::span<const Polygon> covers) const;
    std::vector<Polygon> in_space(const ClipperLib::Paths& paths) const;

private:
    const Face& face_;
    Vec3 origin_, x_, y_;
    Vec2 low_{0.0}, high_{0.0};
    double scale_ = 1.0;  ///< grid lines a metre
};

ClipperLib::Paths united(const ClipperLib::Paths& polygons);
ClipperLib::Paths common(const ClipperLib::Paths& a, const ClipperLib::Paths& b);
/// The borders of `of` where they run inside `within`.
ClipperLib::Paths borders(const ClipperLib::Paths& of, const ClipperLib::Paths& within);

}  // namespace hanei
