#include "engine/plan/ceiling_cells.h"

#include "engine/base/tolerance.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/colour.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace hanei {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rectangles_aimed_at = 150.0;  // of all faces that are no furniture
constexpr std::size_t most_faces = 700;        // of a scene whose furniture is taken face by face
constexpr double rounding = 1e-9;              // of a form factor

void measure(CeilingCell& cell) {
    cell.low = cell.high = cell.corners.front();
    for (const Vec3& corner : cell.corners) {
        cell.low = glm::min(cell.low, corner);
        cell.high = glm::max(cell.high, corner);
    }
    cell.centre = 0.5 * (cell.low + cell.high);
    for (const Vec3& corner : cell.corners) cell.radius = std::max(cell.radius, glm::distance(cell.centre, corner));
}

double distance(const Vec3& place, const CeilingCell& cell) {
    return glm::length(glm::max(Vec3{0.0}, glm::max(cell.low - place, place - cell.high)));
}

/// How far anything of `other` rises over the plane of a flat cell.
double height_over(const CeilingCell& flat, const CeilingCell& other) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const Vec3& corner : other.corners)
        highest = std::max(highest, glm::dot(corner - flat.corners.front(), flat.normal));
    return highest;
}

/// The greatest of the materials that cover something.
void take_material(CeilingCell& cell, const Scene& scene, ObjectId id) {
    const Material* const material = find_material(scene, id);
    if (!material) return;
    const auto bands = band_reflectances(*material);
    const double mean = luminance({bands[0], bands[1], bands[2]});
    for (int band = 0; band < colour_bands; ++band) {
        const double reflectance = bands[static_cast<std::size_t>(band)];
        cell.reflectance[band] = std::max(cell.reflectance[band], reflectance);
        cell.apart[band] = std::max(cell.apart[band], std::abs(reflectance - mean));
    }
    cell.photometric = std::max(cell.photometric, mean);
}

void take_face(CeilingCell& cell, const Scene& scene, const Face& face) {
    take_material(cell, scene, face.material);
    for (const FaceArea& area : face.areas) take_material(cell, scene, area.material);
    cell.own_exitance = std::max(cell.own_exitance, face.own_exitance.value);
}

/// The face's bounding rectangle cut into about squares of this width.
void append_rectangles(const Scene& scene, const Face& face, double width, std::vector<CeilingCell>& cells) {
    const Vec3 across = glm::cross(face.normal, face.along);
    Vec2 low{std::numeric_limits<double>::max()}, high{-std::numeric_limits<double>::max()};
    const Vec3& origin = face.region.outline.front();
    for (const Vec3& corner : face.region.outline) {
        const Vec2 at{glm::dot(corner - origin, face.along), glm::dot(corner - origin, across)};
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    const Vec2 size = high - low;
    const auto count = [&](double side) { return std::clamp(static_cast<int>(std::lround(side / width)), 1, 24); };
    const int columns = count(size.x), rows = count(size.y);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const Vec2 at = low + size * Vec2(static_cast<double>(column) / columns, static_cast<double>(row) / rows);
            CeilingCell cell = cell_of_rectangle(origin + at.x * face.along + at.y * across,
                                                 size.x / columns * face.along, size.y / rows * across);
            cell.face = face.ref;
            take_face(cell, scene, face);
            cells.push_back(std::move(cell));
        }
}

}  // namespace

CeilingCell cell_at(const Vec3& position, const Vec3& normal) {
    CeilingCell cell;
    cell.corners = {position};
    cell.normal = normal;
    measure(cell);
    return cell;
}

CeilingCell cell_around(std::span<const Vec3> places, double area) {
    CeilingCell cell;
    cell.corners.assign(places.begin(), places.end());
    measure(cell);
    const Vec3 low = cell.low, high = cell.high;
    cell.corners = {low,
                    {high.x, low.y, low.z},
                    {high.x, high.y, low.z},
                    {low.x, high.y, low.z},
                    {low.x, low.y, high.z},
                    {high.x, low.y, high.z},
                    high,
                    {low.x, high.y, high.z}};
    const Vec3 size = high - low;
    // No place sees more than three sides of the box, nor more than all that is in it.
    cell.surface = area;
    cell.area = std::min(area, size.x * size.y + size.y * size.z + size.z * size.x);
    return cell;
}

