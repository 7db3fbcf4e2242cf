#include "engine/project/gltf_units.h"

#include <algorithm>
#include <fmt/format.h>

namespace hanei {
namespace {

struct Unit {
    std::string_view name;
    double metres;
};
/// In the order in which they are likely.
constexpr Unit units[] = {{"m", 1.0}, {"mm", 0.001}, {"cm", 0.01}, {"in", 0.0254}, {"ft", 0.3048}};

/// What furniture and rooms measure at most, m.
bool is_likely(double largest) { return largest >= 0.3 && largest <= 30.0; }

}  // namespace

std::optional<double> metres_of_unit(std::string_view name) {
    for (const Unit& unit : units)
        if (unit.name == name) return unit.metres;
    return std::nullopt;
}

std::string size_text(const Vec3& size) {
    const auto length = [](double metres) {
        return metres < 1000.0 ? fmt::format("{:.3g}", metres) : fmt::format("{:.0f}", metres);
    };
    return length(size.x) + " x " + length(size.y) + " x " + length(size.z) + " m";
}

std::string doubtful_size(const Vec3& size, double metres_per_unit) {
    constexpr double too_large = 100.0, too_small = 0.05;
    const double largest = std::max({size.x, size.y, size.z});
    if (largest <= too_large && largest >= too_small) return {};
    const std::string found = "the model measures " + size_text(size);
    for (const Unit& unit : units) {
        const double scale = unit.metres / metres_per_unit;
        if (unit.metres != metres_per_unit && is_likely(scale * largest))
            return fmt::format("{}; drawn in {} it is {}: choose that unit if it is right", found, unit.name,
                               size_text(scale * size));
    }
    for (const double scale : {1000.0, 100.0, 39.37007874})  // of a file scaled down once too often
        if (is_likely(scale * largest))
            return fmt::format("{}; scaled down once too often? A unit of {:.4g} m makes it {}", found,
                               scale * metres_per_unit, size_text(scale * size));
    return found + "; check the unit";
}

}  // namespace hanei
