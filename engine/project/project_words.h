/// The words by which the project file calls kinds and shapes, one list for reading and writing.
#pragma once

#include "engine/scene/photometry.h"

#include <array>
#include <string_view>
#include <utility>

namespace hanei {

template <class Enum, std::size_t count>
using Words = std::array<std::pair<Enum, std::string_view>, count>;

inline constexpr Words<PhotometricType, 3> photometric_type_words{
    {{PhotometricType::A, "A"}, {PhotometricType::B, "B"}, {PhotometricType::C, "C"}}};

inline constexpr Words<PhotometricSymmetry, 5> symmetry_words{{{PhotometricSymmetry::none, "none"},
                                                               {PhotometricSymmetry::rotational, "rotational"},
                                                               {PhotometricSymmetry::quadrant, "quadrant"},
                                                               {PhotometricSymmetry::plane_0, "plane 0"},
                                                               {PhotometricSymmetry::plane_90, "plane 90"}}};

inline constexpr Words<OpeningShape, 11> opening_shape_words{
    {{OpeningShape::point, "point"},
     {OpeningShape::rectangle, "rectangle"},
     {OpeningShape::circle, "circle"},
     {OpeningShape::ellipse, "ellipse"},
     {OpeningShape::box, "box"},
     {OpeningShape::vertical_cylinder, "vertical cylinder"},
     {OpeningShape::horizontal_cylinder, "horizontal cylinder"},
     {OpeningShape::sphere, "sphere"},
     {OpeningShape::ellipsoid, "ellipsoid"},
     {OpeningShape::vertical_disc, "vertical disc"},
     {OpeningShape::horizontal_cylinder_90, "horizontal cylinder 90"}}};

template <class Enum, std::size_t count>
constexpr std::string_view word_of(const Words<Enum, count>& words, Enum meaning) {
    for (const auto& [value, word] : words)
        if (value == meaning) return word;
    return {};
}

}  // namespace hanei
