#include "ui/view/difference.h"

#include "engine/geometry/polygon.h"
#include "ui/view/cell_field.h"
#include "ui/view/ray_tree.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace hanei {
namespace {

constexpr double reach = 0.03;        // m: a wall that was moved by more is another wall
constexpr double same_way = 0.9;      // cosine between the normals of surfaces that are compared
constexpr double inward = 0.002;      // m: vertices on an edge are sampled inside their face
constexpr double same_place = 1e-6;   // m, of calculation points
constexpr double shown_share = 0.99;  // of the area lies within the suggested scale

Box box_of(const Solution& solution, const DisplayCell& cell) {
    Vec3 low = solution.display->vertices[cell.corner[0]].position, high = low;
    for (const std::uint32_t corner : cell.corner) {
        low = glm::min(low, solution.display->vertices[corner].position);
        high = glm::max(high, solution.display->vertices[corner].position);
    }
    return {low - 1e-6, high + 1e-6};
}

PointValue minus(const PointValue& second, const PointValue& first) {
    PointValue value = second;
    value.inside_solid = second.inside_solid || first.inside_solid;
    value.direct = {second.direct.value - first.direct.value};
    value.interreflected = {second.interreflected.value - first.interreflected.value};
    value.error = {first.error.iteration + second.error.iteration, first.error.mesh + second.error.mesh,
                   first.error.skipped + second.error.skipped, first.error.sampling + second.error.sampling};
    return value;
}

bool same_places(const GridResult& a, const GridResult& b) {
    return a.columns == b.columns && a.rows == b.rows &&
           std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
                      [](const PointResult& p, const PointResult& q) {
                          return glm::distance(p.position, q.position) < same_place;
                      });
}

std::string name_of_grid(const Solution& solution, ObjectId id) {
    for (const CalculationGrid& grid : solution.scene->grids)
        if (grid.id == id) return grid.name;
    return {};
}

const GridResult* counterpart(const Solution& first, const Solution& second, const GridResult& grid) {
    for (const GridResult& other : first.grids)
        if (other.grid == grid.grid) return &other;
    const std::string name = name_of_grid(second, grid.grid);
    for (const GridResult& other : first.grids)
        if (!name.empty() && name_of_grid(first, other.grid) == name) return &other;
    return nullptr;
}

void compare_values(Solution& made, const Solution& first) {
    std::erase_if(made.grids, [&](GridResult& grid) {
        const GridResult* const other = counterpart(first, made, grid);
        if (other == nullptr || !same_places(grid, *other)) return true;
        for (std::size_t k = 0; k < grid.points.size(); ++k)
            grid.points[k].value = minus(grid.points[k].value, other->points[k].value);
        return false;
    });
    std::erase_if(made.points, [&](PointResult& point) {
        const auto other = std::find_if(first.points.begin(), first.points.end(), [&](const PointResult& candidate) {
            return candidate.point == point.point && glm::distance(candidate.position, point.position) < same_place;
        });
        if (other == first.points.end()) return true;
        point.value = minus(point.value, other->value);
        return false;
    });
}

}  // namespace

struct SurfaceSampler::Cells {
    const Solution& solution;
    std::vector<CellFrame> frames;
    RayTree tree;
};

SurfaceSampler::SurfaceSampler(const Solution& solution) {
    std::vector<Box> boxes;
    std::vector<CellFrame> frames;
    for (const DisplayCell& cell : solution.display->cells) {
        boxes.push_back(box_of(solution, cell));
        frames.push_back(frame_of(solution, cell));
    }
    cells_ = std::make_unique<const Cells>(Cells{solution, std::move(frames), RayTree(boxes)});
}

SurfaceSampler::~SurfaceSampler() = default;

