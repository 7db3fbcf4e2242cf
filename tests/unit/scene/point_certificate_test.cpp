#include "engine/scene/point_certificate.h"

#include "tests/opening_sums.h"

#include <gtest/gtest.h>
#include <random>

namespace hanei {
namespace {

using std::numbers::pi;
using testing::LocalReceiver;

Photometry beam(double exponent, double step_deg, const MeasuredOpeningSize& opening) {
    Photometry photometry;
    photometry.symmetry = PhotometricSymmetry::rotational;
    photometry.horizontal_deg = {0};
    for (double gamma = 0; gamma < 180 + 1e-9; gamma += step_deg) {
        photometry.vertical_deg.push_back(gamma);
        photometry.candela.push_back(1000 * std::pow(std::max(0.0, std::cos(gamma * pi / 180)), exponent));
    }
    photometry.opening = opening;
    return photometry;
}

/// Figures without any pattern: the planes disagree at the poles, and the table ends while it shines.
Photometry rough(PhotometricType type, PhotometricSymmetry symmetry, std::mt19937_64& random,
                 const MeasuredOpeningSize& opening) {
    Photometry photometry;
    photometry.type = type;
    photometry.symmetry = symmetry;
    const bool half = symmetry != PhotometricSymmetry::none;
    const double last = type == PhotometricType::C ? (half ? 180 : 330) : 90;
    for (double plane = type == PhotometricType::C || half ? 0 : -90; plane <= last; plane += 30)
        photometry.horizontal_deg.push_back(plane);
    for (double angle = type == PhotometricType::C ? 0 : -90; angle <= 100; angle += 12.5)
        photometry.vertical_deg.push_back(angle);
    if (type == PhotometricType::A) photometry.vertical_deg.pop_back();
    std::uniform_real_distribution<double> figure(200, 1000);
    for (std::size_t k = 0; k < photometry.horizontal_deg.size() * photometry.vertical_deg.size(); ++k)
        photometry.candela.push_back(figure(random));
    photometry.opening = opening;
    return photometry;
}

/// A receiver `distance` from the centre whose horizon the opening is above.
LocalReceiver receiver_at(double distance, double radius, std::mt19937_64& random) {
    std::normal_distribution<double> any;
    const Vec3 direction = glm::normalize(Vec3{any(random), any(random), any(random)});
    const Vec3 across = glm::normalize(glm::cross(direction, Vec3{any(random), any(random), any(random)}));
    const double cosine = std::uniform_real_distribution<double>(1.001 * radius / distance, 1)(random);
    return {distance * direction, -cosine * direction + std::sqrt(1 - cosine * cosine) * across};
}

const std::vector<MeasuredOpeningSize> openings = {
    {OpeningShape::rectangle, 1.2, 0.3, 0},           {OpeningShape::circle, 0.4, 0.4, 0},
    {OpeningShape::vertical_disc, 0, 0.3, 0.3},       {OpeningShape::box, 0.6, 0.5, 0.3, {{0.3, 0.1, 0.3, 0.2}}},
    {OpeningShape::vertical_cylinder, 0.3, 0.2, 0.4}, {OpeningShape::horizontal_cylinder, 1.2, 0.1, 0.1},
    {OpeningShape::ellipsoid, 0.3, 0.4, 0.2}};

std::vector<Photometry> files(std::mt19937_64& random) {
    std::vector<Photometry> made;
    for (const MeasuredOpeningSize& opening : openings) {
        made.push_back(beam(1, 5, opening));
        made.push_back(beam(100, 1, opening));
        made.push_back(rough(PhotometricType::C, PhotometricSymmetry::none, random, opening));
        made.push_back(rough(PhotometricType::C, PhotometricSymmetry::plane_0, random, opening));
        made.push_back(rough(PhotometricType::B, PhotometricSymmetry::plane_0, random, opening));
        made.push_back(rough(PhotometricType::A, PhotometricSymmetry::none, random, opening));
        made.back().quarter_turns = 1;
    }
    return made;
}

TEST(PointCertificate, is_never_less_than_what_the_point_leaves_out) {
    std::mt19937_64 random(7);
    for (const Photometry& photometry : files(random)) {
        const PointCertificate certificate(photometry);
        const double peak = peak_intensity(photometry).value;
        for (const double radii : {2.5, 4.0, 9.0, 30.0, 200.0}) {
            const double distance = radii * certificate.opening().radius;
            for (int k = 0; k < 12; ++k) {
                const LocalReceiver at = receiver_at(distance, certificate.opening().radius, random);
                const double cosine = -glm::dot(at.normal, at.position) / distance;
                const double candela = intensity(photometry, at.position / distance).value;
                const double point = candela * cosine;
                const double square = distance * distance;
                const double off = std::abs(testing::opening_sum(photometry, at, 16) * square - point);
                const double lattice = 4e-3 * peak / (radii * radii) + 1e-9 * peak;  // its own error, (1 / 16) squared
                EXPECT_LE(off, certificate.error(at.position, distance, candela, cosine) + lattice) << radii;
                EXPECT_LE(off, certificate.bound(distance) * peak + lattice) << radii;
            }
        }
    }
}

TEST(PointCertificate, is_within_twelve_times_the_truth_for_level_openings) {
    for (const double exponent : {1.0, 4.0, 20.0, 100.0}) {
        const Photometry photometry = beam(exponent, 1, {OpeningShape::rectangle, 0.6, 0.6, 0});
        const PointCertificate certificate(photometry);
        for (const double distance : {6.0, 24.0}) {
            double greatest = 0;
            for (double gamma = 0; gamma < 90; gamma += 2.0) {
                const Vec3 e = photometric_direction(PhotometricType::C, {0, gamma});
                const double sum = testing::opening_sum(photometry, {distance * e, -e}, 40) * distance * distance;
                greatest = std::max(greatest, std::abs(sum - intensity(photometry, e).value) / 1000);
            }
            EXPECT_LT(certificate.bound(distance), 12 * greatest) << exponent << " " << distance;
        }
    }
}

TEST(PointCertificate, never_rises_with_the_distance_and_says_from_where_on) {
    const PointCertificate certificate(beam(4, 2.5, {OpeningShape::rectangle, 0.6, 0.6, 0}));
    double before = certificate.bound(1.0);
    for (double distance = 1.1; distance < 1000; distance *= 1.1) {
        EXPECT_LE(certificate.bound(distance), before) << distance;
        before = certificate.bound(distance);
    }
    const double far = certificate.distance_for(0.01);
    EXPECT_LE(certificate.bound(far), 0.01);
    EXPECT_GT(certificate.bound(0.99 * far), 0.01);
}

TEST(PointCertificate, promises_nothing_where_no_distance_is_enough) {
    std::mt19937_64 random(7);
    const Photometry ends_bright =
        rough(PhotometricType::C, PhotometricSymmetry::none, random, {OpeningShape::rectangle, 0.6, 0.6, 0});
    EXPECT_TRUE(std::isinf(PointCertificate(ends_bright).distance_for(0.01)));
    EXPECT_TRUE(std::isinf(PointCertificate(ends_bright).bound(0.5)));   // within it
    EXPECT_EQ(PointCertificate(beam(1, 5, {})).distance_for(0.0), 0.0);  // a point is one
    Photometry dark = beam(1, 5, {OpeningShape::rectangle, 0.6, 0.6, 0});
    for (double& candela : dark.candela) candela = 0;
    EXPECT_EQ(PointCertificate(dark).bound(5), 0.0);
}

}  // namespace
}  // namespace hanei
