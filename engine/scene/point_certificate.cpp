#include "engine/scene/point_certificate.h"

#include "engine/geometry/polygon.h"
#include "engine/scene/intensity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hanei {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double nearest_in_radii = 2.0;  // within it the series below do not help

/// Sums over triangles: area, first and second moments.
struct Moments {
    double area = 0.0;
    Vec3 first{0.0};
    Mat3 second{0.0};

    void add(const Vec3& a, const Vec3& b, const Vec3& c) {
        const double part = 0.5 * glm::length(glm::cross(b - a, c - a));
        area += part;
        first += part / 3.0 * (a + b + c);
        const Vec3 sum = a + b + c;
        second +=
            part / 12.0 *
            (glm::outerProduct(a, a) + glm::outerProduct(b, b) + glm::outerProduct(c, c) + glm::outerProduct(sum, sum));
    }
};

/// rad, what a sight line turns by at most from the centre to the farthest element; not less than it.
double way(double ratio) { return ratio / ((1.0 - ratio) * (1.0 - ratio)); }

double trace(const Mat3& m) { return m[0][0] + m[1][1] + m[2][2]; }

}  // namespace

OpeningForm form_of(std::span<const Polygon> pieces) {
    Moments sums;
    for (const Polygon& piece : pieces) {
        for (std::size_t k = 2; k < piece.size(); ++k) sums.add(piece[0], piece[k - 1], piece[k]);
    }
    OpeningForm form;
    if (!(sums.area > 0.0)) return form;
    form.centre = sums.first / sums.area;
    for (const Polygon& piece : pieces) {
        for (const Vec3& corner : piece) form.radius = std::max(form.radius, glm::distance(corner, form.centre));
    }
    const Mat3 about_centre = sums.second / sums.area - glm::outerProduct(form.centre, form.centre);
    const double both = std::max(0.0, trace(about_centre));
    // Of the flat form's two variances: their sum is the trace, the sum of their squares that of the square.
    const double difference = 2.0 * trace(about_centre * about_centre) - both * both;
    form.level = true;
    for (const Polygon& piece : pieces) {
        for (const Vec3& corner : piece)
            form.level = form.level && std::abs(corner.z - form.centre.z) <= 1e-9 * form.radius;
    }
    form.mean_distance = std::sqrt(both);
    form.spread = std::sqrt(0.5 * (both + std::sqrt(std::max(0.0, difference))));
    return form;
}

OpeningForm form_of(const MeasuredOpeningSize& size) {
    if (!is_solid(size)) {
        const Polygon flat = flat_opening(size);
        return form_of(std::span(&flat, flat.empty() ? 0 : 1));
    }
    return form_of(solid_opening(size));
}

OpeningForm form_of(const OpeningSolid& solid) {
    const Vec3 areas = solid.areas_along_axes();
    double least = areas.z;
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0}})
        least = std::min(least, solid.projected_area(axis));
    constexpr double of_polygon = 1.004;  // corners of a round outline of 32 sides and equal area
    OpeningForm form;
    form.radius = of_polygon * glm::length(solid.half);
    form.mean_distance = form.spread = form.radius;
    form.solid = true;
    form.angular = solid.kind == OpeningSolid::Kind::box;
    form.unevenness = least > 0.0 ? glm::length(areas) / least : infinite;
    form.depth = least > 0.0 ? glm::dot(areas, solid.half) / least : infinite;
    return form;
}

PointCertificate::PointCertificate(const Photometry& photometry)
    : PointCertificate(photometry, form_of(photometry.opening)) {}

PointCertificate::PointCertificate(const Photometry& photometry, const OpeningForm& opening)
    : opening_(opening), changes_(photometry), peak_(peak_intensity(photometry).value) {}

