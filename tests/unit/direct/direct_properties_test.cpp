/// What must hold of light straight from a luminaire whatever the setting: RapidCheck draws the
/// settings and shrinks the one that fails.
#include "tests/unit/direct/scenes.h"

#include <array>
#include <cstdlib>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace hanei {
namespace {

using testing::luminaire_at;
using testing::panel;
using testing::pi;

/// The same settings in every run, unless RC_PARAMS asks for others.
[[maybe_unused]] const int seeded = setenv("RC_PARAMS", "seed=20 max_success=1000", 0);

double number(double low, double high) { return low + (high - low) * 1e-6 * *rc::gen::inRange(0, 1'000'001); }
Vec3 place(double reach) { return {number(-reach, reach), number(-reach, reach), number(-reach, reach)}; }

Mat3 rotation() {
    const double a = number(0, 2 * pi), b = number(0, pi), c = number(0, 2 * pi);
    const Mat3 z{{std::cos(a), std::sin(a), 0}, {-std::sin(a), std::cos(a), 0}, {0, 0, 1}};
    const Mat3 y{{std::cos(b), 0, -std::sin(b)}, {0, 1, 0}, {std::sin(b), 0, std::cos(b)}};
    const Mat3 x{{1, 0, 0}, {0, std::cos(c), std::sin(c)}, {0, -std::sin(c), std::cos(c)}};
    return z * y * x;
}

/// Where everything of a setting goes.
struct Move {
    Mat3 turn{1.0};
    double scale = 1.0;
    Vec3 shift{0.0};
    Vec3 operator()(const Vec3& point) const { return scale * (turn * point) + shift; }
};

constexpr std::array<std::array<int, 4>, 6> box_faces = {
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};

std::vector<Vec3> box_corners(const Vec3& middle, const Vec3& size, const Mat3& turn) {
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; ++k) {
        corners.push_back(middle + turn * (size * Vec3{k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5, k & 4 ? 0.5 : -0.5}));
    }
    return corners;
}

std::vector<std::vector<int>> faces_of_a_box() {
    std::vector<std::vector<int>> faces;
    for (const auto& face : box_faces) faces.emplace_back(face.begin(), face.end());
    return faces;
}

enum class Kind { point, tube, panel, box };

/// A luminaire of a size up to a metre about the origin, a receiver 1 to 3 m away that looks roughly at
/// it, and up to three boxes between them. All in scene coordinates.
struct Setting {
    Kind kind = Kind::panel;
    std::vector<Vec3> source;  ///< the point, the tube's ends, the panel's corners, the box's corners
    Receiver receiver;
    std::vector<std::vector<Vec3>> boxes;

    static Setting drawn(Kind kind) {
        Setting made;
        made.kind = kind;
        const Mat3 turn = rotation();
        if (kind == Kind::point) made.source = {place(0.3)};
        if (kind == Kind::tube)
            made.source = {turn * Vec3{number(-0.7, -0.1), 0, 0}, turn * Vec3{number(0.1, 0.7), 0, 0}};
        if (kind == Kind::panel) {
            const double x = number(0.1, 0.7), y = number(0.1, 0.7);
            for (const Vec2& c : {Vec2{-x, -y}, Vec2{x, -y}, Vec2{x, y}, Vec2{-x, y}})
                made.source.push_back(turn * Vec3{c, 0});
        }
        if (kind == Kind::box)
            made.source = box_corners(Vec3{0}, {number(0.1, 0.7), number(0.1, 0.7), number(0.1, 0.7)}, turn);
        // A receiver before the panel, askew.
        const Vec3 towards = turn * glm::normalize(Vec3{number(-1, 1), number(-1, 1), number(0.2, 1)});
        made.receiver.position = number(1, 3) * towards;
        made.receiver.normal = glm::normalize(0.3 * place(1.7) - towards);
        for (int k = *rc::gen::inRange(0, 4); k > 0; --k) {
            const Vec3 size{number(0.05, 0.4), number(0.05, 0.4), number(0.05, 0.4)};
            made.boxes.push_back(box_corners(0.5 * made.receiver.position + place(0.3), size, rotation()));
        }
        return made;
    }

    Setting moved(const Move& move) const {
        Setting there = *this;
        for (Vec3& point : there.source) point = move(point);
        for (std::vector<Vec3>& box : there.boxes) {
            for (Vec3& point : box) point = move(point);
        }
        there.receiver = {move(receiver.position), move.turn * receiver.normal, move.turn * receiver.inward};
        return there;
    }

    Luminaire luminaire(const Output& output) const {
        Opening opening = PointOpening{};
        if (kind == Kind::tube) opening = LineOpening{source[0], source[1]};
        if (kind == Kind::panel) opening = PolygonOpening{{source, {}}};
        if (kind == Kind::box) opening = PolyhedronOpening{source, faces_of_a_box(), {}};
        return luminaire_at(kind == Kind::point ? source[0] : Vec3{0}, opening, output);
    }

