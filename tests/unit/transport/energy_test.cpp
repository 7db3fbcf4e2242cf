#include "engine/transport/energy.h"

#include "engine/transport/ambient.h"
#include "tests/unit/transport/balanced_room.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace hanei {
namespace {

struct Accounted {
    FluxAccount flux;
    double ambient = 0.0, mean_interreflected = 0.0;
};

Accounted account(const BalancedRoom& room) {
    const LightSide side{room.reflectance, room.direct, room.own};
    const Balance found = balance(room.exchange(), room.size(), {&side, 1}, {1000, 1e-10}, {2})->front();
    EXPECT_TRUE(found.converged);
    std::vector<double> areas, row_sums(room.size());
    for (const Patch& patch : room.mesh->patches) areas.push_back(patch.area);
    EXPECT_TRUE(room.exchange()(std::vector<double>(room.size(), 1.0), row_sums, 1));
    Accounted result;
    result.flux = account_of({areas, room.reflectance, room.own, room.direct, found.interreflected, row_sums});
    result.ambient = ambient_illuminance(areas, room.reflectance, room.own, room.direct);
    double area = 0.0;
    for (const double each : areas) area += each;
    result.mean_interreflected = result.flux.received / area;
    return result;
}

void expect_all_counted(const FluxAccount& flux) {
    const double in = flux.own + flux.direct;
    EXPECT_NEAR(flux.absorbed + flux.escaped + flux.imbalance(), in, 1e-11 * in);  // sums of a thousand patches
}

/// Floor and walls of a room 4 x 3 x 2.5 m, open above.
Scene open_above(double reflectance) {
    constexpr double x = 4.0, y = 3.0, z = 2.5;
    Scene scene;
    sample::add_surface(scene, {{0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}}, reflectance);
    sample::add_surface(scene, {{0, 0, 0}, {0, 0, z}, {x, 0, z}, {x, 0, 0}}, reflectance);
    sample::add_surface(scene, {{x, 0, 0}, {x, 0, z}, {x, y, z}, {x, y, 0}}, reflectance);
    sample::add_surface(scene, {{x, y, 0}, {x, y, z}, {0, y, z}, {0, y, 0}}, reflectance);
    sample::add_surface(scene, {{0, y, 0}, {0, y, z}, {0, 0, z}, {0, 0, 0}}, reflectance);
    return scene;
}

TEST(Energy, nothing_escapes_from_a_closed_room_and_all_is_counted) {
    for (const double reflectance : {0.0, 0.3, 0.8, 0.97}) {
        const FluxAccount flux = account(BalancedRoom(sample::computer_room(reflectance))).flux;
        expect_all_counted(flux);
        EXPECT_LE(flux.escaped, 1e-6 * (flux.sent + flux.escaped));  // row sums 1 within 1e-6
    }
}

TEST(Energy, a_furnace_is_in_balance_with_itself) {
    BalancedRoom room(sample::computer_room(0.5));
    std::fill(room.reflectance.begin(), room.reflectance.end(), 0.5);
    std::fill(room.direct.begin(), room.direct.end(), 0.0);
    std::fill(room.own.begin(), room.own.end(), 10.0);
    const Accounted found = account(room);
    expect_all_counted(found.flux);
    EXPECT_NEAR(found.flux.imbalance(), 0.0, 1e-6 * found.flux.own);
    EXPECT_NEAR(found.ambient, 20.0, 1e-9);
    EXPECT_NEAR(found.mean_interreflected, 20.0, 1e-4);
}

TEST(Energy, what_escapes_from_a_floor_is_the_form_factor_of_the_opening) {
    double before = 1e300;
    for (const double width : {1.0, 0.5, 0.25}) {
        BalancedRoom room(open_above(0.0), width);
        for (std::size_t k = 0; k < room.size(); ++k) {
            room.own[k] = room.mesh->patches[k].centre.z < 0.01 ? 100.0 : 0.0;
            room.direct[k] = 0.0;
        }
        const FluxAccount flux = account(room).flux;
        expect_all_counted(flux);
        // aligned rectangles 4 m x 3 m at 2.5 m: closed form, tested with the form factors
        const Region floor{{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}}, {}};
        const Region opening{{{0, 0, 2.5}, {0, 3, 2.5}, {4, 3, 2.5}, {4, 0, 2.5}}, {}};
        const double expected = 100.0 * 12.0 * form_factor(floor, opening, {});
        const double error = std::abs(flux.escaped - expected) / expected;
        EXPECT_LT(error, 0.02 * width * width);  // one place a patch: the square of its width
        EXPECT_LT(error, before);
        before = error;
    }
}

