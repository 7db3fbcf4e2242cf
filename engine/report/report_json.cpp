#include "engine/report/report_json.h"

#include <nlohmann/json.hpp>

namespace hanei {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

Json to_json(const PointValue& value) {
    if (value.inside_solid) return {{"inside_solid", true}};
    return {{"total_lx", value.total().value},
            {"direct_lx", value.direct.value},
            {"interreflected_lx", value.interreflected.value},
            {"error_lx",
             {{"total", value.error.total()},
              {"iteration", value.error.iteration},
              {"mesh", value.error.mesh},
              {"skipped", value.error.skipped},
              {"sampling", value.error.sampling}}}};
}

Json to_json(const PointResult& point) {
    Json json{{"position_m", to_json(point.position)}, {"normal", to_json(point.normal)}};
    json.update(to_json(point.value));
    return json;
}

Json to_json(const GridResult& grid) {
    const GridFigures figures = figures_of(grid);
    Json json{{"id", grid.grid.value},    {"columns", grid.columns},
              {"rows", grid.rows},        {"mean_lx", figures.mean},
              {"min_lx", figures.min},    {"max_lx", figures.max},
              {"u0", figures.uniformity}, {"largest_error_lx", figures.largest_error}};
    for (const PointResult& point : grid.points) json["points"].push_back(to_json(point));
    return json;
}

Json to_json(const EffectsPlan& plan) {
    Json rows = Json::array();
    for (const PlannedEffect& effect : plan.effects) {
        Json row{{"effect", name_of(effect.effect)},
                 {"state", name_of(effect.state)},
                 {"why", effect.why},
                 {"bound_lx", effect.bound_lux},
                 {"predicted_ms", effect.predicted_ms}};
        if (effect.measured_ms >= 0.0) row["measured_ms"] = effect.measured_ms;
        if (effect.count > 0) row["count"] = effect.count;
        if (!effect.bound_at_points.empty()) row["bound_at_points_lx"] = effect.bound_at_points;
        for (const PlannedPiece& piece : effect.pieces)
            row["pieces"].push_back({{"object", piece.object.value},
                                     {"name", piece.name},
                                     {"state", name_of(piece.state)},
                                     {"bound_lx", piece.bound_lux},
                                     {"reflectance", piece.reflectance},
                                     {"area_m2", piece.area},
                                     {"predicted_ms", piece.predicted_ms}});
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace

std::string plan_json(const EffectsPlan& plan) { return to_json(plan).dump(2) + '\n'; }

std::string values_json(const Solution& solution) {
    Json json{{"title", solution.scene->title},
              {"method", name_of(solution.settings.method)},
              {"patches", solution.mesh->patches.size()},
              {"max_patch_m", solution.patch_width},
              {"bounces", solution.bounces},
              {"converged", solution.converged}};
    json["grids"] = Json::array();
    json["points"] = Json::array();
    for (const GridResult& grid : solution.grids) {
        json["grids"].push_back(to_json(grid));
        for (const CalculationGrid& authored : solution.scene->grids)
            if (authored.id == grid.grid) json["grids"].back()["name"] = authored.name;
    }
    for (const PointResult& point : solution.points) {
        json["points"].push_back(to_json(point));
        for (const CalculationPoint& authored : solution.scene->points)
            if (authored.id == point.point) json["points"].back()["name"] = authored.name;
    }
    json["flux_lm"] = {{"emitted", solution.energy.emitted},
                       {"absorbed", solution.energy.absorbed},
                       {"on_luminaires", solution.energy.on_luminaires},
                       {"escaped", solution.energy.escaped},
                       {"imbalance", solution.energy.imbalance()}};
    json["closure_percent"] = 100.0 * solution.closure;
    if (!solution.refusal.empty()) json["refusal"] = solution.refusal;
    json["plan"] = to_json(solution.plan);
    json["notes"] = solution.notes;
    return json.dump(2) + '\n';
}

}  // namespace hanei
