#include "room_by_hand.h"

#include "engine/scene/faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hanei::test {
namespace {

ObjectId add_material(Scene& scene, const char* name, double reflectance) {
    Material material;
    material.id = scene.new_id();
    material.name = name;
    material.reflectance = reflectance;
    scene.materials.push_back(material);
    return material.id;
}

Part box(Vec3 size, Vec3 position, ObjectId material) {
    Part part;
    part.shape = BoxShape{size};
    part.position = position;
    part.material = material;
    return part;
}

Furniture desk(Scene& scene, const char* name, Vec3 position, ObjectId material) {
    Furniture furniture;
    furniture.id = scene.new_id();
    furniture.name = name;
    furniture.position = position;
    furniture.parts.push_back(box({1.6, 0.8, 0.04}, {0, 0, 0.70}, material));
    for (const double x : {-0.76, 0.76}) furniture.parts.push_back(box({0.04, 0.7, 0.70}, {x, 0, 0}, material));
    return furniture;
}

Luminaire panel(Scene& scene, const char* name, Vec3 position) {
    Luminaire luminaire;
    luminaire.id = scene.new_id();
    luminaire.name = name;
    luminaire.position = position;
    luminaire.opening = PolygonOpening{{{{-0.6, 0.3, 0}, {0.6, 0.3, 0}, {0.6, -0.3, 0}, {-0.6, -0.3, 0}}, {}}};
    luminaire.output = LuminousFlux{4000.0};
    return luminaire;
}

void add_grid(Scene& scene) {
    CalculationGrid grid;
    grid.id = scene.new_id();
    grid.name = "Working plane";
    grid.corner = {0.5, 0.5, 0.75};
    grid.along = {5, 0, 0};
    grid.across = {0, 3, 0};
    grid.spacing = 0.5;
    scene.grids.push_back(grid);
}

class Builder {
public:
    explicit Builder(double width) : width_(width) {}

    void add(const Face& face, const LightField& field) {
        const Polygon& outline = face.region.outline;
        const std::uint32_t number = static_cast<std::uint32_t>(mesh.faces.size());
        const std::uint32_t first_patch = static_cast<std::uint32_t>(mesh.patches.size());
        const int columns = cells(outline[1] - outline[0]), rows = cells(outline[3] - outline[0]);
        const std::uint32_t first = static_cast<std::uint32_t>(display.vertices.size());
        for (int row = 0; row <= rows; ++row) {
            for (int column = 0; column <= columns; ++column) {
                const double u = static_cast<double>(column) / columns, v = static_cast<double>(row) / rows;
                add_vertex(glm::mix(glm::mix(outline[0], outline[1], u), glm::mix(outline[3], outline[2], u), v),
                           face.normal, field);
            }
        }
        const std::uint32_t stride = static_cast<std::uint32_t>(columns) + 1;
        for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row) {
            for (std::uint32_t column = 0; column + 1 < stride; ++column) {
                const std::uint32_t a = first + row * stride + column;
                add_cell({a, a + 1, a + 1 + stride, a + stride}, number, face);
            }
        }
        MeshFace meshed;
        meshed.face = face;
        meshed.first_patch = first_patch;
        meshed.patch_count = static_cast<std::uint32_t>(mesh.patches.size()) - first_patch;
        mesh.faces.push_back(meshed);
    }

    Mesh mesh;
    DisplayMesh display;

private:
    int cells(const Vec3& side) const { return std::max(1, static_cast<int>(glm::length(side) / width_ + 0.5)); }

    void add_vertex(const Vec3& place, const Vec3& normal, const LightField& field) {
        const Light light = field(place, normal);
        display.vertices.push_back({place, static_cast<float>(light.direct), static_cast<float>(light.interreflected),
                                    static_cast<float>(light.unshadowed)});
    }

    void add_cell(const std::array<std::uint32_t, 4>& corners, std::uint32_t face_number, const Face& face) {
        DisplayCell cell;
        std::copy(corners.begin(), corners.end(), cell.corner);
        cell.face = face_number;
        cell.patch = static_cast<std::uint32_t>(mesh.patches.size());
        display.cells.push_back(cell);
        Patch patch;
        patch.face = face_number;
        for (const std::uint32_t corner : corners) patch.outline.push_back(display.vertices[corner].position);
        patch.material = face.material;
        mesh.patches.push_back(patch);
    }

    double width_;
};

std::shared_ptr<const Solution> solved(Scene scene, Builder builder) {
    builder.display.has_unshadowed = true;
    auto solution = std::make_shared<Solution>();
    solution->scene = std::make_shared<const Scene>(std::move(scene));
    solution->mesh = std::make_shared<const Mesh>(std::move(builder.mesh));
    solution->display = std::make_shared<const DisplayMesh>(std::move(builder.display));
    solution->bounces = 7;
    solution->complete = true;
    solution->converged = true;
    solution->iteration_bound = 0.04;
    return solution;
}

}  // namespace

