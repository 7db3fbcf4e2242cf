#include "engine/report/trust_report.h"
#include "engine/scene/faces.h"

#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

/// As many digits as say something.
std::string figure(double value) {
    const double size = std::abs(value);
    if (!std::isfinite(value)) return "no number";
    if (size >= 1e7) return fmt::format("{:.2e}", value);
    if (size >= 100.0) return fmt::format("{:.0f}", value);
    if (size >= 10.0) return fmt::format("{:.1f}", value);
    if (size >= 1.0) return fmt::format("{:.2f}", value);
    if (size < 1e-12) return "0";
    return size < 1e-4 ? "<0.0001" : fmt::format("{:.2g}", value);
}

std::string percent(double share) { return figure(100.0 * share); }

std::string of_all(double part, double all) { return percent(all > 0.0 ? part / all : 0.0); }

std::string luminaire_name(const Scene& scene, ObjectId id) {
    for (const Luminaire& luminaire : scene.luminaires)
        if (luminaire.id == id && !luminaire.name.empty()) return luminaire.name;
    return fmt::format("luminaire {}", id.value);
}

std::string face_name(const Scene& scene, const SurfaceRef& face) {
    if (scene.room && scene.room->id == face.object) {
        if (face.face == Room::floor_face) return "Floor";
        if (face.face == Room::ceiling_face) return "Ceiling";
        return fmt::format("Wall {}", face.face - Room::wall_face(0) + 1);
    }
    for (const FreeSurface& surface : scene.surfaces)
        if (surface.id == face.object && !surface.name.empty()) return surface.name;
    for (const Furniture& furniture : scene.furniture)
        if (furniture.id == face.object && !furniture.name.empty())
            return fmt::format("{} ({})", furniture.name, face.face + 1);
    return fmt::format("{} ({})", face.object.value, face.face + 1);
}

TrustRow direct_row(const TrustReport& report) {
    const DirectTrust& trust = report.direct;
    TrustRow row{"Direct light", trust.open
                                     ? "No more light arrives on surfaces than luminaires emit."
                                     : "All light of the luminaires arrives on surfaces or on other luminaires."};
    row.state = trust.figure().state();
    row.found = {trust.open ? "{} lm emitted, {} lm arrive on surfaces, {} lm on luminaires; {} lm ({} %) meet nothing"
                            : "{} lm emitted, {} lm arrive on surfaces, {} lm on luminaires; {} lm ({} %) are missing",
                 {figure(trust.emitted), figure(trust.arrived), figure(trust.on_luminaires), figure(trust.missing()),
                  of_all(trust.missing(), trust.emitted)}};
    row.allowed = {"{} lm ({} %): by so much the means over patches claim to be off",
                   {figure(trust.figure().allowed), of_all(trust.figure().allowed, trust.emitted)}};
    if (row.state == TrustState::fails)
        row.advice = {trust.missing() > 0.0
                          ? "{} sends {} of its {} lm to where no surface is, or onto one so close that "
                            "patches miss it. Is part of it in or behind a wall or furniture?"
                          : "Of {} {} lm too many arrive, of {}: a surface is closer to it than patches "
                            "can tell. Make patches smaller, or move it away.",
                      {luminaire_name(*report.solution->scene, trust.worst), figure(std::abs(trust.worst_missing)),
                       figure(trust.worst_emitted)}};
    return row;
}

TrustRow energy_row(const TrustReport& report) {
    const EnergyTrust& trust = report.energy;
    const double emitted = trust.energy.emitted;
    TrustRow row{"Energy", "Every lumen emitted is absorbed, escapes, or is still on its way."};
    row.state = trust.figure().state();
    if (!trust.asked) return row;
    row.found = {
        "{} lm emitted = {} absorbed + {} on luminaires + {} escaped + {} on their way; {} lm ({} %) are "
        "unexplained",
        {figure(emitted), figure(trust.energy.absorbed), figure(trust.energy.on_luminaires),
         figure(trust.energy.escaped), figure(trust.explained()), figure(trust.unexplained()),
         of_all(trust.unexplained(), emitted)}};
    row.allowed = {trust.scaled
                       ? "{} lm: what scaling the {} lm that surfaces receive from surfaces may misplace ({} %), and "
                         "the error of direct light"
                       : "{} lm: the error bar of the {} lm that surfaces receive from surfaces ({} %), and that "
                         "of direct light",
                   {figure(trust.figure().allowed), figure(trust.received), of_all(trust.error, trust.received)}};
    if (!trust.converged)
        row.notes.push_back(
            {"The reflections were stopped after {}, as set: {} % of the light had still to arrive. "
             "Allow more bounces to follow it; as it is, it stands in the error bars.",
             {std::to_string(trust.bounces), of_all(trust.explained(), emitted)}});
    if (row.state == TrustState::fails)
        row.advice = {is_of_the_paper(report.solution->settings.method)
                          ? "Form factors between grid points make or lose light where surfaces come close. Use "
                            "method patch or linear."
                          : "Make patches smaller, or use method linear.",
                      {}};
    return row;
}

