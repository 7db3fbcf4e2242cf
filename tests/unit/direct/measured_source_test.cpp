#include "engine/direct/measured_source.h"

#include "engine/direct/opening_integral.h"
#include "engine/scene/opening_shape.h"
#include "tests/unit/direct/scenes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace hanei {
namespace {

using testing::floor_point;
using testing::luminaire_at;
using testing::panel;
using testing::pi;
using testing::sheet;
using testing::table;

double cosine(double gamma) { return 1000 * std::max(0.0, std::cos(gamma)); }
double beam(double gamma) { return 1000 * std::pow(std::max(0.0, std::cos(gamma)), 40); }
double batwing(double gamma) { return gamma < pi / 2 ? 200 + 800 * std::pow(std::sin(2 * gamma), 2) : 0; }

Scene with(const Photometry& photometry) {
    Scene scene;
    scene.photometries = {photometry};
    return scene;
}

Luminaire measured(const Opening& opening, const Output& output) {
    Luminaire luminaire = luminaire_at({0, 0, 2.5}, opening, output);
    luminaire.distribution = Measured{ObjectId{3}};
    return luminaire;
}

TEST(MeasuredSource, a_measured_point_obeys_the_inverse_square_law) {
    const Scene scene = with(table(cosine, 1));
    const Emitter as_filed(scene, measured(PointOpening{}, AsMeasured{}));
    EXPECT_NEAR(as_filed.illuminance(floor_point(0, 0), nullptr).value, 1000 / 6.25, 1e-10);
    EXPECT_NEAR(as_filed.flux().value, luminous_flux(scene.photometries[0]).value, 1e-9);
    const Emitter scaled(scene, measured(PointOpening{}, LuminousFlux{2 * as_filed.flux().value}));
    EXPECT_NEAR(scaled.illuminance(floor_point(1, 1), nullptr).value,
                2 * as_filed.illuminance(floor_point(1, 1), nullptr).value, 1e-10);
}

TEST(MeasuredSource, a_cosine_table_on_a_panel_is_a_diffuse_panel) {
    const Scene scene = with(table(cosine, 0.5));
    const Luminaire by_table = measured(panel(1.2, 0.6), LuminousFlux{3000});
    const Luminaire diffuse = luminaire_at({0, 0, 2.5}, panel(1.2, 0.6), LuminousFlux{3000});
    for (const Receiver& receiver :
         {floor_point(0, 0), floor_point(1.5, 1), Receiver{{0.4, 0.2, 2.3}, {0, 0, 1}, {}},
          Receiver{{0.55, 0.1, 2.45}, glm::normalize(Vec3{1, 1, 1}), {}}, Receiver{{2, 0, 2}, {-1, 0, 0}, {}}}) {
        const double expected = Emitter(scene, diffuse).illuminance(receiver, nullptr).value;
        const double got = Emitter(scene, by_table).illuminance(receiver, nullptr).value;
        EXPECT_NEAR(got / expected, 1, 5e-4) << receiver.position.z;  // the promise of OpeningIntegral
    }
}

/// The definition, summed over a fine lattice of the visible opening.
double summed(const Photometry& photometry, double width, double depth, const Receiver& receiver,
              const OccluderSet* occluders) {
    const int n = 600;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const Vec3 place{width * ((i + 0.5) / n - 0.5), depth * ((j + 0.5) / n - 0.5), 2.5};
            const Vec3 away = receiver.position - place;
            const double distance = glm::length(away);
            const double height = -glm::dot(away, receiver.normal);
            if (height <= 0 || (occluders && occluders->blocks(receiver.position, place))) continue;
            sum += intensity(photometry, away / distance).value * height / (distance * distance * distance);
        }
    }
    return sum / (n * n);
}

TEST(MeasuredSource, narrow_beams_near_their_opening_are_the_sum_of_its_elements) {
    for (const auto& [shape, step] : {std::pair{&beam, 2.5}, std::pair{&batwing, 5.0}}) {
        const Scene scene = with(table(shape, step));
        const Emitter emitter(scene, measured(panel(1.2, 0.6), AsMeasured{}));
        for (const Receiver& receiver :
             {floor_point(0, 0), floor_point(0.8, 0.3), Receiver{{0.3, 0.1, 2.2}, {0, 0, 1}, {}},
              Receiver{{0.7, 0, 1.5}, glm::normalize(Vec3{-1, 0, 0.3}), {}},
              Receiver{{-0.2, 0.4, 2.4}, {0, 0, 1}, {}}}) {
            const double expected = summed(scene.photometries[0], 1.2, 0.6, receiver, nullptr);
            const double got = emitter.illuminance(receiver, nullptr).value;
            EXPECT_NEAR(got / expected, 1, 2e-3)  // the worst that OpeningIntegral states
                << receiver.position.x << " " << receiver.position.z;
        }
    }
}

TEST(MeasuredSource, far_away_an_opening_is_a_point) {
    const Scene scene = with(table(batwing, 5));
    Receiver far = floor_point(30, 20);
    far.position.z = -60;
    const double extended = Emitter(scene, measured(panel(1.2, 0.6), AsMeasured{})).illuminance(far, nullptr).value;
    const double point = Emitter(scene, measured(PointOpening{}, AsMeasured{})).illuminance(far, nullptr).value;
    EXPECT_NEAR(extended / point, 1, 1e-3);  // (1.3 m / 72 m)^2 = 3e-4, times the curvature of the table
}