CeilingCell cell_of_rectangle(const Vec3& corner, const Vec3& along, const Vec3& across) {
    CeilingCell cell;
    cell.corners = {corner, corner + along, corner + along + across, corner + across};
    const Vec3 area = glm::cross(along, across);
    cell.area = glm::length(area);
    cell.surface = cell.area;
    if (cell.area > 0.0) cell.normal = area / cell.area;
    measure(cell);
    return cell;
}

std::vector<CeilingCell> ceiling_cells(const Scene& scene, std::span<const Face> faces) {
    std::map<ObjectId, bool> is_furniture;
    for (const Furniture& piece : scene.furniture) is_furniture[piece.id] = true;
    double area = 0.0, of_furniture = 0.0;
    for (const Face& face : faces)
        (is_furniture.contains(face.ref.object) ? of_furniture : area) += glm::length(vector_area(face.region));
    constexpr double of_many = 4.0;  // so many more rectangles where there is hardly anything but furniture
    const double width = std::sqrt(std::max({area, of_furniture / of_many, 1e-300}) / rectangles_aimed_at);

    std::vector<CeilingCell> cells;
    std::map<ObjectId, std::vector<const Face*>> pieces;
    for (const Face& face : faces) {
        const bool of_piece = is_furniture.contains(face.ref.object);
        if (of_piece && faces.size() > most_faces) {
            pieces[face.ref.object].push_back(&face);
            continue;
        }
        const std::size_t first = cells.size();
        append_rectangles(scene, face, width, cells);
        for (std::size_t k = first; of_piece && k < cells.size(); ++k) cells[k].object = face.ref.object;
    }
    for (const auto& [id, of_piece] : pieces) {
        std::vector<Vec3> corners;
        double surface = 0.0;
        for (const Face* face : of_piece) {
            corners.insert(corners.end(), face->region.outline.begin(), face->region.outline.end());
            surface += glm::length(vector_area(face->region));
        }
        CeilingCell cell = cell_around(corners, surface);
        cell.object = id;
        for (const Face* face : of_piece) take_face(cell, scene, *face);
        cells.push_back(std::move(cell));
    }
    return cells;
}

double distance(const CeilingCell& a, const CeilingCell& b) {
    return glm::length(glm::max(Vec3{0.0}, glm::max(a.low - b.high, b.low - a.high)));
}

SeenSource most_seen(const CeilingCell& receiver, const CeilingCell& source) {
    SeenSource seen{1.0, std::numeric_limits<double>::infinity()};
    const double apart = distance(receiver, source);
    const double scale = std::max(receiver.radius, source.radius) + glm::distance(receiver.centre, source.centre);
    const double same_place = tolerance::same_place * scale;
    double cosines = 1.0;
    if (receiver.is_flat()) {
        const double height = height_over(receiver, source);
        if (height <= same_place) return {};
        if (apart > 0.0) cosines *= std::min(1.0, height / apart);
    }
    if (source.is_flat()) {
        const double height = height_over(source, receiver);
        if (height <= same_place) return {};
        if (apart > 0.0) cosines *= std::min(1.0, height / apart);
    }
    if (receiver.is_flat() && source.is_flat())
        seen.factor = std::min(1.0, 0.5 * (1.0 - glm::dot(receiver.normal, source.normal)) + rounding);
    if (apart > 0.0) {
        seen.kernel = cosines / (pi * apart * apart);
        seen.factor = std::min(seen.factor, source.area * seen.kernel);
    }
    const double to_centre = distance(source.centre, receiver);
    if (to_centre > source.radius)
        seen.factor = std::min(seen.factor, source.radius * source.radius / (to_centre * to_centre));
    return seen;
}

SeenSource most_seen(const Receiver& place, const CeilingCell& source) {
    SeenSource seen = most_seen(cell_at(place.position, place.normal), source);
    const double near = 1e-6 * source.radius;  // on an edge the limit depends on the side
    if (seen.factor <= 0.0 || distance(place.position, source) <= near) return seen;
    if (source.is_flat()) {
        seen.factor = std::min(seen.factor, configuration_factor(source.corners, place) + rounding);
        return seen;
    }
    constexpr int sides[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 4, 7, 3}, {1, 2, 6, 5}};
    double covered = rounding;
    for (const auto& side : sides) {
        std::array<Vec3, 4> corners;
        for (std::size_t k = 0; k < 4; ++k) corners[k] = source.corners[static_cast<std::size_t>(side[k])];
        covered += configuration_factor(corners, place);
    }
    seen.factor = std::min(seen.factor, covered);
    return seen;
}

}  // namespace hanei
