#include "engine/scene/intensity.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<double> steps(double from, double to, double step) {
    std::vector<double> angles;
    for (int k = 0; from + k * step <= to + 1e-9; ++k) angles.push_back(from + k * step);
    return angles;
}

/// A table whose figures are a function of the direction.
template <class Function>
Photometry table(PhotometricType type, PhotometricSymmetry symmetry, std::vector<double> horizontal,
                 std::vector<double> vertical, const Function& of_direction) {
    Photometry photometry;
    photometry.type = type;
    photometry.symmetry = symmetry;
    for (const double h : horizontal) {
        for (const double v : vertical) photometry.candela.push_back(of_direction(photometric_direction(type, {h, v})));
    }
    photometry.horizontal_deg = std::move(horizontal);
    photometry.vertical_deg = std::move(vertical);
    return photometry;
}

double uniform(const Vec3&) { return 100.0; }
/// Without any symmetry, smooth, positive.
double lopsided(const Vec3& e) { return 300.0 + 120.0 * e.x + 70.0 * e.y - 90.0 * e.z + 50.0 * e.x * e.y; }

std::vector<Photometry> whole_spheres(double (*of_direction)(const Vec3&)) {
    return {
        table(PhotometricType::C, PhotometricSymmetry::none, steps(0, 345, 15), steps(0, 180, 5), of_direction),
        table(PhotometricType::C, PhotometricSymmetry::none, steps(0, 360, 15), steps(0, 180, 5), of_direction),
        table(PhotometricType::B, PhotometricSymmetry::none, steps(-90, 90, 5), steps(-180, 180, 5), of_direction),
        table(PhotometricType::A, PhotometricSymmetry::none, steps(-180, 180, 5), steps(-90, 90, 5), of_direction),
    };
}

TEST(Intensity, the_nadir_the_planes_and_the_zenith_lie_where_the_types_say) {
    const auto angles = [](PhotometricType type, Vec3 e) { return photometric_angles(type, e); };
    EXPECT_EQ(angles(PhotometricType::C, {0, 0, -1}).vertical_deg, 0.0);
    EXPECT_EQ(angles(PhotometricType::C, {0, 1, 0}).horizontal_deg, 90.0);
    EXPECT_EQ(angles(PhotometricType::C, {0, -1, 0}).horizontal_deg, 270.0);
    EXPECT_EQ(angles(PhotometricType::B, {0, 0, -1}).vertical_deg, 0.0);
    EXPECT_EQ(angles(PhotometricType::B, {1, 0, 0}).vertical_deg, 90.0);
    EXPECT_EQ(angles(PhotometricType::B, {0, -1, 0}).horizontal_deg, 90.0);
    EXPECT_EQ(angles(PhotometricType::A, {0, 0, -1}).vertical_deg, -90.0);
    EXPECT_EQ(angles(PhotometricType::A, {1, 0, 0}).vertical_deg, 0.0);
    EXPECT_EQ(angles(PhotometricType::A, {0, -1, 0}).horizontal_deg, 90.0);
}

TEST(Intensity, angles_and_directions_of_every_type_undo_each_other) {
    for (const auto type : {PhotometricType::A, PhotometricType::B, PhotometricType::C}) {
        const Vec3 direction = glm::normalize(Vec3{0.3, -0.5, 0.7});
        const Vec3 back = photometric_direction(type, photometric_angles(type, direction));
        EXPECT_NEAR(glm::length(back - direction), 0.0, 1e-15);
    }
}

TEST(Intensity, at_a_table_angle_is_the_figure_of_the_table) {
    for (const Photometry& photometry : whole_spheres(lopsided)) {
        for (const Vec3 direction : {Vec3{0, 0, -1}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0}, Vec3{-1, 0, 0}}) {
            EXPECT_NEAR(intensity(photometry, direction).value, lopsided(direction), 1e-10);
        }
    }
}

TEST(Intensity, the_same_light_in_types_A_B_and_C_is_the_same_in_every_direction) {
    for (const Photometry& photometry : whole_spheres(lopsided)) {
        for (double plane = 3.0; plane < 360.0; plane += 17.0) {
            for (double gamma = 2.0; gamma < 180.0; gamma += 13.0) {
                const Vec3 e = photometric_direction(PhotometricType::C, {plane, gamma});
                EXPECT_NEAR(intensity(photometry, e).value, lopsided(e), 4.0);  // 15 deg steps of a 500 cd table
            }
        }
    }
}