    OccluderSet occluders() const {
        std::vector<ConvexBody> bodies;
        for (const std::vector<Vec3>& box : boxes) bodies.push_back({box, faces_of_a_box(), 0});
        return OccluderSet(std::move(bodies));
    }

    double lux(double flux) const {
        const OccluderSet set = occluders();
        return Emitter(Scene{}, luminaire(LuminousFlux{flux})).illuminance(receiver, &set).value;
    }
};

Kind any_kind() { return *rc::gen::element(Kind::point, Kind::tube, Kind::panel, Kind::box); }

// 1000 lm a metre away and more give 300 lx at most. Shadow borders move with their corners, no more than
// ten times as far; 1e-12 of 300 lx is a thousand roundings.
constexpr double flux = 1000.0;
constexpr double same = 3e-10;  // lx

RC_GTEST_PROP(AnyLuminaire, turned_with_its_room_gives_the_same, ()) {
    const Setting here = Setting::drawn(any_kind());
    const Setting there = here.moved({rotation(), 1.0, Vec3{0}});
    RC_ASSERT(std::abs(there.lux(flux) - here.lux(flux)) <= same);
}

RC_GTEST_PROP(AnyLuminaire, carried_a_hundred_kilometres_gives_the_same, ()) {
    const Setting here = Setting::drawn(any_kind());
    const Setting there = here.moved({Mat3{1.0}, 1.0, place(1e5)});
    // Coordinates round to 1.5e-11 m there: of 0.05 m, the least width, 3e-10; ten times that of 300 lx.
    RC_ASSERT(std::abs(there.lux(flux) - here.lux(flux)) <= 1e-6);
}

RC_GTEST_PROP(AnyLuminaire, in_a_model_of_another_scale_gives_the_same, ()) {
    const Setting here = Setting::drawn(any_kind());
    const double scale = std::pow(10.0, number(-3, 3));
    const Setting there = here.moved({Mat3{1.0}, scale, Vec3{0}});
    RC_ASSERT(std::abs(there.lux(flux * scale * scale) - here.lux(flux)) <= same);
}

RC_GTEST_PROP(AnyLuminaire, gives_no_more_behind_boxes_and_never_less_than_nothing, ()) {
    const Setting here = Setting::drawn(any_kind());
    Setting free = here;
    free.boxes.clear();
    const double behind = here.lux(flux);
    RC_ASSERT(behind >= 0.0);
    RC_ASSERT(behind <= free.lux(flux) + same);
}

RC_GTEST_PROP(AnyLuminaire, touched_by_the_receiver_gives_a_number_not_below_zero, ()) {
    Setting here = Setting::drawn(any_kind());
    const Vec3& corner = *rc::gen::elementOf(here.source);
    const Vec3 other = *rc::gen::elementOf(here.source);
    here.receiver.position = corner + 0.25 * *rc::gen::inRange(0, 5) * (other - corner);
    if (*rc::gen::arbitrary<bool>())
        here.receiver.inward = glm::normalize(glm::cross(here.receiver.normal, place(1)) + Vec3{1e-9});
    const double lux = here.lux(flux);
    RC_ASSERT(std::isfinite(lux));
    RC_ASSERT(lux >= 0.0);
}

RC_GTEST_PROP(AnyPanel, begins_its_outline_at_any_corner, ()) {
    const Setting here = Setting::drawn(Kind::panel);
    Setting other = here;
    std::rotate(other.source.begin(), other.source.begin() + *rc::gen::inRange(1, 4), other.source.end());
    RC_ASSERT(std::abs(other.lux(flux) - here.lux(flux)) <= same);
}

RC_GTEST_PROP(AnyPanel, cut_in_two_gives_as_much_as_both_halves, ()) {
    const Setting whole = Setting::drawn(Kind::panel);
    const double share = number(0.001, 0.999), slant = number(-0.5, 0.5) * std::min(share, 1 - share);
    const Vec3 low = glm::mix(whole.source[0], whole.source[1], share + slant);
    const Vec3 high = glm::mix(whole.source[3], whole.source[2], share - slant);
    Setting left = whole, right = whole;
    left.source = {whole.source[0], low, high, whole.source[3]};
    right.source = {low, whole.source[1], whole.source[2], high};
    const double parts = left.lux(share * flux) + right.lux((1 - share) * flux);
    RC_ASSERT(std::abs(parts - whole.lux(flux)) <= same);
}

RC_GTEST_PROP(AnyTube, cut_in_two_gives_as_much_as_both_pieces, ()) {
    const Setting whole = Setting::drawn(Kind::tube);
    const double share = number(0.001, 0.999);
    Setting left = whole, right = whole;
    left.source[1] = right.source[0] = glm::mix(whole.source[0], whole.source[1], share);
    const double parts = left.lux(share * flux) + right.lux((1 - share) * flux);
    RC_ASSERT(std::abs(parts - whole.lux(flux)) <= same);
}

