#include "engine/edit/lumen_method.h"

#include "engine/edit/arrangements.h"
#include "engine/edit/intensity_of.h"
#include "engine/edit/lighted_box.h"
#include "engine/edit/luminaire_edits.h"
#include "engine/geometry/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace hanei {
namespace {

constexpr double pi = std::numbers::pi;

std::vector<Vec2> field_places(const Vec2& sides, int columns, int rows) {
    std::vector<Vec2> places;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            places.push_back({(column + 0.5) / columns * sides.x, (row + 0.5) / rows * sides.y});
    return places;
}

constexpr int even_spread = 16;  // places along each side that stand for all places

/// Rows and columns for at least `needed`, the spacing as square and the surplus as small as they can be.
std::array<int, 2> columns_and_rows(const Vec2& sides, int needed) {
    constexpr double weight_of_surplus = 2.0;
    std::array<int, 2> best{needed, 1};
    double least = std::numeric_limits<double>::infinity();
    for (int rows = 1; rows <= std::min(needed, most_in_a_row); ++rows) {
        const int columns = (needed + rows - 1) / rows;
        if (columns > most_in_a_row) continue;
        const double unsquare = std::abs(std::log(sides.x / columns * rows / sides.y));
        const double surplus = static_cast<double>(columns * rows) / needed - 1.0;
        const double cost = unsquare + weight_of_surplus * surplus;
        if (cost < least) {
            least = cost;
            best = {columns, rows};
        }
    }
    return best;
}

/// The luminaire upright at the height of its mounting.
Luminaire as_mounted(const Scene& scene, const Luminaire& luminaire, const MountingWish& mounting) {
    Scene one;
    one.room = scene.room;
    one.photometries = scene.photometries;
    one.luminaires = {luminaire};
    const ObjectId ids[] = {luminaire.id};
    return mounted(std::move(one), ids, mounting).luminaires.front();
}

std::string refusal_of(const Scene& scene, const LumenWish& wish) {
    if (!scene.room || scene.room->plan.size() < 3 || !(std::abs(signed_area(scene.room->plan)) > 0.0))
        return "There is no room to light: draw one first.";
    if (!std::isfinite(wish.target) || !(wish.target > 0.0)) return "The wanted illuminance must be above 0 lx.";
    const bool between = wish.working_plane >= 0.0 && wish.working_plane < scene.room->height;
    return between ? std::string() : std::string("The working plane must lie between the floor and the ceiling.");
}

}  // namespace

double utilization_factor(const Scene& scene, const Luminaire& luminaire, const LumenWish& wish) {
    if (!refusal_of(scene, wish).empty()) return 0.0;
    const LightedBox box(scene, as_mounted(scene, luminaire, wish.mounting), wish);
    if (!(box.flux() > 0.0)) return 0.0;
    const LightedBox::Light light = box.from(field_places(box.sides(), even_spread, even_spread));
    return (light.to_plane + light.reflected) / box.flux();
}

double spacing_criterion(const Scene& scene, const Luminaire& luminaire) {
    constexpr double most = 3.0, step = 0.01;
    const IntensityOf candela(scene, luminaire);
    const auto from = [&](double plane, double gamma) {
        const double sine = std::sin(gamma);
        return candela({sine * std::cos(plane), sine * std::sin(plane), -std::cos(gamma)});
    };
    double least = most;
    for (const double plane : {0.0, 0.5 * pi}) {
        const double below = from(plane, 0.0);
        double reached = 0.0;
        for (double ratio = step; ratio <= most; ratio += step) {
            const double gamma = std::atan(0.5 * ratio);
            const double midway = (from(plane, gamma) + from(plane + pi, gamma)) * std::pow(std::cos(gamma), 3.0);
            if (midway >= below) reached = ratio;
        }
        least = std::min(least, reached);
    }
    return least;
}

LumenAnswer lumen_method(const Scene& scene, const Luminaire& luminaire, const LumenWish& wish) {
    LumenAnswer answer;
    answer.refusal = refusal_of(scene, wish);
    if (!answer.refusal.empty()) return answer;
    const LightedBox box(scene, as_mounted(scene, luminaire, wish.mounting), wish);
    answer.height = box.height();
    if (!(answer.height > 0.0)) answer.refusal = "The luminaires would hang below the working plane: raise them.";
    if (!(box.flux() > 0.0)) answer.refusal = "The luminaire gives no light.";
    if (!answer.refusal.empty()) return answer;

    const double kept = scene.maintenance_factor * luminaire.dimming;
    const auto predict = [&](int columns, int rows) {
        const LightedBox::Light light = box.from(field_places(box.sides(), columns, rows));
        const double share = columns * rows * kept;
        answer.columns = columns;
        answer.rows = rows;
        answer.direct = share * light.direct_lux;
        answer.mean = answer.direct + share * light.reflected / box.area();
        answer.utilization = (light.to_plane + light.reflected) / box.flux();
    };
    predict(wish.columns.value_or(1), wish.rows.value_or(1));
    if (!(answer.mean > 0.0)) {
        answer.refusal = "None of the light reaches the working plane: take another luminaire, or other reflectances.";
        return answer;
    }
    if (!wish.columns || !wish.rows) {
        constexpr int most = 10000;
        const LightedBox::Light even = box.from(field_places(box.sides(), even_spread, even_spread));
        const double one = kept * (even.direct_lux + even.reflected / box.area());
        const double first = one > 0.0 ? wish.target / one : most;
        if (!(first < most)) {
            answer.refusal = "More than 10000 luminaires would be needed: take one of more light.";
            return answer;
        }
        int needed = std::max(1, static_cast<int>(std::ceil(first - 0.02 * first)));
        constexpr double enough = 0.99;
        for (int round = 0; round < 12; ++round) {
            const auto [columns, rows] = columns_and_rows(box.sides(), needed);
            predict(columns, rows);
            if (answer.mean >= enough * wish.target) break;
            needed = std::max(needed, columns * rows) + 1;
        }
    }
    answer.room_index = box.area() / (answer.height * (box.sides().x + box.sides().y));
    const Vec2 spacing{box.sides().x / answer.columns, box.sides().y / answer.rows};
    answer.spacing_to_height = std::max(spacing.x, spacing.y) / answer.height;
    answer.spacing_limit = spacing_criterion(scene, luminaire);
    if (const Photometry* photometry = photometry_of(scene, luminaire))
        answer.watts = answer.count() * std::max(0.0, photometry->input_watts);
    answer.watts_per_m2 = answer.watts / box.area();
    return answer;
}

}  // namespace hanei
