#include "tests/random_scene.h"

#include "engine/scene/scene_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei::test {

double Dice::logarithmic(double low, double high) { return std::exp(in(std::log(low), std::log(high))); }

Vec3 Dice::direction() {
    const double z = in(-1.0, 1.0), angle = in(0.0, 2.0 * std::numbers::pi), r = std::sqrt(1.0 - z * z);
    const Vec3 any{r * std::cos(angle), r * std::sin(angle), z};
    return any / glm::length(any);
}

namespace {

void add_materials(Scene& scene, Dice& dice) {
    const double bright = dice.chance(0.1) ? 0.99 : 0.9;
    for (int k = 0; k < 4; ++k) {
        const double reflectance = dice.chance(0.1) ? 0.0 : dice.in(0.02, bright);
        scene.materials.push_back({scene.new_id(), "material " + std::to_string(k), reflectance, {}});
    }
    if (dice.chance(0.05)) scene.materials.front().reflectance = 1.0;
}

ObjectId any_material(const Scene& scene, Dice& dice) {
    return scene.materials[static_cast<std::size_t>(dice.below(static_cast<int>(scene.materials.size())))].id;
}

std::vector<Vec2> random_plan(Dice& dice, const Vec3& size) {
    const double x = size.x, y = size.y;
    switch (dice.below(8)) {
        case 0: {
            const double a = dice.in(0.2, 0.8) * x, b = dice.in(0.2, 0.8) * y;
            return {{0.0, 0.0}, {x, 0.0}, {x, b}, {a, b}, {a, y}, {0.0, y}};
        }
        case 1: {
            std::vector<Vec2> star;
            const int corners = 3 + dice.below(6);
            for (int k = 0; k < corners; ++k) {
                const double angle = 2.0 * std::numbers::pi * (k + dice.in(0.0, 0.6)) / corners;
                const double r = dice.in(0.5, 1.0);
                star.emplace_back(0.5 * x * (1.0 + r * std::cos(angle)), 0.5 * y * (1.0 + r * std::sin(angle)));
            }
            return star;
        }
        case 2:
            return {{0.0, 0.0}, {x, 1e-6}, {x, y}, {0.0, y}};  // hardly not square
        default:
            return {{0.0, 0.0}, {x, 0.0}, {x, y}, {0.0, y}};
    }
}

void add_room(Scene& scene, Dice& dice, const Vec3& size) {
    Room room;
    room.id = scene.new_id();
    room.plan = random_plan(dice, size);
    room.height = size.z;
    room.floor_material = any_material(scene, dice);
    room.ceiling_material = any_material(scene, dice);
    for (std::size_t k = 0; k < room.plan.size(); ++k) room.wall_materials.push_back(any_material(scene, dice));
    for (int k = dice.chance(0.3) ? 1 + dice.below(3) : 0; k > 0; --k) {
        SubArea area;
        area.id = scene.new_id();
        area.face = dice.below(static_cast<int>(room.plan.size()) + 2);
        area.low = {dice.in(0.0, 0.5) * size.x, dice.chance(0.3) ? 0.0 : dice.in(0.0, 0.5) * size.z};
        area.high = area.low + Vec2{dice.logarithmic(1e-3, size.x), dice.logarithmic(1e-3, size.z)};
        area.material = any_material(scene, dice);
        room.sub_areas.push_back(area);
    }
    scene.room = room;
}

/// A place worth asking at: a corner or the middle of an edge of a box, the room's corners, a source.
Vec3 marked_place(const Scene& scene, Dice& dice, const Vec3& size) {
    const int which = dice.below(4);
    if (which == 0 && !scene.luminaires.empty()) return scene.luminaires.front().position;
    if (which == 1 && !scene.furniture.empty()) {
        const Furniture& furniture = scene.furniture.front();
        const auto* const box = std::get_if<BoxShape>(&furniture.parts.front().shape);
        const Vec3 half = box ? Vec3{0.5 * box->size.x, 0.5 * box->size.y, box->size.z} : Vec3{0.3};
        return furniture.position + half * Vec3{dice.pick({-1.0, 0.0, 1.0}), 1.0, dice.pick({0.0, 1.0})};
    }
    if (which == 2) return {dice.pick({0.0, 0.5, 1.0}) * size.x, 0.0, dice.pick({0.0, 1.0}) * size.z};
    return {dice.in(0.0, 1.0) * size.x, dice.in(0.0, 1.0) * size.y,
            scene.luminaires.empty() ? 0.0 : scene.luminaires.front().position.z};
}

void add_places(Scene& scene, Dice& dice, const Vec3& size) {
    for (int k = 0; k < 6; ++k) {
        const Vec3 normal = dice.chance(0.6) ? Vec3{0.0, 0.0, 1.0} : dice.direction();
        Vec3 place = dice.in_box(Vec3{0.0}, size);
        if (k % 3 == 1) place.z = 0.0;
        if (k % 3 == 2) place = marked_place(scene, dice, size);
        scene.points.push_back({scene.new_id(), "point", place, normal, {}});
    }
    if (dice.chance(0.5)) {
        CalculationGrid grid;
        grid.id = scene.new_id();
        grid.corner = {0.0, 0.0, dice.pick({0.0, 0.75})};
        grid.along = {size.x, 0.0, 0.0};
        grid.across = {0.0, size.y, 0.0};
        grid.spacing = std::max(size.x, size.y) / 3.0;
        scene.grids.push_back(grid);
    }
}

Scene drawn(Dice& dice) {
    Scene scene;
    scene.title = "random";
    add_materials(scene, dice);
    Vec3 size{dice.in(2.0, 8.0), dice.in(2.0, 6.0), dice.in(2.2, 4.0)};
    if (dice.chance(0.1)) size.y = 0.3;  // a corridor
    if (dice.chance(0.85)) add_room(scene, dice, size);
    add_random_furniture(scene, dice, size);
    if (!scene.room || dice.chance(0.4)) add_random_surfaces(scene, dice, size);
    add_random_luminaires(scene, dice, size);
    add_places(scene, dice, size);
    scene.maintenance_factor = dice.chance(0.2) ? dice.in(0.0, 1.0) : 1.0;
    const double scale = dice.chance(0.2) ? dice.pick({1e-3, 1e-2, 30.0, 1e3}) : 1.0;
    const Vec3 by = dice.chance(0.2) ? dice.pick({Vec3{1e3, -2e3, 50.0}, Vec3{1e5, 1e5, 0.0}}) : Vec3{0.0};
    move_and_stretch(scene, by, scale);
    return scene;
}

struct Stretch {
    double scale;
    void operator()(Polygon& loop) const {
        for (Vec3& corner : loop) corner *= scale;
    }
    void operator()(Region& region) const {
        (*this)(region.outline);
        for (Polygon& hole : region.holes) (*this)(hole);
    }
    void operator()(PointOpening&) const {}
    void operator()(MeasuredOpening&) const {}
    void operator()(LineOpening& line) const {
        line.from *= scale;
        line.to *= scale;
    }
    void operator()(PolygonOpening& opening) const { (*this)(opening.region); }
    void operator()(PolyhedronOpening& solid) const { (*this)(solid.vertices); }
    void operator()(BoxShape& box) const { box.size *= scale; }
    void operator()(SolidShape& solid) const { (*this)(solid.vertices); }
};

}  // namespace

