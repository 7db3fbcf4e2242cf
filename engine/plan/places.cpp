#include "engine/plan/places.h"

#include "engine/base/tolerance.h"
#include "engine/scene/grid_spacing.h"
#include "engine/scene/placement.h"

#include <algorithm>

namespace hanei {

namespace {

void append_opening(const Luminaire& luminaire, std::vector<Vec3>& places) {
    const Placement placed = placement(luminaire);
    places.push_back(placed.position);
    if (const auto* line = std::get_if<LineOpening>(&luminaire.opening)) {
        places.insert(places.end(), {placed.point(line->from), placed.point(line->to)});
    } else if (const auto* flat = std::get_if<PolygonOpening>(&luminaire.opening)) {
        for (const Vec3& corner : flat->region.outline) places.push_back(placed.point(corner));
    } else if (const auto* solid = std::get_if<PolyhedronOpening>(&luminaire.opening)) {
        for (const Vec3& corner : solid->vertices) places.push_back(placed.point(corner));
    }
}

std::string counted(std::size_t count, const char* one, const char* many) {
    return count == 0 ? std::string() : std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace

std::vector<Receiver> few_calculation_points(const Scene& scene) {
    constexpr double few = 600.0;
    double count = static_cast<double>(scene.points.size());
    for (const CalculationGrid& grid : scene.grids)
        if (grid.spacing > 0.0) count += grid_points(grid);
    std::vector<Receiver> points;
    if (count > few) return points;
    for (const CalculationPoint& point : scene.points) points.push_back({point.position, point.normal, Vec3{0.0}});
    for (const CalculationGrid& grid : scene.grids) {
        const Vec3 area = glm::cross(grid.along, grid.across);
        if (!(grid.spacing > 0.0) || !(glm::length(area) > 0.0)) continue;
        const auto cells = [&](const Vec3& side) {
            return static_cast<int>(grid_cells(glm::length(side), grid.spacing));
        };
        const int columns = cells(grid.along), rows = cells(grid.across);
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                const Vec3 place =
                    grid.corner + grid.along * ((column + 0.5) / columns) + grid.across * ((row + 0.5) / rows);
                points.push_back({place, glm::normalize(area), Vec3{0.0}});
            }
        }
    }
    return points;
}

std::vector<Vec3> places_of(const Scene& scene, std::span<const Face> faces) {
    std::vector<Vec3> places;
    for (const Face& face : faces) {
        places.insert(places.end(), face.region.outline.begin(), face.region.outline.end());
    }
    for (const Luminaire& luminaire : scene.luminaires) append_opening(luminaire, places);
    for (const CalculationPoint& point : scene.points) places.push_back(point.position);
    for (const CalculationGrid& grid : scene.grids) {
        places.insert(places.end(), {grid.corner, grid.corner + grid.along, grid.corner + grid.across,
                                     grid.corner + grid.along + grid.across});
    }
    return places;
}

bool has_something_behind(const Face& face, std::span<const Vec3> places, double same_place) {
    const Vec3& origin = face.region.outline.front();
    return std::any_of(places.begin(), places.end(),
                       [&](const Vec3& place) { return glm::dot(place - origin, face.normal) < -same_place; });
}

std::vector<Face> sheets_in_the_way(const Scene& scene) {
    std::vector<Face> faces = faces_of(scene);
    const std::vector<Vec3> places = places_of(scene, faces);
    const double same_place = tolerance::same_place * bounds_of(scene).diameter();
    std::erase_if(faces, [&](const Face& face) {
        const bool of_room = scene.room && face.ref.object == scene.room->id;
        const bool free = std::any_of(scene.surfaces.begin(), scene.surfaces.end(),
                                      [&](const FreeSurface& surface) { return surface.id == face.ref.object; });
        return !(of_room || free) || !has_something_behind(face, places, same_place);
    });
    return faces;
}

std::string obstacles_of(const Scene& scene) {
    std::size_t walls = 0;
    std::size_t sheets = 0;
    for (const Face& face : sheets_in_the_way(scene))
        ++(scene.room && face.ref.object == scene.room->id ? walls : sheets);
    const auto openings = static_cast<std::size_t>(std::count_if(
        scene.luminaires.begin(), scene.luminaires.end(), [](const Luminaire& luminaire) { return luminaire.opaque; }));
    std::string text;
    for (const std::string& part :
         {counted(solids_of(scene).size(), "solid", "solids"), counted(sheets, "free surface", "free surfaces"),
          counted(walls, "room face", "room faces"), counted(openings, "opaque luminaire", "opaque luminaires")}) {
        if (part.empty()) continue;
        text += (text.empty() ? "" : ", ") + part;
    }
    return text;
}

}  // namespace hanei