TEST(Intensity, is_linear_between_two_angles_and_between_the_last_plane_and_the_first) {
    Photometry photometry;
    photometry.horizontal_deg = {0, 120, 240};
    photometry.vertical_deg = {0, 90};
    photometry.candela = {0, 30, 0, 60, 0, 90};
    const auto at = [&](double plane, double gamma) {
        return intensity(photometry, photometric_direction(PhotometricType::C, {plane, gamma})).value;
    };
    EXPECT_NEAR(at(60, 90), 45.0, 1e-9);
    EXPECT_NEAR(at(60, 30), 15.0, 1e-9);
    EXPECT_NEAR(at(300, 90), 60.0, 1e-9);
}

TEST(Intensity, is_dark_past_the_last_vertical_angle_and_lit_at_it) {
    const Photometry down = table(PhotometricType::C, PhotometricSymmetry::rotational, {0}, steps(0, 90, 10), uniform);
    EXPECT_EQ(intensity(down, {1, 0, 0}).value, 100.0);
    EXPECT_EQ(intensity(down, glm::normalize(Vec3{1, 0, 1e-6})).value, 0.0);
    const Photometry up = table(PhotometricType::C, PhotometricSymmetry::rotational, {0}, steps(90, 180, 10), uniform);
    EXPECT_EQ(intensity(up, {0, 0, -1}).value, 0.0);
    EXPECT_EQ(intensity(up, {0, 0, 1}).value, 100.0);
}

TEST(Intensity, a_file_that_stores_a_half_means_the_whole) {
    const auto about_0 = [](const Vec3& e) { return 200.0 + 100.0 * e.x + 50.0 * std::abs(e.y); };
    const auto about_90 = [](const Vec3& e) { return 200.0 + 100.0 * e.y + 50.0 * std::abs(e.x); };
    const auto both = [](const Vec3& e) { return 200.0 + 100.0 * std::abs(e.y) + 50.0 * std::abs(e.x); };
    const std::vector<double> gamma = steps(0, 180, 5);
    const auto type = PhotometricType::C;
    struct Pair {
        Photometry stored, whole;
    };
    const std::vector<double> circle = steps(0, 345, 15);
    const std::vector<Pair> pairs{{table(type, PhotometricSymmetry::plane_0, steps(0, 180, 15), gamma, about_0),
                                   table(type, PhotometricSymmetry::none, circle, gamma, about_0)},
                                  {table(type, PhotometricSymmetry::plane_90, steps(90, 270, 15), gamma, about_90),
                                   table(type, PhotometricSymmetry::none, circle, gamma, about_90)},
                                  {table(type, PhotometricSymmetry::plane_90, steps(-90, 90, 15), gamma, about_90),
                                   table(type, PhotometricSymmetry::none, circle, gamma, about_90)},
                                  {table(type, PhotometricSymmetry::quadrant, steps(0, 90, 15), gamma, both),
                                   table(type, PhotometricSymmetry::none, circle, gamma, both)}};
    for (const auto& [stored, whole] : pairs) {
        for (double plane = 0.0; plane < 360.0; plane += 7.0) {
            const Vec3 e = photometric_direction(type, {plane, 63.0});
            EXPECT_NEAR(intensity(stored, e).value, intensity(whole, e).value, 1e-9) << plane;
        }
        EXPECT_NEAR(luminous_flux(stored).value, luminous_flux(whole).value, 1e-9);
        EXPECT_NEAR(zone_average_flux(stored).value, zone_average_flux(whole).value, 1e-9);
    }
}

TEST(LuminousFlux, of_a_uniform_light_is_4_pi_times_its_intensity_in_every_type) {
    for (const Photometry& photometry : whole_spheres(uniform)) {
        EXPECT_NEAR(luminous_flux(photometry).value, 400.0 * pi, 1e-9);
        EXPECT_NEAR(zone_average_flux(photometry).value, 400.0 * pi, 1e-9);
        EXPECT_NEAR(downward_flux(photometry).value, 200.0 * pi, 1e-9);
    }
}

TEST(LuminousFlux, of_a_cosine_light_comes_to_pi_times_its_peak_as_steps_become_finer) {
    const auto cosine = [](const Vec3& e) { return 100.0 * std::max(0.0, -e.z); };
    const auto fine = table(PhotometricType::C, PhotometricSymmetry::rotational, {0}, steps(0, 180, 0.5), cosine);
    EXPECT_NEAR(luminous_flux(fine).value, 100.0 * pi, 0.002);  // step^2 / 12 of 314 lm
    EXPECT_NEAR(downward_flux(fine).value, luminous_flux(fine).value, 1e-9);
    const auto on_side =
        table(PhotometricType::B, PhotometricSymmetry::none, steps(-90, 90, 0.5), steps(-90, 90, 0.5), cosine);
    EXPECT_NEAR(luminous_flux(on_side).value, 100.0 * pi, 0.004);
}

