/// What a luminaire file says: measured luminous intensities and the luminous opening.
#pragma once

#include "engine/base/quantity.h"
#include "engine/scene/object_id.h"

#include <string>
#include <utility>
#include <vector>

namespace hanei {

enum class PhotometricType { A, B, C };

/// The symmetry by which the stored planes stand for all directions (LM-63, EULUMDAT Isym).
enum class PhotometricSymmetry {
    none,        ///< planes cover the full circle
    rotational,  ///< one plane for all
    quadrant,    ///< 0 to 90
    plane_0,     ///< about the plane 0-180: I(C) = I(-C)
    plane_90,    ///< about the plane 90-270: I(C) = I(180 - C)
};

enum class OpeningShape {
    point, rectangle, circle, ellipse, box,
    vertical_cylinder, horizontal_cylinder, sphere, ellipsoid, vertical_disc,
};

/// The luminous opening by its extent along plane 0 (x), plane 90 (y) and the vertical (z), metres.
struct MeasuredOpeningSize {
    OpeningShape shape = OpeningShape::point;
    double extent_0 = 0.0;
    double extent_90 = 0.0;
    double height = 0.0;
    bool operator==(const MeasuredOpeningSize&) const = default;
};

/// The table as the file holds it: angles in the file's own degrees and candela after the file's
/// factors, so that a project keeps the figures that were read. Convert on use (intensity.h).
struct Photometry {
    ObjectId id;
    std::string name;         ///< what the window calls it
    std::string source_file;  ///< file name it came from, without folder
    std::string format;       ///< "LM-63-2002", "EULUMDAT", ...
    PhotometricType type = PhotometricType::C;
    PhotometricSymmetry symmetry = PhotometricSymmetry::none;
    std::vector<double> horizontal_deg;  ///< C (type C), H (B), X (A): increasing
    std::vector<double> vertical_deg;    ///< gamma (C), V (B), Y (A): increasing
    std::vector<double> candela;         ///< horizontal_deg.size() x vertical_deg.size(), plane by plane
    MeasuredOpeningSize opening;
    int lamps = 0;
    double lamp_lumens = 0.0;  ///< of all lamps together; 0 when photometry is absolute
    bool absolute = false;
    double input_watts = 0.0;
    std::vector<std::pair<std::string, std::string>> keywords;  ///< in file order
    std::vector<std::string> warnings;                          ///< found while reading; shown with the luminaire
    bool operator==(const Photometry&) const = default;
};

}  // namespace hanei