Scene furnished_room() {
    Scene scene;
    scene.title = "Furnished room";
    const ObjectId white = add_material(scene, "white", 0.8), wall = add_material(scene, "wall", 0.6);
    const ObjectId carpet = add_material(scene, "carpet", 0.25), wood = add_material(scene, "wood", 0.45);
    Room room;
    room.id = scene.new_id();
    room.plan = {{0, 0}, {6, 0}, {6, 4}, {0, 4}};
    room.height = 2.8;
    room.floor_material = carpet;
    room.ceiling_material = white;
    room.wall_materials.assign(4, wall);
    scene.room = room;
    scene.furniture = {desk(scene, "Desk", {1.6, 2.2, 0}, wood), desk(scene, "Second desk", {4.2, 2.2, 0}, wood)};
    Furniture cupboard;
    cupboard.id = scene.new_id();
    cupboard.name = "Cupboard";
    cupboard.position = {5.2, 3.7, 0};
    cupboard.parts = {box({1.4, 0.45, 1.9}, {0, 0, 0}, wood)};
    scene.furniture.push_back(cupboard);
    scene.luminaires = {panel(scene, "Panel", {1.6, 2.0, 2.75}), panel(scene, "Second panel", {4.3, 2.0, 2.75})};
    Luminaire tube = panel(scene, "Tube", {0.8, 3.7, 2.2});
    tube.opening = LineOpening{{-0.5, 0, 0}, {0.5, 0, 0}};
    Luminaire point = panel(scene, "Point", {3.0, 0.7, 2.0});
    point.opening = PointOpening{};
    scene.luminaires.push_back(tube);
    scene.luminaires.push_back(point);
    add_grid(scene);
    return scene;
}

Light pleasant_light(const Vec3& place, const Vec3& normal) {
    double open = 0.0;
    for (const Vec3 panel : {Vec3(1.6, 2.0, 2.75), Vec3(4.3, 2.0, 2.75)}) {
        const Vec3 towards = panel - place;
        const double square = glm::dot(towards, towards) + 0.1;
        const double below = std::max(0.0, towards.z) / std::sqrt(square);
        open += 4000.0 / std::numbers::pi * below * std::max(0.0, glm::dot(towards, normal)) / std::pow(square, 1.5);
    }
    const bool under_desk = place.z < 0.65 && std::abs(place.y - 2.2) < 0.4 &&
                            std::min(std::abs(place.x - 1.6), std::abs(place.x - 4.2)) < 0.8;
    const double glow = 60.0 + 25.0 * place.z + 20.0 * std::sin(place.x) + 15.0 * normal.z * normal.z;
    return {under_desk ? 0.0 : open, under_desk ? 0.4 * glow : glow, open + glow};
}

std::shared_ptr<const Solution> solution_by_hand(const Scene& scene, const LightField& field, double width) {
    Builder builder(width);
    for (const Face& face : faces_of(scene)) {
        if (face.region.outline.size() == 4) builder.add(face, field);
    }
    auto solution = std::make_shared<Solution>(*solved(scene, std::move(builder)));
    for (const CalculationGrid& grid : scene.grids) {
        GridResult result = layout_of(grid);
        for (PointResult& point : result.points) {
            const Light light = field(point.position, point.normal);
            point.value.direct = {light.direct};
            point.value.interreflected = {light.interreflected};
        }
        solution->grids.push_back(result);
    }
    return solution;
}

std::shared_ptr<const Solution> square_with_hanging_corners(float lux) {
    auto solution = std::make_shared<Solution>(*single_cell({lux, lux, lux, lux}));
    DisplayMesh display;
    const auto add = [&](Vec2 low, Vec2 high) {
        const std::uint32_t first = static_cast<std::uint32_t>(display.vertices.size());
        for (const Vec2 corner : {low, Vec2(high.x, low.y), high, Vec2(low.x, high.y)}) {
            display.vertices.push_back({Vec3(corner, 0.0), lux, 0.0F, 0.0F});
        }
        display.cells.push_back({{first, first + 1, first + 2, first + 3}, 0, 0});
    };
    for (int column = 0; column < 7; ++column) {  // sevenths and elevenths never fall on round numbers
        const double left = -1.0 + 2.0 * column / 7.0, right = -1.0 + 2.0 * (column + 1) / 7.0;
        const int rows = column % 2 == 0 ? 3 : 11;
        for (int row = 0; row < rows; ++row) {
            add({left, -1.0 + 2.0 * row / rows}, {right, -1.0 + 2.0 * (row + 1) / rows});
        }
    }
    solution->display = std::make_shared<const DisplayMesh>(std::move(display));
    return solution;
}

std::shared_ptr<const Solution> single_cell(const std::array<float, 4>& lux) {
    Scene scene;
    const ObjectId grey = add_material(scene, "grey", 0.5);
    FreeSurface surface;
    surface.id = scene.new_id();
    surface.region.outline = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    surface.material = grey;
    scene.surfaces = {surface};
    Builder builder(10.0);
    for (const Face& face : faces_of(scene)) builder.add(face, [](const Vec3&, const Vec3&) { return Light{}; });
    for (DisplayVertex& vertex : builder.display.vertices) {
        const std::size_t corner =
            vertex.position.y < 0.0 ? (vertex.position.x < 0.0 ? 0 : 1) : (vertex.position.x < 0.0 ? 3 : 2);
        vertex.direct = lux[corner];
    }
    return solved(scene, std::move(builder));
}

}  // namespace hanei::test