// With F = I G, G = cos / r2 and an element at x, linear parts taken at the centre (index 0):
//
//     F - F0 - (linear in x) = I0 rest(G) + G rest(I) + (I' x)(G - G0)
//
// G is a derivative of 1 / r, so that its first and second derivatives are at most 2 / r3 and 6 / r4.
// The mean of what is linear vanishes about the centroid.
double PointCertificate::flat(const AngularChange& change, double ratio, double intensity, double cosine) const {
    const double nearer = 1.0 - ratio;
    const double square = std::pow(opening_.mean_distance / opening_.radius * ratio, 2);
    const double root = opening_.mean_distance / opening_.radius;
    const double along = opening_.spread / opening_.radius;
    const double angle = way(ratio);

    const double of_distance = 3.0 * square / std::pow(nearer, 4) * intensity;
    const double mixed = 2.0 * change.slope * square / std::pow(nearer, 3);
    const double received = std::min(1.0 / (nearer * nearer), cosine + 2.0 * ratio / std::pow(nearer, 3));
    double of_intensity = change.slope * root * angle;
    if (change.kinks < infinite) {
        // A level opening has no extent along meridians towards its own horizon.
        const double lean = opening_.level ? change.lean : 1.0;
        const double passed = std::min(root, along + root * change.turning) * angle;
        const double on_the_way = passed * (lean * change.kinks + change.bends);
        const double between = square * (change.curvature / std::pow(nearer, 4) + change.slope / std::pow(nearer, 3));
        of_intensity = std::min(of_intensity, on_the_way + between);
    }
    return of_distance + mixed + received * (of_intensity + change.jump);
}

// An element's weight is its share in the projected area towards the receiver. All weights together
// are at most 1 on a convex body.
double PointCertificate::solid(const AngularChange& change, double distance, double intensity, double cosine) const {
    const double ratio = opening_.radius / distance;
    const double nearer = 1.0 - ratio;
    const double received = std::min(1.0 / (nearer * nearer), cosine + 2.0 * ratio / std::pow(nearer, 3));
    const double change_of_intensity = change.slope * ratio / nearer + change.jump;
    const double over_opening = received * change_of_intensity + 2.0 * ratio / std::pow(nearer, 3) * intensity;
    const double most = std::max(received * (intensity + change_of_intensity), intensity * cosine);
    return std::min(most, over_opening + (1.0 - least_weight(distance)) * intensity * cosine);
}

// What the weights sum to at least. A box: the facets' own heights under the receiver against those of
// the farthest corner. A round: what the farthest place of the silhouette, the nearest of the body and
// the greatest projected area among the directions leave of it.
double PointCertificate::least_weight(double distance) const {
    if (opening_.angular)
        return distance > 3.0 * opening_.depth ? 1.0 - 2.0 * opening_.depth / (distance - opening_.depth) : 0.0;
    const double ratio = opening_.radius / distance;
    const double nearer = 1.0 - ratio;
    return std::pow(nearer / (1.0 + ratio), 2) / std::pow(1.0 + ratio * ratio, 1.5) /
           (1.0 + opening_.unevenness * ratio / nearer);
}

double PointCertificate::error(const Vec3& direction, double distance, double intensity, double cosine) const {
    if (opening_.radius == 0.0) return 0.0;
    const double ratio = opening_.radius / distance;
    if (!(ratio * nearest_in_radii < 1.0)) return infinite;
    constexpr double rounding = 1e-9;  // of an angle by its cosine, and of files that write 89.99999
    const double colatitude = changes_.colatitude(direction);
    const AngularChange change = changes_.over(colatitude - rounding, colatitude + rounding, way(ratio));
    return opening_.solid ? solid(change, distance, intensity, cosine) : flat(change, ratio, intensity, cosine);
}

double PointCertificate::bound(double distance) const {
    if (opening_.radius == 0.0 || !(peak_ > 0.0)) return 0.0;
    const double ratio = opening_.radius / distance;
    if (!(ratio * nearest_in_radii < 1.0)) return infinite;
    constexpr int bands = 180;
    double greatest = 0.0;
    for (int band = 0; band < bands; ++band) {
        const double low = band * std::numbers::pi / bands, high = (band + 1) * std::numbers::pi / bands;
        const AngularChange change = changes_.over(low, high, way(ratio));
        greatest = std::max(greatest, opening_.solid ? solid(change, distance, change.greatest, 1.0)
                                                     : flat(change, ratio, change.greatest, 1.0));
    }
    return greatest / peak_;
}

double PointCertificate::distance_for(double share) const {
    if (opening_.radius == 0.0) return 0.0;
    double near = nearest_in_radii * opening_.radius, far = 1e4 * opening_.radius;
    if (!(bound(far) <= share)) return infinite;
    while (far > near * 1.001) {
        const double middle = std::sqrt(near * far);
        (bound(middle) <= share ? far : near) = middle;
    }
    return far;
}

}  // namespace hanei
