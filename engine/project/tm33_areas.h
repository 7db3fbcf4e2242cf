/// The luminous opening of a TM-33 file: the emission areas on the faces of its emitters.
#pragma once

#include "engine/project/luminaire_findings.h"
#include "engine/scene/photometry.h"

#include <pugixml.hpp>
#include <string_view>
#include <vector>

namespace hanei {

/// One luminous area of a face, metres. `across` runs along the face's length (top, bottom, C0 and C180)
/// or width (C90, C270), `up` along its width or height.
struct Tm33Area {
    enum class Face { top, bottom, c0, c90, c180, c270 };
    Face face = Face::bottom;
    double length = 0.0, width = 0.0, height = 0.0;  ///< 0 where the face has none
    double length_offset = 0.0, width_offset = 0.0;
    bool round = false;
};

/// The areas of an <Emitter>. A length that is no number is a fault.
std::vector<Tm33Area> tm33_areas(std::string_view text, const pugi::xml_node& emitter, LuminaireFindings& findings);

/// One opening for all areas: the rectangle around those of the top and the bottom, or the ellipse that
/// one round area is, with the heights of the areas on its sides. Lengths lie along plane 90 when
/// `length_along_90` (a goniometer of the CIE), else along plane 0 (IES).
///
/// Returns   a point without areas, and where side areas alone leave an extent unknown; warnings at
///           `line` for what one opening cannot say.
MeasuredOpeningSize tm33_opening(const std::vector<Tm33Area>& areas, bool length_along_90, int line,
                                 LuminaireFindings& findings);

}  // namespace hanei
