/// A scene in coarse cells, and how much of what leaves one can reach a place in another at most.
#pragma once

#include "engine/geometry/configuration_factor.h"
#include "engine/scene/faces.h"

#include <array>
#include <span>
#include <vector>

namespace hanei {

/// A part of a face, a whole piece of furniture, a luminous opening or one place: what bounds hold for is
/// within its corners' hull.
struct CeilingCell {
    std::vector<Vec3> corners;  ///< of a rectangle, of an axis-aligned box, or one place
    Vec3 low{0.0}, high{0.0};   ///< around the corners
    Vec3 centre{0.0};
    double radius = 0.0;        ///< m, of the sphere about `centre` around the corners
    double area = 0.0;          ///< m2, no less than what can be seen of it from any place
    double surface = 0.0;       ///< m2, of all of it
    Vec3 normal{0.0};           ///< of a flat one, towards its lit side; else 0
    ObjectId object;            ///< the furniture that it stands for; 0: none
    SurfaceRef face;            ///< the face that it is a part of, when it is
    Vec3 reflectance{0.0};      ///< the greatest in it, by band
    Vec3 apart{0.0};            ///< the greatest distance of a band's reflectance from the photometric one
    double photometric = 0.0;   ///< the greatest photometric reflectance
    double own_exitance = 0.0;  ///< lm/m2

    bool is_flat() const { return normal != Vec3{0.0}; }
};

/// Every face in rectangles; furniture of scenes of very many faces a piece each in its box.
/// Returns   some hundred to some hundreds.
std::vector<CeilingCell> ceiling_cells(const Scene& scene, std::span<const Face> faces);

CeilingCell cell_at(const Vec3& position, const Vec3& normal);
CeilingCell cell_around(std::span<const Vec3> places, double area);                        ///< their box
CeilingCell cell_of_rectangle(const Vec3& corner, const Vec3& along, const Vec3& across);  ///< faces along x across

double distance(const CeilingCell& a, const CeilingCell& b);  ///< m, of the boxes about them

/// How much of a diffuse source can be seen at most, whatever stands between.
struct SeenSource {
    double factor = 0.0;  ///< of the hemisphere: with M its greatest exitance M times this is no less than its lx
    double kernel = 0.0;  ///< 1/m2: with its flux in lm that times this is neither; infinite where they touch
};

/// Of `source` from any place of `receiver`.
///
/// Returns   a factor of 0 to 1: the least of three bounds. A plane with the angle a between both normals covers at
/// most
///           (1 - cos a)/2; a sphere of radius r at distance d (r/d)^2; an area A at distance d, with the
///           heights h and h' over each other's planes, A h h'/(pi d^4).
SeenSource most_seen(const CeilingCell& receiver, const CeilingCell& source);

/// The same of one place, with the factor exact for a rectangle or a box that nothing hides.
SeenSource most_seen(const Receiver& place, const CeilingCell& source);

}  // namespace hanei