TEST(Energy, walls_and_floor_of_one_exitance_send_as_much_through_the_opening_as_it_is_large) {
    BalancedRoom room(open_above(0.0), 0.25);
    std::fill(room.own.begin(), room.own.end(), 100.0);
    std::fill(room.direct.begin(), room.direct.end(), 0.0);
    const FluxAccount flux = account(room).flux;
    expect_all_counted(flux);
    EXPECT_NEAR(flux.escaped, 100.0 * 12.0, 0.005 * 1200.0);  // seen from outside the opening is 100 lm/m2
}

TEST(Energy, an_open_room_loses_less_the_more_its_surfaces_absorb) {
    double before = 1e300;
    for (const double reflectance : {0.9, 0.6, 0.3}) {
        const FluxAccount flux = account(BalancedRoom(open_above(reflectance), 0.4)).flux;
        expect_all_counted(flux);
        EXPECT_GT(flux.escaped, 0.0);
        EXPECT_LT(flux.escaped / flux.direct, before);
        before = flux.escaped / flux.direct;
    }
}

TEST(Energy, the_imbalance_falls_with_the_patch_width) {
    for (const double high : {0.5, 0.8}) {
        double before = 1e300;
        for (const double width : {1.0, 0.5, 0.25}) {
            BalancedRoom room(sample::box_room(4.0, 3.0, 2.5, 0.5), width);
            for (std::size_t k = 0; k < room.size(); ++k) {
                const double height = room.mesh->patches[k].centre.z;
                room.reflectance[k] = height > 2.49 ? high : height < 0.01 ? 0.2 : 0.5;
            }
            const FluxAccount flux = account(room).flux;
            expect_all_counted(flux);
            const double share = std::abs(flux.imbalance()) / flux.direct;
            EXPECT_LT(share, 0.7 * before);
            before = share;
        }
        EXPECT_LT(before, 0.01);
    }
}

TEST(Energy, a_row_sum_above_1_is_light_that_was_sent) {
    const std::vector<double> area{2.0}, reflectance{0.5}, own{0.0}, direct{100.0}, arriving{70.0}, sums{1.2};
    const FluxAccount flux = account_of({area, reflectance, own, direct, arriving, sums});
    expect_all_counted(flux);
    EXPECT_EQ(flux.escaped, 0.0);
    EXPECT_NEAR(flux.sent, 170.0, 1e-12);
}

TEST(Ambient, is_near_the_mean_of_interreflected_light_in_a_furnished_room) {
    for (const double reflectance : {0.3, 0.6, 0.9}) {
        const Accounted found = account(BalancedRoom(sample::computer_room(reflectance)));
        EXPECT_NEAR(found.ambient, found.mean_interreflected, 0.25 * found.mean_interreflected);
    }
}

TEST(Ambient, is_none_without_area_and_where_nothing_is_absorbed) {
    EXPECT_EQ(ambient_illuminance({}, {}, {}, {}), 0.0);
    const std::vector<double> area{2.0}, white{1.0}, none{0.0}, direct{100.0};
    EXPECT_EQ(ambient_illuminance(area, white, none, direct), 0.0);
    EXPECT_EQ(ambient_illuminance(area, none, none, direct), 0.0);
}

}  // namespace
}  // namespace hanei
