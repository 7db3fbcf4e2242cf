#include "ui/panels/probe.h"

#include "engine/edit/edit.h"
#include "engine/report/numbers.h"
#include "engine/study/study.h"
#include "ui/panels/illuminance_text.h"
#include "ui/panels/language.h"
#include "ui/view/pick.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace hanei {

std::string short_figure(double value) {
    const double size = std::abs(value);
    if (!has_bound(size)) return tr("no bound");
    if (size >= 99.95 || size == 0.0) return fmt::format("{:.0f}", value);
    if (size >= 9.995) return fmt::format("{:.1f}", value);
    if (size >= 0.995) return fmt::format("{:.2f}", value);
    return fmt::format("{:.2g}", value);
}

std::string causes(const ErrorBar& error) {
    constexpr double matters = 0.01;  // of the whole
    std::array<std::pair<double, std::string_view>, 4> parts{{{error.iteration, "iteration"},
                                                              {error.mesh, "mesh"},
                                                              {error.skipped, "skipped"},
                                                              {error.sampling, "sampling"}}};
    if (!has_bound(error.total())) return {};
    std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::string text;
    for (const auto& [lux, cause] : parts)
        if (lux > matters * error.total())
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", tr(cause), illuminance_figure(lux));
    return text;
}

std::string Probe::text() const {
    if (value.inside_solid) return say("inside · {}", surface);
    const std::string split = causes(value.error);
    return say("{} ± {}{} · direct {} · interreflected {} · {}", illuminance_text(value.total().value),
               illuminance_figure(value.error.total()), split.empty() ? "" : " (" + split + ")",
               illuminance_figure(value.direct.value), illuminance_figure(value.interreflected.value), surface);
}

std::string surface_name(const Scene& scene, const SurfaceRef& surface) {
    if (!scene.room || surface.object != scene.room->id) return display_name(scene, surface.object);
    if (surface.face == Room::floor_face) return tr("Floor");
    if (surface.face == Room::ceiling_face) return tr("Ceiling");
    return say("Wall {}", surface.face - Room::wall_face(0) + 1);
}

std::optional<Probe> probe_at(const Solution& solution, const Ray& ray) {
    if (!solution.mesh || !solution.display) return std::nullopt;
    const std::optional<SurfaceHit> met = hit(solution, ray);
    if (!met) return std::nullopt;
    return Probe{met->place, value_at(solution, met->place, met->normal), surface_name(*solution.scene, met->surface),
                 met->normal};
}

}  // namespace hanei