void move_and_stretch(Scene& scene, const Vec3& by, double scale) {
    const Stretch stretch{scale};
    const auto move = [&](Vec3& place) { place = scale * place + by; };
    if (scene.room) {
        for (Vec2& corner : scene.room->plan) corner = scale * corner + Vec2{by};
        scene.room->floor_height = scale * scene.room->floor_height + by.z;
        scene.room->height *= scale;
        for (SubArea& area : scene.room->sub_areas) {
            const Vec2 moved_with_it = area.face < Room::wall_face(0) ? Vec2{by} : Vec2{0.0};
            area.low = scale * area.low + moved_with_it;
            area.high = scale * area.high + moved_with_it;
        }
    }
    for (Furniture& furniture : scene.furniture) {
        move(furniture.position);
        for (Part& part : furniture.parts) {
            part.position *= scale;
            std::visit(stretch, part.shape);
        }
    }
    for (FreeSurface& surface : scene.surfaces) {
        stretch(surface.region);
        for (Vec3& corner : surface.region.outline) corner += by;
        for (Polygon& hole : surface.region.holes)
            for (Vec3& corner : hole) corner += by;
    }
    for (Photometry& photometry : scene.photometries) {
        photometry.opening.extent_0 *= scale;
        photometry.opening.extent_90 *= scale;
        photometry.opening.height *= scale;
        for (double& candela : photometry.candela) candela *= scale * scale;
    }
    for (Luminaire& luminaire : scene.luminaires) {
        move(luminaire.position);
        std::visit(stretch, luminaire.opening);
        if (auto* const flux = std::get_if<LuminousFlux>(&luminaire.output)) flux->value *= scale * scale;
    }
    for (CalculationGrid& grid : scene.grids) {
        move(grid.corner);
        grid.along *= scale;
        grid.across *= scale;
        grid.spacing *= scale;
    }
    for (CalculationPoint& point : scene.points) move(point.position);
}

