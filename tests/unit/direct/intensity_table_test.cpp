#include "engine/direct/intensity_table.h"

#include "engine/scene/intensity.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

/// A table of figures without any pattern, planes first to last by the step.
Photometry table(PhotometricSymmetry symmetry, double first, double last, double step,
                 PhotometricType type = PhotometricType::C) {
    Photometry photometry;
    photometry.type = type;
    photometry.symmetry = symmetry;
    for (double plane = first; plane <= last + 1e-9; plane += step) photometry.horizontal_deg.push_back(plane);
    const double lowest = type == PhotometricType::C ? 0.0 : -90.0;
    for (const double part : {0.0, 0.004, 0.01, 0.3, 0.35, 0.42, 0.8, 1.0}) {
        photometry.vertical_deg.push_back(lowest + 120.0 * part);  // uneven on purpose
    }
    const std::size_t figures = photometry.horizontal_deg.size() * photometry.vertical_deg.size();
    for (std::size_t k = 0; k < figures; ++k) photometry.candela.push_back(static_cast<double>(k * 7919 % 1009));
    return photometry;
}

void expect_same(const Photometry& photometry) {
    const IntensityTable prepared(photometry);
    for (int k = 0; k < 20'000; ++k) {  // a spiral over the sphere
        const double z = 1.0 - (2.0 * k + 1.0) / 20'000;
        const double turn = 2.399963 * k, level = std::sqrt(1.0 - z * z);
        const Vec3 direction{level * std::cos(turn), level * std::sin(turn), z};
        const double expected = intensity(photometry, direction).value;
        // rounding of an angle, 1e-13 degrees, times a flank of 1000 cd in 0.5 degrees
        EXPECT_NEAR(prepared.candela(direction), expected, 1e-9) << k;
    }
}

TEST(IntensityTable, holds_the_figures_of_every_symmetry) {
    expect_same(table(PhotometricSymmetry::none, 0, 345, 15));
    expect_same(table(PhotometricSymmetry::none, 0, 360, 22.5));
    expect_same(table(PhotometricSymmetry::none, 30, 330, 50));
    expect_same(table(PhotometricSymmetry::none, 0, 0, 15));
    expect_same(table(PhotometricSymmetry::rotational, 0, 0, 15));
    expect_same(table(PhotometricSymmetry::quadrant, 0, 90, 15));
    expect_same(table(PhotometricSymmetry::quadrant, 0, 89.999, 89.999 / 4));
    expect_same(table(PhotometricSymmetry::plane_0, 0, 180, 15));
    expect_same(table(PhotometricSymmetry::plane_90, 90, 270, 15));
    expect_same(table(PhotometricSymmetry::plane_90, -90, 90, 15));
}

TEST(IntensityTable, leaves_other_frames_and_ranges_to_the_search) {
    expect_same(table(PhotometricSymmetry::none, -90, 90, 15, PhotometricType::A));
    expect_same(table(PhotometricSymmetry::plane_0, 0, 90, 15, PhotometricType::B));
    expect_same(table(PhotometricSymmetry::quadrant, 0, 105, 15));
}

TEST(IntensityTable, is_dark_beyond_its_last_angle_and_not_on_it) {
    Photometry down = table(PhotometricSymmetry::rotational, 0, 0, 15);
    down.vertical_deg = {0, 90};
    down.candela = {100, 100};
    const IntensityTable prepared(down);
    EXPECT_EQ(prepared.candela({0, 0, -1}), 100.0);
    EXPECT_EQ(prepared.candela({1, 0, 0}), 100.0);
    EXPECT_EQ(prepared.candela(glm::normalize(Vec3{1, 0, 1e-6})), 0.0);
}

}  // namespace
}  // namespace hanei
