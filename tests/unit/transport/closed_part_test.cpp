#include "engine/transport/closed_part.h"

#include "tests/unit/transport/balanced_room.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

std::vector<double> emitted_in(const BalancedRoom& room) {
    std::vector<double> emitted;
    for (std::size_t k = 0; k < room.size(); ++k) emitted.push_back(room.own[k] + room.reflectance[k] * room.direct[k]);
    return emitted;
}

std::vector<std::size_t> closed_in(const BalancedRoom& room) {
    return *closed_unknowns(room.exchange(), room.reflectance, emitted_in(room), {2});
}

TEST(ClosedPart, is_the_whole_of_a_closed_room_that_reflects_everything) {
    EXPECT_EQ(closed_in(BalancedRoom(sample::box_room(4.0, 3.0, 2.5, 1.0))).size(),
              BalancedRoom(sample::box_room(4.0, 3.0, 2.5, 1.0)).size());
    BalancedRoom furnished(sample::computer_room(1.0));
    std::fill(furnished.reflectance.begin(), furnished.reflectance.end(), 1.0);
    EXPECT_EQ(closed_in(furnished).size(), furnished.size());
}

TEST(ClosedPart, is_nothing_where_a_single_patch_absorbs_somewhere_behind_a_corner) {
    BalancedRoom room(sample::l_room(1.0), 0.5);
    ASSERT_EQ(closed_in(room).size(), room.size());
    for (std::size_t k = 0; k < room.size(); ++k) {
        if (room.mesh->patches[k].centre.x < 3.9) continue;  // the far end of one corridor
        room.reflectance[k] = 0.9;
        break;
    }
    EXPECT_TRUE(closed_in(room).empty());
}

TEST(ClosedPart, is_nothing_below_reflectance_1_or_where_the_room_is_open) {
    EXPECT_TRUE(closed_in(BalancedRoom(sample::box_room(4.0, 3.0, 2.5, 0.99))).empty());
    Scene open;
    sample::add_surface(open, {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, 1.0);
    sample::add_surface(open, {{0, 0, 1}, {0, 2, 1}, {2, 2, 1}, {2, 0, 1}}, 1.0);
    EXPECT_TRUE(closed_in(BalancedRoom(open)).empty());
}

/// Two closed rooms that do not see each other: one within the other's rows would be no neighbour.
struct TwoRooms {
    BalancedRoom one{sample::box_room(4.0, 3.0, 2.5, 1.0)};
    std::size_t size() const { return 2 * one.size(); }
    Exchange exchange() const {
        return [this](std::span<const double> leaving, std::span<double> arriving, std::size_t sides) {
            const std::size_t half = one.size() * sides;
            const Exchange each = one.exchange();
            return each(leaving.first(half), arriving.first(half), sides) &&
                   each(leaving.subspan(half), arriving.subspan(half), sides);
        };
    }
};

TEST(ClosedPart, leaves_out_rooms_without_light_and_rooms_that_absorb) {
    const TwoRooms both;
    std::vector<double> reflectance(both.size(), 1.0), emitted(both.size(), 0.0);
    emitted[3] = 10.0;
    const auto lit = *closed_unknowns(both.exchange(), reflectance, emitted, {});
    ASSERT_EQ(lit.size(), both.one.size());
    EXPECT_EQ(lit.back(), both.one.size() - 1);
    reflectance[5] = 0.5;
    EXPECT_TRUE(closed_unknowns(both.exchange(), reflectance, emitted, {})->empty());
    emitted.back() = 10.0;
    EXPECT_EQ(closed_unknowns(both.exchange(), reflectance, emitted, {})->front(), both.one.size());
    EXPECT_TRUE(closed_unknowns(both.exchange(), reflectance, std::vector<double>(both.size(), 0.0), {})->empty());
}

TEST(ClosedPart, a_room_whose_rows_were_kept_in_few_bits_is_closed_within_their_error) {
    BalancedRoom room(sample::box_room(4.0, 3.0, 2.5, 1.0));
    for (float& factor : room.factors.values) factor *= 1.0F - 0.0005F;
    EXPECT_TRUE(closed_in(room).empty());
    EXPECT_EQ(closed_unknowns(room.exchange(), room.reflectance, emitted_in(room), {}, 1e-3)->size(), room.size());
}

TEST(ClosedPart, a_stopped_search_returns_nothing) {
    const BalancedRoom room(sample::box_room(4.0, 3.0, 2.5, 1.0));
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(closed_unknowns(room.exchange(), room.reflectance, emitted_in(room), {1, stop.get_token(), nullptr}));
}

}  // namespace
}  // namespace hanei