TEST(MeasuredSource, its_penumbra_is_cut_exactly) {
    const Scene scene = with(table(batwing, 5));
    const OccluderSet set({sheet({{0.1, -2, 1}, {3, -2, 1}, {3, 2, 1}, {0.1, 2, 1}}),
                           sheet({{-0.2, 0.05, 1.4}, {0.3, 0.05, 1.4}, {0, 0.2, 1.8}})});
    const Emitter emitter(scene, measured(panel(1.2, 0.6), AsMeasured{}));
    for (const Receiver& receiver : {floor_point(0.2, 0), floor_point(0, 0.1), floor_point(0.4, -0.2)}) {
        const double expected = summed(scene.photometries[0], 1.2, 0.6, receiver, &set);
        EXPECT_NEAR(emitter.illuminance(receiver, &set).value / expected, 1, 4e-3);  // the lattice: 1/600 of an edge
    }
    EXPECT_EQ(emitter.illuminance(floor_point(2.5, 0), &set).value, 0.0);
}

TEST(MeasuredSource, light_of_a_file_goes_where_the_file_says) {
    // All of it upward: the floor stays dark, the ceiling is lit.
    const Scene scene = with(table([](double gamma) { return gamma > pi / 2 + 0.01 ? 500.0 : 0.0; }, 5));
    const Emitter emitter(scene, measured(panel(1.2, 0.6), AsMeasured{}));
    EXPECT_EQ(emitter.illuminance(floor_point(0, 0), nullptr).value, 0.0);
    EXPECT_GT(emitter.illuminance({{0, 0, 3.5}, {0, 0, -1}, {}}, nullptr).value, 100.0);
}

TEST(MeasuredSource, light_that_goes_down_only_leaves_what_is_above_dark) {
    const Scene scene = with(table([](double gamma) { return gamma < pi / 2 - 0.1 ? 500.0 : 0.0; }, 5));
    const Emitter emitter(scene, measured(panel(1.2, 0.6), AsMeasured{}));
    EXPECT_EQ(emitter.illuminance({{0, 0, 2.6}, {0, 0, -1}, {}}, nullptr).value, 0.0);
    EXPECT_EQ(emitter.illuminance({{0.9, 0, 2.6}, {-1, 0, 0}, {}}, nullptr).value, 0.0);
    EXPECT_GT(emitter.illuminance({{0.9, 0, 2.2}, {-1, 0, 0}, {}}, nullptr).value, 10.0);
}

TEST(MeasuredSource, a_tilted_lamp_shines_by_the_factor_of_its_file) {
    Photometry photometry = table(cosine, 5);
    photometry.tilt = LampTilt{"", 1, {0, 45, 90}, {1.0, 0.9, 0.7}};
    Luminaire luminaire = measured(PointOpening{}, AsMeasured{});
    luminaire.tilt = 67.5 * pi / 180;
    luminaire.yaw = 1.0;
    const double flux = luminous_flux(photometry).value;
    EXPECT_NEAR(Emitter(with(photometry), luminaire).flux().value, 0.8 * flux, 1e-9 * flux);
    luminaire.roll = pi / 2;  // on its side: 90 degrees from the vertical whatever the tilt
    EXPECT_NEAR(Emitter(with(photometry), luminaire).flux().value, 0.7 * flux, 1e-9 * flux);
    photometry.tilt->geometry = 2;
    EXPECT_NEAR(Emitter(with(photometry), luminaire).flux().value, flux, 1e-9 * flux);
    photometry.tilt->geometry = 3;
    luminaire.tilt = luminaire.roll = 0;
    EXPECT_NEAR(Emitter(with(photometry), luminaire).flux().value, flux, 1e-9 * flux);
}

TEST(MeasuredOpening, shapes_of_a_file_keep_their_area) {
    const auto area = [](OpeningShape shape, double x, double y, double z) {
        const Polygon outline = flat_opening({shape, x, y, z});
        double twice = 0;
        for (std::size_t k = 2; k < outline.size(); ++k) {
            twice += glm::length(glm::cross(outline[k - 1] - outline[0], outline[k] - outline[0]));
        }
        return 0.5 * twice;
    };
    EXPECT_NEAR(area(OpeningShape::rectangle, 1.2, 0.3, 0), 0.36, 1e-15);
    EXPECT_NEAR(area(OpeningShape::box, 1.2, 0.3, 0.1), 0.36, 1e-15);
    EXPECT_NEAR(area(OpeningShape::circle, 0.4, 0.4, 0), pi * 0.04, 1e-15);
    EXPECT_NEAR(area(OpeningShape::ellipse, 0.4, 0.2, 0), pi * 0.02, 1e-15);
    EXPECT_NEAR(area(OpeningShape::rectangle, 1.2, 0, 0), 1.2 * 0.012, 1e-15);
    EXPECT_TRUE(flat_opening({}).empty());
    EXPECT_TRUE(flat_opening({OpeningShape::rectangle, 0, 0, 0}).empty());
    for (const Vec3& corner : flat_opening({OpeningShape::vertical_disc, 0, 0.3, 0.3})) EXPECT_EQ(corner.x, 0.0);
}

TEST(MeasuredOpening, the_opening_of_the_file_lights_as_a_polygon_of_its_size) {
    Photometry photometry = table(cosine, 1);
    photometry.opening = {OpeningShape::rectangle, 1.2, 0.6, 0};
    const Scene scene = with(photometry);
    const double stated =
        Emitter(scene, measured(MeasuredOpening{}, AsMeasured{})).illuminance(floor_point(1, 0), nullptr).value;
    const double drawn =
        Emitter(scene, measured(panel(1.2, 0.6), AsMeasured{})).illuminance(floor_point(1, 0), nullptr).value;
    EXPECT_DOUBLE_EQ(stated, drawn);
}

}  // namespace
}  // namespace hanei