double extent_of(const Scene& scene) {
    Vec3 low{INFINITY}, high{-INFINITY};
    const auto take = [&](const Vec3& place) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    };
    if (scene.room)
        for (const Vec2& corner : scene.room->plan)
            for (const double z : {0.0, scene.room->height}) take({corner, scene.room->floor_height + z});
    for (const FreeSurface& surface : scene.surfaces)
        for (const Vec3& corner : surface.region.outline) take(corner);
    for (const CalculationPoint& point : scene.points) take(point.position);
    const Vec3 size = high - low;
    return std::max({size.x, size.y, size.z});
}

Scene random_scene(std::uint64_t seed) {
    Dice dice(seed);
    for (;;) {
        Scene scene = drawn(dice);
        if (!has_errors(check_scene(scene))) return scene;
    }
}

namespace {

/// How far an opening reaches from its luminaire's place.
double reach_of(const Scene& scene, const Luminaire& luminaire) {
    const auto farthest = [](const std::vector<Vec3>& places) {
        double far = 0.0;
        for (const Vec3& place : places) far = std::max(far, glm::length(place));
        return far;
    };
    if (const auto* const line = std::get_if<LineOpening>(&luminaire.opening)) return farthest({line->from, line->to});
    if (const auto* const polygon = std::get_if<PolygonOpening>(&luminaire.opening))
        return farthest(polygon->region.outline);
    if (const auto* const solid = std::get_if<PolyhedronOpening>(&luminaire.opening)) return farthest(solid->vertices);
    double far = 0.0;
    if (const auto* const measured = std::get_if<Measured>(&luminaire.distribution))
        for (const Photometry& table : scene.photometries)
            if (table.id == measured->photometry)
                far = glm::length(Vec3{table.opening.extent_0, table.opening.extent_90, table.opening.height});
    return far;
}

/// A box around every luminaire keeps clear of furniture, walls and ceiling.
bool hang_free(const Scene& scene) {
    Scene boxed = scene;
    boxed.luminaires.clear();
    boxed.points.clear();
    for (const Luminaire& luminaire : scene.luminaires) {
        const double half = 1.01 * reach_of(scene, luminaire) + 0.01 * extent_of(scene);
        Furniture around;
        around.id = boxed.new_id();
        around.name = "around a luminaire";
        around.position = luminaire.position - Vec3{0.0, 0.0, half};
        Part part;
        part.shape = BoxShape{Vec3{2.0 * half}};
        part.material = boxed.materials.front().id;
        around.parts.push_back(part);
        boxed.furniture.push_back(around);
    }
    const Diagnostics findings = check_scene(boxed);
    return std::none_of(findings.begin(), findings.end(), [](const Diagnostic& finding) {
        return finding.message.find("around a luminaire") != std::string::npos;
    });
}

}  // namespace

Scene random_scene_of_free_luminaires(std::uint64_t seed) {
    for (std::uint64_t k = 0;; ++k) {
        Scene scene = random_scene(seed + (k << 32U));
        if (scene.room) scene.surfaces.clear();  // light on their backs is counted nowhere
        const auto stray = [&](const Luminaire& luminaire) {
            Scene alone = scene;
            alone.luminaires = {luminaire};
            return !hang_free(alone);
        };
        scene.luminaires.erase(std::remove_if(scene.luminaires.begin(), scene.luminaires.end(), stray),
                               scene.luminaires.end());
        if (!scene.luminaires.empty()) return scene;
    }
}

Settings random_settings(std::uint64_t seed, const Scene& scene) {
    Dice dice(seed ^ 0x9e3779b97f4a7c15U);
    Settings settings;
    settings.method = dice.pick({Method::patch, Method::patch, Method::linear, Method::linear, Method::linear,
                                 Method::paper, Method::paper_closed});
    settings.max_patch = extent_of(scene) / dice.in(3.0, 12.0);
    settings.bounces = is_of_the_paper(settings.method) ? 4 : dice.pick({0, 1, 1000, 1000, 1000});
    settings.accuracy = dice.logarithmic(1e-4, 1e-2);
    settings.tolerance_lux = dice.chance(0.3) ? dice.logarithmic(1e-3, 100.0) : 0.0;
    settings.threads = dice.pick({1, 1, 3});
    settings.memory_mb = dice.pick({16, 1024});
    return settings;
}

}  // namespace hanei::test
