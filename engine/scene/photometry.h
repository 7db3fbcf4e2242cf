/// What a luminaire file says: measured luminous intensities and the luminous opening.
#pragma once

#include "engine/base/quantity.h"
#include "engine/scene/object_id.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hanei {

enum class PhotometricType { A, B, C };

/// The symmetry by which the stored planes stand for all directions (LM-63, EULUMDAT Isym).
enum class PhotometricSymmetry {
    none,        ///< planes cover the full circle; of types A and B what they do not cover is dark
    rotational,  ///< one plane for all
    quadrant,    ///< 0 to 90
    plane_0,     ///< about the plane 0-180: I(C) = I(-C); of types A and B I(H) = I(-H)
    plane_90,    ///< about the plane 90-270: I(C) = I(180 - C); stored from 90 to 270 or -90 to 90
};

// clang-format off
enum class OpeningShape {
    point, rectangle, circle, ellipse, box,
    vertical_cylinder,       ///< round or elliptical, as its extents say; so are the horizontal ones
    horizontal_cylinder,     ///< its axis along plane 0
    sphere, ellipsoid,
    vertical_disc,           ///< round or elliptical, faces plane 0: no extent along it
    horizontal_cylinder_90,  ///< its axis along plane 90
};
// clang-format on

/// The luminous opening by its extent along plane 0 (x), plane 90 (y) and the vertical (z), metres.
struct MeasuredOpeningSize {
    OpeningShape shape = OpeningShape::point;
    double extent_0 = 0.0;
    double extent_90 = 0.0;
    double height = 0.0;  ///< the greatest where the sides differ
    /// Luminous heights of the sides at planes 0, 90, 180 and 270 where the file states them apart (EULUMDAT).
    std::optional<std::array<double, 4>> side_heights = std::nullopt;
    bool operator==(const MeasuredOpeningSize&) const = default;
};

/// Lamps a luminaire may hold; the sets of one file are alternatives (EULUMDAT).
struct LampSet {
    double count = 1.0;  ///< below 0: absolute photometry
    std::string type;
    double lumens = 0.0;    ///< of all lamps of the set
    std::string colour;     ///< appearance or temperature, as written
    std::string rendering;  ///< colour rendering group or index, as written
    double watts = 0.0;     ///< with gear
    bool operator==(const LampSet&) const = default;
};

/// How the flux of lamps depends on their angle when the luminaire is tilted (LM-63 TILT). The table
/// stays that of the luminaire as it was measured; a tilted one shines by lamp_tilt_factor of it.
struct LampTilt {
    std::string file;  ///< name of a file of its own, not read; empty when the factors are here
    int geometry = 0;  ///< 1 vertical lamp, 2 horizontal and stays so, 3 horizontal and tilts; 0 none stated
    std::vector<double> angle_deg;
    std::vector<double> factor;  ///< one an angle
    bool operator==(const LampTilt&) const = default;
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
    double candela_per_figure = 1.0;                ///< product of the file's factors: candela / this is what it wrote
    std::optional<double> declared_output_ratio;    ///< light output ratio the file states, 0 to 1
    std::optional<double> declared_downward_share;  ///< share of the flux below the horizontal it states, 0 to 1
    std::vector<LampSet> lamp_sets;                 ///< as the file lists them: alternatives
    std::size_t lamp_set = 0;                       ///< the one the figures are for (with_lamp_set)
    int quarter_turns = 0;  ///< of the intensities against the opening, counter-clockwise seen from above, 0 to 3
    std::optional<LampTilt> tilt;
    std::vector<std::pair<std::string, std::string>> keywords;  ///< in file order
    std::vector<std::string> warnings;                          ///< found while reading; shown with the luminaire
    std::string unknown;  ///< fields of the project file this version does not know (UnknownFields, scene.h)
    bool operator==(const Photometry&) const = default;
};

}  // namespace hanei