TrustRow reciprocity_row(const TrustReport& report) {
    const ReciprocityTrust& trust = report.reciprocity;
    TrustRow row{"Reciprocity", "Through the whole room, one face lights another as that one lights it."};
    row.state = trust.figure().state();
    if (!trust.asked) return row;
    if (const ReciprocityTrust::Pair* const worst = trust.worst()) {
        const Scene& scene = *report.solution->scene;
        row.found = {
            "{} of {} pairs of large faces agree; worst {} and {}: of 1 lm/m2, {} lm arrive one way and {} lm the "
            "other, {} % apart",
            {std::to_string(trust.within()), std::to_string(trust.pairs.size()), face_name(scene, worst->a),
             face_name(scene, worst->b), figure(worst->there), figure(worst->back),
             of_all(std::abs(worst->there - worst->back), 0.5 * (worst->there + worst->back))}};
        row.allowed = {
            "95 of 100 within their error bars, told from patches twice as wide, and the accuracy of form factors; "
            "there {} %",
            {of_all(worst->error, 0.5 * (worst->there + worst->back))}};
    }
    row.notes.push_back(
        {"Form factors of single patches, from either end, are {} % apart ({} pairs). In this light "
         "they made {} % too much or too little, which was scaled away; what that may misplace, {} % "
         "of interreflected light, is in the error bars.",
         {percent(trust.rows_apart), std::to_string(trust.rows_compared), percent(trust.gain),
          percent(trust.misplaced)}});
    if (row.state == TrustState::fails)
        row.advice = {"Make patches smaller than the gaps and edges between the two faces, or use method linear.", {}};
    return row;
}

TrustRow closure_row(const TrustReport& report) {
    const ClosureTrust& trust = report.closure;
    TrustRow row{"Closure", "A patch sends others as much of its light as it sees of them."};
    row.state = trust.figure().state();
    if (!trust.asked) return row;
    const Vec3& place = trust.greatest_place;
    row.found = {
        "Of the light that leaves a patch, {} to {} arrives at others (1 is all of it; most at ({}, {}, {})); this "
        "misplaces {} % of interreflected light in the mean",
        {fmt::format("{:.4f}", trust.least), fmt::format("{:.4f}", trust.greatest), fmt::format("{:.2f}", place.x),
         fmt::format("{:.2f}", place.y), fmt::format("{:.2f}", place.z), percent(trust.misplaced)}};
    row.allowed = {"{} %: the error bar of the mean interreflected light", {percent(trust.figure().allowed)}};
    row.notes.push_back(
        {"From {} places surfaces fill {} % of the view by form factors and {} % by {} rays from each: "
         "{} standard errors apart at worst, of {} that chance allows.",
         {std::to_string(trust.places), fmt::format("{:.3f}", 100.0 * trust.seen_by_rows),
          fmt::format("{:.3f}", 100.0 * trust.seen_by_rays), std::to_string(trust.rays), figure(trust.worst_deviation),
          fmt::format("{:.0f}", ClosureTrust::most_deviation)}});
    if (row.state != TrustState::fails) return row;
    const bool of_the_paper = is_of_the_paper(report.solution->settings.method);
    row.advice = {!trust.rays_agree() ? "Rays and form factors see different openings: surfaces may cross each other, "
                                        "or lie inside out."
                  : of_the_paper ? "Point to point form factors are too large where surfaces come close. Use method "
                                   "patch or linear."
                                 : "Make patches smaller where furniture stands close.",
                  {}};
    return row;
}

TrustRow additivity_row(const TrustReport& report) {
    const AdditivityTrust& trust = report.additivity;
    TrustRow row{"Additivity", "The light of half of the luminaires and that of the other half make the light of all."};
    row.state = trust.figure().state();
    if (!trust.asked()) {
        row.found = {trust.points == 0 && trust.odd > 0 && trust.even > 0 ? "There is no calculation point to look at."
                                                                          : "There is one source of light only.",
                     {}};
        return row;
    }
    const Vec3& place = trust.worst_place;
    row.found = {"{} of {} calculation points agree; worst at ({}, {}, {}): {} lx of {} lx apart",
                 {std::to_string(trust.within), std::to_string(trust.points), fmt::format("{:.2f}", place.x),
                  fmt::format("{:.2f}", place.y), fmt::format("{:.2f}", place.z), figure(trust.worst_apart),
                  figure(trust.worst_value)}};
    row.allowed = {trust.same_patches
                       ? "95 of 100 within the error bars of all three, less their mesh parts as the patches are the "
                         "same; there {} lx"
                       : "95 of 100 within the error bars of all three, each with patches of its own; there {} lx",
                   {figure(trust.worst_allowed)}};
    if (row.state == TrustState::fails)
        row.advice = {"Ask for a closer accuracy; if that does not help, report it.", {}};
    return row;
}

TrustRow threads_row(const TrustReport& report) {
    const ThreadsTrust& trust = report.threads;
    TrustRow row{"Threads", "The answer is the same to the bit on any number of threads."};
    row.state = trust.figure().state();
    row.found = {"{} of {} figures differ between {} and {} threads",
                 {std::to_string(trust.others), std::to_string(trust.values), std::to_string(trust.threads[0]),
                  std::to_string(trust.threads[1])}};
    row.allowed = {"0: sums are taken in one order", {}};
    if (row.state == TrustState::fails) row.advice = {"This is a fault of the program: please report it.", {}};
    return row;
}

}  // namespace

std::vector<TrustRow> trust_rows(const TrustReport& report) {
    using Make = TrustRow (*)(const TrustReport&);
    constexpr std::array<Make, TrustReport::checks> makers{direct_row,  energy_row,     reciprocity_row,
                                                           closure_row, additivity_row, threads_row};
    std::vector<TrustRow> rows;
    for (int k = 0; k < report.done; ++k) {
        TrustRow row = makers[static_cast<std::size_t>(k)](report);
        if (row.state == TrustState::not_asked && row.found.words.empty())
            row.found = {report.solution->refusal.empty() ? "There is no light between surfaces to look at."
                                                          : "Interreflection has no answer here.",
                         {}};
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace hanei