TEST(LuminousFlux, is_the_integral_of_the_intensity_interpolated) {
    Photometry coarse =
        table(PhotometricType::C, PhotometricSymmetry::none, steps(0, 270, 90), steps(0, 180, 45), lopsided);
    coarse.vertical_deg[2] = 80.0;  // the horizontal lies inside an interval
    double sum = 0.0;
    double down = 0.0;
    const double step = 0.25;
    for (double gamma = step / 2; gamma < 180.0; gamma += step) {
        const double solid_angle =
            (std::cos((gamma - step / 2) * pi / 180) - std::cos((gamma + step / 2) * pi / 180)) * 2 * pi / 360;
        for (double plane = 0.5; plane < 360.0; plane += 1.0) {
            const double part =
                solid_angle * intensity(coarse, photometric_direction(PhotometricType::C, {plane, gamma})).value;
            sum += part;
            if (gamma < 90.0) down += part;
        }
    }
    EXPECT_NEAR(luminous_flux(coarse).value, sum, 1e-4 * sum);  // midpoint rule of 0.25 deg
    EXPECT_NEAR(downward_flux(coarse).value, down, 1e-4 * sum);
}

TEST(Intensity, a_last_plane_at_89_999_is_the_plane_at_90) {
    Photometry photometry =
        table(PhotometricType::C, PhotometricSymmetry::quadrant, steps(0, 90, 45), steps(0, 90, 30), uniform);
    photometry.horizontal_deg.back() = 89.999;
    EXPECT_EQ(intensity(photometry, {0, 1, 0}).value, 100.0);
    EXPECT_EQ(intensity(photometry, {0, -1, 0}).value, 100.0);
}

TEST(Intensity, the_peak_is_named_with_its_place) {
    Photometry photometry =
        table(PhotometricType::C, PhotometricSymmetry::quadrant, steps(0, 90, 45), steps(0, 90, 30), uniform);
    photometry.candela[4 + 2] = 250.0;
    EXPECT_EQ(peak_intensity(photometry).value, 250.0);
    EXPECT_EQ(peak_angles(photometry).horizontal_deg, 45.0);
    EXPECT_EQ(peak_angles(photometry).vertical_deg, 60.0);
}

TEST(Intensity, a_quarter_turn_carries_the_beam_of_plane_0_to_plane_90) {
    const auto towards_x = [](const Vec3& e) { return 100.0 + 50.0 * e.x; };
    Photometry photometry =
        table(PhotometricType::C, PhotometricSymmetry::none, steps(0, 315, 45), steps(0, 180, 15), towards_x);
    const double at_plane_0 = intensity(photometry, {1, 0, 0}).value;
    photometry.quarter_turns = 1;
    EXPECT_EQ(intensity(photometry, {0, 1, 0}).value, at_plane_0);
    photometry.quarter_turns = 2;
    EXPECT_EQ(intensity(photometry, {-1, 0, 0}).value, at_plane_0);
    photometry.quarter_turns = 3;
    EXPECT_EQ(intensity(photometry, {0, -1, 0}).value, at_plane_0);
}

TEST(Intensity, another_lamp_set_shines_in_proportion_to_its_flux) {
    Photometry photometry =
        table(PhotometricType::C, PhotometricSymmetry::rotational, {0.0}, steps(0, 180, 30), uniform);
    photometry.lamp_sets = {{1.0, "A", 1000.0, "", "", 10.0}, {-2.0, "B", 2500.0, "", "", 30.0}};
    photometry.lamp_lumens = 1000.0;
    const Photometry second = with_lamp_set(photometry, 1);
    EXPECT_EQ(intensity(second, {0, 0, -1}).value, 250.0);
    EXPECT_EQ(second.candela_per_figure, 2.5);
    EXPECT_EQ(second.input_watts, 30.0);
    EXPECT_EQ(second.lamps, 2);
    EXPECT_TRUE(second.absolute);
    EXPECT_EQ(with_lamp_set(second, 0).candela, photometry.candela);
}

}  // namespace
}  // namespace hanei