std::optional<SurfaceSampler::Light> SurfaceSampler::at(const Vec3& place, const Vec3& normal) const {
    const Ray ray{place + reach * normal, -normal};
    const double farthest = 2.0 * reach;
    double nearest = farthest;
    std::optional<std::uint32_t> found;
    Vec2 where(0.0);
    cells_->tree.visit(ray, 0.0, farthest, [&](std::uint32_t number) {
        const CellFrame& frame = cells_->frames[number];
        const double facing = glm::dot(frame.normal, normal);
        if (facing < same_way) return;
        const double along = glm::dot(ray.origin - frame.origin, frame.normal) / facing;
        const double away = std::abs(along - reach);
        const Vec2 flat = frame.flat(ray.origin + along * ray.direction);
        if (!(away < nearest) || !contains(frame, flat)) return;
        nearest = away;
        found = number;
        where = flat;
    });
    if (!found) return std::nullopt;
    const CellFrame& frame = cells_->frames[*found];
    const Vec2 uv = glm::clamp(bilinear_coordinates(frame, where), Vec2(0.0), Vec2(1.0));
    const DisplayMesh& display = *cells_->solution.display;
    const DisplayCell& cell = display.cells[*found];
    const auto value = [&](LightPart part) { return bilinear(corner_values(display, cell, part), uv); };
    return Light{value(LightPart::direct), value(LightPart::interreflected), value(LightPart::unshadowed)};
}

SolutionSnapshot difference_of(const Solution& first, const Solution& second) {
    auto made = std::make_shared<Solution>(second);
    compare_values(*made, first);
    auto display = std::make_shared<DisplayMesh>(*second.display);
    display->has_unshadowed = first.display->has_unshadowed && second.display->has_unshadowed;
    display->tinted.clear();
    struct Surroundings {
        Vec3 normal{0.0}, middle{0.0};
        double cells = 0.0;
    };
    std::vector<Surroundings> around(display->vertices.size());
    for (const DisplayCell& cell : display->cells) {
        Vec3 middle(0.0);
        for (const std::uint32_t corner : cell.corner) middle += 0.25 * display->vertices[corner].position;
        for (const std::uint32_t corner : cell.corner) {
            around[corner].normal = second.mesh->faces[cell.face].face.normal;
            around[corner].middle += middle;
            around[corner].cells += 1.0;
        }
    }
    const SurfaceSampler sampler(first);
    for (std::size_t v = 0; v < display->vertices.size(); ++v) {
        DisplayVertex& vertex = display->vertices[v];
        const Surroundings& near = around[v];
        if (near.cells == 0.0) continue;
        const Vec3 into = near.middle / near.cells - vertex.position;
        const double length = glm::length(into);
        const Vec3 place = length > 0.0 ? vertex.position + std::min(inward / length, 0.1) * into : vertex.position;
        if (const auto light = sampler.at(place, near.normal)) {
            vertex.direct -= static_cast<float>(light->direct);
            vertex.interreflected -= static_cast<float>(light->interreflected);
            vertex.unshadowed -= static_cast<float>(light->unshadowed);
        } else {
            vertex.direct = vertex.interreflected = vertex.unshadowed = no_counterpart;
        }
    }
    made->display = std::move(display);
    return made;
}

double suggested_difference(const Solution& difference, LightPart part) {
    std::map<double, double> area_of;  // by the size of the difference
    double whole = 0.0;
    for (const DisplayCell& cell : difference.display->cells) {
        double greatest = 0.0;
        Polygon outline;
        for (const std::uint32_t corner : cell.corner) {
            const DisplayVertex& vertex = difference.display->vertices[corner];
            greatest = std::max(greatest, std::abs(static_cast<double>(value_of(vertex, part))));
            outline.push_back(vertex.position);
        }
        if (!has_counterpart(greatest)) continue;
        const double area = glm::length(vector_area(outline));
        area_of[greatest] += area;
        whole += area;
    }
    double passed = 0.0, high = 1.0;
    for (const auto& [lux, area] : area_of) {
        passed += area;
        high = std::max(high, lux);
        if (passed >= shown_share * whole) break;
    }
    const double decade = std::pow(10.0, std::floor(std::log10(high)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * decade >= high) return digit * decade;
    return 10.0 * decade;
}

std::vector<GridDifference> compared_grids(const Solution& first, const Solution& second) {
    std::vector<GridDifference> rows;
    std::vector<const GridResult*> used;
    for (const GridResult& grid : second.grids) {
        GridDifference row{grid.grid, name_of_grid(second, grid.grid), std::nullopt, figures_of(grid)};
        if (const GridResult* const other = counterpart(first, second, grid)) {
            row.first = figures_of(*other);
            used.push_back(other);
        }
        rows.push_back(std::move(row));
    }
    for (const GridResult& grid : first.grids)
        if (std::find(used.begin(), used.end(), &grid) == used.end())
            rows.push_back({grid.grid, name_of_grid(first, grid.grid), figures_of(grid), std::nullopt});
    return rows;
}

}  // namespace hanei