RC_GTEST_PROP(AnyLuminousBox, gives_as_much_as_six_panels, ()) {
    const Setting box = Setting::drawn(Kind::box);
    const OccluderSet set = box.occluders();
    const auto lux = [&](const Luminaire& luminaire) {
        return Emitter(Scene{}, luminaire).illuminance(box.receiver, &set).value;
    };
    double faces = 0.0;
    for (const auto& face : box_faces) {
        Polygon outline;
        for (const int corner : face) outline.push_back(box.source[static_cast<std::size_t>(corner)]);
        faces += lux(luminaire_at(Vec3{0}, PolygonOpening{{outline, {}}}, Luminance{300}));
    }
    RC_ASSERT(std::abs(faces - lux(box.luminaire(Luminance{300}))) <= same);
}

/// The mean form factor from one parallelogram to another, by 12 x 12 Gauss points.
double mean_factor(const Polygon& from, const Polygon& to) {
    constexpr std::array<std::array<double, 2>, 6> rule = {{{0.12523340851146892, 0.24914704581340277},
                                                            {0.36783149899818018, 0.23349253653835481},
                                                            {0.58731795428661748, 0.20316742672306592},
                                                            {0.76990267419430469, 0.16007832854334622},
                                                            {0.90411725637047480, 0.10693932599531843},
                                                            {0.98156063424671924, 0.04717533638651183}}};
    const Vec3 along = 0.5 * (from[1] - from[0]), across = 0.5 * (from[3] - from[0]);
    const Vec3 middle = from[0] + along + across, normal = glm::normalize(glm::cross(along, across));
    double sum = 0.0;
    for (const auto& [u, weight_u] : rule) {
        for (const auto& [v, weight_v] : rule) {
            for (const Vec2& sign : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}}) {
                const Vec3 at = middle + sign.x * u * along + sign.y * v * across;
                sum += 0.25 * weight_u * weight_v * configuration_factor(to, {at, normal, Vec3{0}});
            }
        }
    }
    return sum;
}

RC_GTEST_PROP(AnyTwoRectangles, send_each_other_the_same_share_of_their_areas, ()) {
    const auto rectangle = [](const Vec3& middle, const Mat3& turn, double width, double depth) {
        Polygon made;
        for (const Vec2& c : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}}) {
            made.push_back(middle + turn * Vec3{0.5 * width * c.x, 0.5 * depth * c.y, 0});
        }
        return made;
    };
    const double a = number(0.1, 1), b = number(0.1, 1), c = number(0.1, 1), d = number(0.1, 1);
    const double lean = number(-0.5, 0.5);  // neither cuts the other's horizon
    const Mat3 upright{1.0},
        leaning{{-std::cos(lean), 0, std::sin(lean)}, {0, 1, 0}, {-std::sin(lean), 0, -std::cos(lean)}};
    const Mat3 turn = rotation();
    const Polygon one = rectangle(Vec3{0}, turn * upright, a, b);
    const Polygon two = rectangle(turn * Vec3{number(-1, 1), number(-1, 1), number(2, 4)}, turn * leaning, c, d);
    const double there = a * b * mean_factor(one, two), back = c * d * mean_factor(two, one);
    RC_ASSERT(there > 0.0);
    RC_ASSERT(std::abs(back / there - 1.0) <= 1e-12);  // 12 points: (size / distance / 4)^24
}

RC_GTEST_PROP(AnyWall, fills_half_the_view_of_its_foot_and_a_corners_share_of_its_end, ()) {
    const double width = number(0.5, 5), height = number(0.5, 3), angle = number(0.01, pi - 0.01);
    const Mat3 turn = rotation();
    const Vec3 shift = place(10);
    const auto factor = [&](const Vec3& at, const Vec3& inward) {
        Polygon wall = {{0, 0, 0}, {width, 0, 0}, {width, 0, height}, {0, 0, height}};  // faces -y
        for (Vec3& corner : wall) corner = turn * corner + shift;
        return configuration_factor(wall, {turn * at + shift, turn[2], turn * inward});
    };
    const Vec3 inward{std::cos(angle), -std::sin(angle), 0};
    // 1e-15 m of rounding in a room 10 m from the origin, 0.5 m from the wall's end
    RC_ASSERT(std::abs(factor({number(0.1, 0.9) * width, 0, 0}, inward) - 0.5) <= 1e-12);
    RC_ASSERT(std::abs(factor({0, 0, 0}, inward) - 0.5 * (1 - angle / pi)) <= 1e-12);
    RC_ASSERT(factor({0.3 * width, 0, 0}, -inward) == 0.0);
}

}  // namespace
}  // namespace hanei
