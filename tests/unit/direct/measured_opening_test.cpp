#include "engine/direct/measured_opening.h"

#include "engine/scene/placement.h"
#include "tests/opening_sums.h"
#include "tests/unit/direct/scenes.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

using testing::LocalReceiver;
using testing::luminaire_at;
using testing::pi;
using testing::sheet;
using testing::table;

const std::vector<MeasuredOpeningSize> shapes = {
    {OpeningShape::rectangle, 1.2, 0.3, 0},
    {OpeningShape::circle, 0.4, 0.4, 0},
    {OpeningShape::vertical_disc, 0, 0.3, 0.3},
    {OpeningShape::rectangle, 1.2, 0, 0},
    {OpeningShape::box, 0.6, 0.5, 0.2},
    {OpeningShape::box, 0.6, 0.5, 0.2, {{0.2, 0.05, 0.0, 0.1}}},
    {OpeningShape::vertical_cylinder, 0.3, 0.2, 0.4},
    {OpeningShape::horizontal_cylinder, 1.2, 0.1, 0.08},
    {OpeningShape::horizontal_cylinder_90, 0.1, 1.2, 0.08},
    {OpeningShape::sphere, 0.4, 0.4, 0.4},
    {OpeningShape::ellipsoid, 0.3, 0.4, 0.2},
};

/// Light to all sides, more to some: nothing of the shapes cancels.
Photometry lamp(const MeasuredOpeningSize& opening) {
    Photometry photometry = table([](double gamma) { return 300 + 200 * std::cos(gamma); }, 5);
    photometry.symmetry = PhotometricSymmetry::plane_0;
    photometry.horizontal_deg = {0, 90, 180};
    const std::vector<double> plane = photometry.candela;
    for (const double less : {0.2, 0.5}) {  // not at the poles, where the planes meet
        for (std::size_t k = 0; k < plane.size(); ++k)
            photometry.candela.push_back(plane[k] * (1 - less * std::sin(photometry.vertical_deg[k] * pi / 180)));
    }
    photometry.opening = opening;
    return photometry;
}

struct Lit {
    Scene scene;
    Emitter emitter;
};
Lit lit(const Photometry& photometry, double yaw = 0, double tilt = 0) {
    Scene scene;
    scene.photometries = {photometry};
    Luminaire luminaire = luminaire_at({1, 2, 3}, MeasuredOpening{}, AsMeasured{});
    luminaire.distribution = Measured{ObjectId{3}};
    luminaire.yaw = yaw;
    luminaire.tilt = tilt;
    return {scene, Emitter(scene, luminaire)};
}

/// Around the opening on all sides, near and far.
std::vector<LocalReceiver> receivers() {
    std::vector<LocalReceiver> made;
    for (const double distance : {0.75, 2.0}) {
        for (int k = 0; k < 14; ++k) {
            const double z = 1.0 - (2.0 * k + 1.0) / 14, turn = 2.399963 * k, level = std::sqrt(1 - z * z);
            const Vec3 direction{level * std::cos(turn), level * std::sin(turn), z};
            made.push_back({distance * direction, glm::normalize(-direction + Vec3{0.2, -0.1, 0.3})});
        }
    }
    return made;
}

TEST(MeasuredOpening, every_shape_lights_as_the_sum_of_its_surface) {
    for (const MeasuredOpeningSize& shape : shapes) {
        const Photometry photometry = lamp(shape);
        const Emitter emitter = lit(photometry).emitter;
        for (const LocalReceiver& at : receivers()) {
            const double expected = testing::opening_sum(photometry, at, 40);
            const Estimate got = emitter.estimate({at.position + Vec3{1, 2, 3}, at.normal, {}}, nullptr);
            // 2e-3: polygons of 32 corners for rounds this near, and the lattice of the sum
            EXPECT_NEAR(got.value, expected, got.error + 2e-3 * expected) << static_cast<int>(shape.shape);
        }
    }
}

