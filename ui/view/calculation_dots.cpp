#include "ui/view/colour_scale.h"
#include "ui/view/drawn_about.h"
#include "ui/view/marks.h"

#include <algorithm>
#include <optional>

namespace hanei {
namespace {

constexpr glm::vec4 ring{0.08F, 0.09F, 0.10F, 0.5F};
constexpr float grid_radius = 3.2F, point_radius = 5.5F;  // pixels
constexpr double share_of_spacing = 0.11;                 // dots of a grid never touch

std::optional<double> value_of(const PointValue& value, LightPart part) {
    switch (part) {
        case LightPart::total:
            return value.total().value;
        case LightPart::direct:
            return value.direct.value;
        case LightPart::interreflected:
            return value.interreflected.value;
        case LightPart::unshadowed:
            break;
    }
    return std::nullopt;
}

void append(std::vector<DotMark>& dots, const PointResult& point, bool valued, const ViewOptions& look, float radius,
            double greatest_m) {
    if (point.value.inside_solid) return;
    const std::optional<double> lux = valued ? value_of(point.value, look.part) : std::nullopt;
    const glm::vec4 fill = lux ? glm::vec4(colour_of(*lux, look), 1.0F) : ink::no_value;
    dots.push_back(
        {drawn(point.position), fill, ring, radius, static_cast<float>(greatest_m), glm::vec3(point.normal)});
}

double spacing_of(const CalculationGrid& grid) {
    const GridResult layout = layout_of(grid);
    return std::min(glm::length(grid.along) / std::max(1, layout.columns),
                    glm::length(grid.across) / std::max(1, layout.rows));
}

}  // namespace

std::vector<DotMark> calculation_dots(const Scene& scene, const Solution* solution, const ViewOptions& look) {
    std::vector<DotMark> dots;
    const bool valued = solution != nullptr;
    for (const CalculationGrid& grid : scene.grids) {
        GridResult shown = layout_of(grid);
        if (valued) {
            for (const GridResult& result : solution->grids) {
                if (result.grid == grid.id) shown = result;
            }
        }
        const double greatest = share_of_spacing * spacing_of(grid);
        for (const PointResult& point : shown.points) append(dots, point, valued, look, grid_radius, greatest);
    }
    for (const CalculationPoint& authored : scene.points) {
        PointResult shown;
        shown.position = authored.position;
        shown.normal = authored.normal;
        bool has_value = false;
        if (valued) {
            for (const PointResult& result : solution->points) {
                if (result.point != authored.id) continue;
                shown = result;
                has_value = true;
            }
        }
        append(dots, shown, has_value, look, point_radius, 0.0);
    }
    return dots;
}

}  // namespace hanei
