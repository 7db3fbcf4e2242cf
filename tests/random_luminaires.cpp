#include "tests/random_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei::test {
namespace {

/// A table of one plane or of four, dark or bright to the horizon and beyond.
Photometry random_photometry(Scene& scene, Dice& dice) {
    Photometry photometry;
    photometry.id = scene.new_id();
    photometry.name = "table " + std::to_string(photometry.id.value);
    const bool round = dice.chance(0.5);
    photometry.symmetry = round ? PhotometricSymmetry::rotational : PhotometricSymmetry::quadrant;
    photometry.horizontal_deg = round ? std::vector<double>{0.0} : std::vector<double>{0.0, 45.0, 90.0};
    const double end = dice.pick({90.0, 180.0});
    for (int k = 0; k <= 6; ++k) photometry.vertical_deg.push_back(end * k / 6.0);
    const bool jagged = dice.chance(0.15);  // else a beam, wide or narrow, a little different in each plane
    const double power = dice.in(0.5, 4.0), peak = dice.in(10.0, 1000.0);
    for (std::size_t plane = 0; plane < photometry.horizontal_deg.size(); ++plane)
        for (const double vertical : photometry.vertical_deg) {
            const double beam = std::pow(std::max(0.0, std::cos(0.5 * std::numbers::pi * vertical / end)), power);
            const double share = plane == 0 || vertical == 0.0 ? 1.0 : dice.in(0.8, 1.0);
            photometry.candela.push_back(jagged ? dice.in(0.0, 800.0) : peak * share * beam);
        }
    photometry.opening.shape =
        dice.pick({OpeningShape::point, OpeningShape::rectangle, OpeningShape::circle, OpeningShape::box,
                   OpeningShape::vertical_cylinder, OpeningShape::sphere, OpeningShape::horizontal_cylinder});
    if (photometry.opening.shape != OpeningShape::point) {
        photometry.opening.extent_0 = dice.in(0.05, 1.2);
        photometry.opening.extent_90 = dice.in(0.05, 0.6);
        photometry.opening.height = dice.in(0.02, 0.2);
        if (photometry.opening.shape == OpeningShape::rectangle || photometry.opening.shape == OpeningShape::circle)
            photometry.opening.height = 0.0;
        if (photometry.opening.shape == OpeningShape::circle || photometry.opening.shape == OpeningShape::sphere)
            photometry.opening.extent_90 = photometry.opening.extent_0;
        if (photometry.opening.shape == OpeningShape::sphere) photometry.opening.height = photometry.opening.extent_0;
    }
    photometry.absolute = true;
    scene.photometries.push_back(photometry);
    return photometry;
}

/// Shines down (-z).
Region opening_outline(Dice& dice) {
    const double x = dice.in(0.05, 0.8), y = dice.chance(0.1) ? 1e-6 * x : dice.in(0.05, 0.6);
    const Polygon rectangle{{-x, -y, 0.0}, {-x, y, 0.0}, {x, y, 0.0}, {x, -y, 0.0}};
    switch (dice.below(4)) {
        case 0:
            return {{{-x, -y, 0.0}, {0.0, y, 0.0}, {x, -y, 0.0}}, {}};
        case 1: {
            const Polygon hole{
                {-0.5 * x, -0.5 * y, 0.0}, {0.5 * x, -0.5 * y, 0.0}, {0.5 * x, 0.5 * y, 0.0}, {-0.5 * x, 0.5 * y, 0.0}};
            return {rectangle, {hole}};
        }
        default:
            return {rectangle, {}};
    }
}

PolyhedronOpening shining_box(Dice& dice) {
    const double x = dice.in(0.02, 0.6), y = dice.in(0.02, 0.3), z = dice.in(0.01, 0.2);
    PolyhedronOpening solid;
    for (const double h : {-z, z})
        for (const Vec2 corner : {Vec2{-x, -y}, Vec2{x, -y}, Vec2{x, y}, Vec2{-x, y}})
            solid.vertices.emplace_back(corner, h);
    solid.faces = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    if (dice.chance(0.4)) solid.relative_luminance = {1.0, 0.0, 0.5, 0.5, 0.5, 0.2};
    return solid;
}

void choose_light(Scene& scene, Luminaire& luminaire, Dice& dice) {
    luminaire.output = LuminousFlux{dice.chance(0.1) ? 0.0 : dice.logarithmic(1.0, 2e4)};
    const auto measured = [&](Opening opening) {
        luminaire.opening = std::move(opening);
        luminaire.distribution = Measured{random_photometry(scene, dice).id};
        if (dice.chance(0.5)) luminaire.output = AsMeasured{};
    };
    switch (dice.below(9)) {
        case 0:
            return;
        case 1:
            luminaire.distribution = CosinePower{dice.in(0.0, 20.0)};
            return;
        case 2:
            luminaire.opening = LineOpening{{-0.6, 0.0, 0.0}, {0.6, 0.0, 0.0}};
            return;
        case 3:
            luminaire.opening = shining_box(dice);
            break;
        case 4:
            return measured(PointOpening{});
        case 5:
            return measured(MeasuredOpening{});
        case 6:
            return measured(PolygonOpening{opening_outline(dice)});
        default:
            luminaire.opening = PolygonOpening{opening_outline(dice)};
            break;
    }
    if (dice.chance(0.3)) luminaire.output = Luminance{dice.logarithmic(10.0, 1e5)};
}

void choose_place(const Scene& scene, Luminaire& luminaire, Dice& dice, const Vec3& size) {
    luminaire.position = dice.in_box(0.2 * size, 0.8 * size);
    const double below = size.z - luminaire.position.z;
    switch (dice.below(8)) {
        case 0:
            luminaire.position.z += below;
            break;  // in the ceiling
        case 1:
            luminaire.position.z += below + dice.logarithmic(1e-9, 0.3);
            break;  // above it
        case 2:
            luminaire.position.z += below - 1e-9;
            break;  // as good as in it
        case 3:
            if (!scene.furniture.empty()) luminaire.position = scene.furniture.front().position + Vec3{0.0, 0.0, 0.1};
            break;  // inside furniture
        default:
            break;
    }
    luminaire.yaw = dice.chance(0.3) ? dice.in(0.0, 6.0) : 0.0;
    luminaire.tilt = dice.chance(0.25) ? dice.in(-3.0, 3.0) : 0.0;
    luminaire.roll = dice.chance(0.1) ? dice.in(-3.0, 3.0) : 0.0;
    if (dice.chance(0.1)) luminaire.tilt = 0.5 * std::numbers::pi;  // shines along the horizon
    luminaire.dimming = dice.chance(0.2) ? dice.in(0.0, 1.0) : 1.0;
    luminaire.opaque = dice.chance(0.2);
}

}  // namespace

void add_random_luminaires(Scene& scene, Dice& dice, const Vec3& size) {
    for (int k = dice.below(5); k > 0; --k) {
        Luminaire luminaire;
        luminaire.id = scene.new_id();
        luminaire.name = "luminaire " + std::to_string(luminaire.id.value);
        choose_light(scene, luminaire, dice);
        choose_place(scene, luminaire, dice, size);
        scene.luminaires.push_back(luminaire);
    }
}

}  // namespace hanei::test