TEST(MeasuredOpening, shadows_cut_every_facet) {
    for (const MeasuredOpeningSize& shape : shapes) {
        if (shape.shape == OpeningShape::vertical_disc) continue;  // seen from below it is a line
        const Photometry photometry = lamp(shape);
        const Emitter emitter = lit(photometry).emitter;
        const LocalReceiver at{{0.1, 0.05, -2}, {0, 0, 1}};
        const OccluderSet half({sheet({{1.03, -9, 2}, {9, -9, 2}, {9, 9, 2}, {1.03, 9, 2}})});
        const auto hidden = [&](const Vec3& place) {
            return half.blocks(at.position + Vec3{1, 2, 3}, place + Vec3{1, 2, 3});
        };
        const double expected = testing::opening_sum(photometry, at, 120, hidden);
        const Estimate got = emitter.estimate({at.position + Vec3{1, 2, 3}, at.normal, {}}, &half);
        const double whole = emitter.illuminance({at.position + Vec3{1, 2, 3}, at.normal, {}}, nullptr).value;
        EXPECT_NEAR(got.value, expected, got.error + 5e-3 * whole) << static_cast<int>(shape.shape);  // a lattice row
        EXPECT_LT(got.value, 0.7 * whole);
    }
}

TEST(MeasuredOpening, far_away_every_shape_gives_the_intensity_of_the_file) {
    for (const MeasuredOpeningSize& shape : shapes) {
        const Photometry photometry = lamp(shape);
        const Lit turned = lit(photometry, 0.4, 0.3);
        const Placement placed = placement([] {
            Luminaire luminaire;
            luminaire.position = {1, 2, 3};
            luminaire.yaw = 0.4;
            luminaire.tilt = 0.3;
            return luminaire;
        }());
        for (const LocalReceiver& at : receivers()) {
            const Vec3 direction = glm::normalize(at.position);
            const double distance = 3000;
            const Receiver receiver{placed.point(distance * direction), placed.direction(-direction), {}};
            const double expected = intensity(photometry, direction).value / (distance * distance);
            EXPECT_NEAR(turned.emitter.illuminance(receiver, nullptr).value / expected, 1, 1e-3);  // 0.6 m / 3 km
        }
    }
}

TEST(MeasuredOpening, all_flux_arrives_on_a_sphere_around_it) {
    for (const MeasuredOpeningSize& shape : shapes) {
        const Photometry photometry = lamp(shape);
        const Emitter emitter = lit(photometry).emitter;
        const int count = 4000;
        const double radius = 1.5;
        double flux = 0;
        for (int k = 0; k < count; ++k) {  // a spiral of equal areas
            const double z = 1.0 - (2.0 * k + 1.0) / count, turn = 2.39996322972865332 * k,
                         level = std::sqrt(1 - z * z);
            const Vec3 direction{level * std::cos(turn), level * std::sin(turn), z};
            flux += emitter.illuminance({Vec3{1, 2, 3} + radius * direction, -direction, {}}, nullptr).value;
        }
        flux *= 4 * pi * radius * radius / count;
        EXPECT_NEAR(flux / luminous_flux(photometry).value, 1, 4e-3) << static_cast<int>(shape.shape);
    }
}

TEST(MeasuredOpening, nothing_of_a_solid_is_seen_from_inside_it) {
    std::vector<Polygon> faces;
    for (const MeasuredOpeningSize& shape : shapes) {
        if (!is_solid(shape)) continue;
        seen_faces(solid_opening(shape), {0.01, 0.01, 0.01}, faces);
        EXPECT_TRUE(faces.empty());
        EXPECT_EQ(lit(lamp(shape)).emitter.illuminance({{1.01, 2.01, 3.01}, {0, 0, 1}, {}}, nullptr).value, 0.0);
    }
}

TEST(MeasuredOpening, sides_are_luminous_as_far_up_as_the_file_says) {
    // Level light past a box of which only the side at plane 0 is luminous.
    const Photometry one_side = lamp({OpeningShape::box, 0.6, 0.5, 0.2, {{0.2, 0.0, 0.0, 0.0}}});
    const Emitter emitter = lit(one_side).emitter;
    EXPECT_GT(emitter.illuminance({{4, 2, 3}, {-1, 0, 0}, {}}, nullptr).value, 20.0);
    EXPECT_EQ(emitter.illuminance({{-2, 2, 3}, {1, 0, 0}, {}}, nullptr).value, 0.0);
}

}  // namespace
}  // namespace hanei
