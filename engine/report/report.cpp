#include "engine/report/report.h"

#include "engine/report/numbers.h"

#include <algorithm>
#include <fmt/format.h>

namespace hanei {

namespace {

std::string_view word_for(Stage stage) {
    switch (stage) {
        case Stage::idle:
            return "idle";
        case Stage::planning:
            return "plan";
        case Stage::meshing:
            return "mesh";
        case Stage::direct:
            return "direct light";
        case Stage::factors:
            return "form factors";
        case Stage::balance:
            return "balance";
        case Stage::gathering:
            return "values";
        case Stage::refining:
            return "display";
        case Stage::done:
            return "done";
    }
    return "";
}

/// A name cut to the column it is given, so that tables stay tables.
std::string cut(const std::string& name, std::size_t width) {
    return name.size() <= width ? name : name.substr(0, width - 2) + "..";
}

std::string grid_name(const Scene& scene, ObjectId id) {
    for (const CalculationGrid& grid : scene.grids)
        if (grid.id == id) return grid.name;
    return {};
}

std::string point_name(const Scene& scene, ObjectId id) {
    for (const CalculationPoint& point : scene.points)
        if (point.id == id) return point.name;
    return {};
}

std::string error_text(double lux) { return has_bound(lux) ? fmt::format("{:.2g}", lux) : "no bound"; }

std::string bound_text(double lux) {
    return has_bound(lux) ? fmt::format("known to {:.2g} lx of exitance", lux) : "without a bound";
}

std::string grids_text(const Solution& solution) {
    if (solution.grids.empty()) return {};
    std::string text = fmt::format("{:<24} {:>7} {:>9} {:>9} {:>9} {:>6} {:>12}\n", "grid", "points", "mean lx",
                                   "min lx", "max lx", "U0", "error <= lx");
    for (const GridResult& grid : solution.grids) {
        const GridFigures figures = figures_of(grid);
        text += fmt::format("{:<24} {:>7} {:>9.1f} {:>9.1f} {:>9.1f} {:>6.2f} {:>12}\n",
                            cut(grid_name(*solution.scene, grid.grid), 24), figures.points, figures.mean, figures.min,
                            figures.max, figures.uniformity, error_text(figures.largest_error));
    }
    return text + '\n';
}

std::string points_text(const Solution& solution) {
    if (solution.points.empty()) return {};
    std::string text =
        fmt::format("{:<24} {:>20} {:>10} {:>16}\n", "point", "illuminance", "direct lx", "interreflected lx");
    for (const PointResult& point : solution.points) {
        const std::string name = cut(point_name(*solution.scene, point.point), 24);
        if (point.value.inside_solid) {
            text += fmt::format("{:<24} inside a solid\n", name);
            continue;
        }
        // The sign of the error bar is two bytes and one column wide.
        text += fmt::format("{:<24} {:>21} {:>10.1f} {:>17.1f}\n", name,
                            illuminance_text(point.value.total(), point.value.error.total()), point.value.direct.value,
                            point.value.interreflected.value);
    }
    return text + '\n';
}

std::string times_text(const Solution& solution) {
    std::string text;
    for (const StageTime& time : solution.times) {
        if (time.ms < 0.05) continue;
        if (!text.empty()) text += ", ";
        text += fmt::format("{} {:.1f} ms{}", word_for(time.stage), time.ms, time.reused ? " (kept)" : "");
    }
    return text;
}

}  // namespace

std::string summary_text(const Solution& solution) {
    std::string text = solution.scene->title + "\n\n" + grids_text(solution) + points_text(solution);
    text += fmt::format("method {}, {} patches at {} m, {} bounces{}\n", name_of(solution.settings.method),
                        solution.mesh->patches.size(), solution.patch_width, solution.bounces,
                        solution.converged ? "" : " (not converged: see the error bars)");
    text += fmt::format("iteration {}; typical mesh error {:.2g} lx\n", bound_text(solution.iteration_bound),
                        solution.typical_mesh_error);
    const EnergyBalance& energy = solution.energy;
    text += fmt::format("flux: {:.1f} lm emitted = {:.1f} lm absorbed", energy.emitted, energy.absorbed);
    if (energy.on_luminaires > 0.0) text += fmt::format(" + {:.1f} lm onto luminaires", energy.on_luminaires);
    text += fmt::format(" + {:.1f} lm escaped, to {:.3f} %\n", energy.escaped,
                        energy.emitted > 0.0 ? 100.0 * energy.imbalance() / energy.emitted : 0.0);
    text += fmt::format("closure: light between surfaces scaled by {:.3f} % so that as much arrives as left\n",
                        100.0 * solution.closure);
    if (!solution.refusal.empty()) text += "refused: " + solution.refusal + '\n';
    text += "time: " + times_text(solution) + '\n';
    for (const std::string& note : solution.notes) text += "note: " + note + '\n';
    return text;
}

std::string values_csv(const Solution& solution) {
    std::string text =
        "kind,name,x_m,y_m,z_m,nx,ny,nz,total_lx,direct_lx,interreflected_lx,error_lx,error_iteration_lx,"
        "error_mesh_lx,error_skipped_lx,error_sampling_lx,inside_solid\n";
    const auto add = [&](std::string_view kind, const std::string& name, const PointResult& point) {
        const PointValue& value = point.value;
        text += fmt::format("{},{}", kind, csv_field(name));
        for (const double number :
             {point.position.x, point.position.y, point.position.z, point.normal.x, point.normal.y, point.normal.z,
              value.total().value, value.direct.value, value.interreflected.value, value.error.total(),
              value.error.iteration, value.error.mesh, value.error.skipped, value.error.sampling})
            text += fmt::format(",{}", number);
        text += value.inside_solid ? ",1\n" : ",0\n";
    };
    for (const PointResult& point : solution.points) add("point", point_name(*solution.scene, point.point), point);
    for (const GridResult& grid : solution.grids)
        for (const PointResult& point : grid.points) add("grid", grid_name(*solution.scene, grid.grid), point);
    return text;
}

/// A bound that was not asked for is none.
static std::string bound_figure(double lux) { return lux < 0.0 ? std::string("-") : fmt::format("{:.3g}", lux); }

std::string plan_text(const EffectsPlan& plan) {
    std::string text =
        fmt::format("{:<26} {:<12} {:>12} {:>12}  {}\n", "effect", "state", "bound lx", "cost ms", "why");
    for (const PlannedEffect& effect : plan.effects) {
        const double cost = effect.measured_ms >= 0.0 ? effect.measured_ms : effect.predicted_ms;
        text += fmt::format("{:<26} {:<12} {:>12} {:>11.1f}{}  {}\n", name_of(effect.effect), name_of(effect.state),
                            effect.may_be_skipped || effect.bound_lux > 0.0 ? bound_figure(effect.bound_lux) : "-",
                            cost, effect.measured_ms >= 0.0 ? " " : "~", effect.why);
    }
    for (const PlannedPiece& piece : plan.row(Effect::furniture).pieces)
        text += fmt::format("  {:<24} {:<12} {:>12} {:>11.1f}~  reflectance {:.2g}, {:.3g} m2\n", piece.name,
                            name_of(piece.state), bound_figure(piece.bound_lux), piece.predicted_ms, piece.reflectance,
                            piece.area);
    text += "bounds of direct shadows, penumbra and openings are of light straight from luminaires\n";
    text +=
        fmt::format("skipped effects leave out at most {:.3g} lx {}\n", plan.skipped_lux, "at any calculation point");
    return text;
}

}  // namespace hanei
