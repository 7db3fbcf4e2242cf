#include "engine/plan/measured_openings.h"

#include "engine/geometry/polygon.h"
#include "engine/scene/dimmers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace hanei {

namespace {

std::string distance_text(double distance) {
    if (!std::isfinite(distance)) return "at no distance";
    char text[48];
    std::snprintf(text, sizeof text, "beyond %.3g m", distance);
    return text;
}

}  // namespace

std::optional<MeasuredForm> measured_opening_of(const Scene& scene, const Luminaire& luminaire) {
    const auto* measured = std::get_if<Measured>(&luminaire.distribution);
    if (!measured) return std::nullopt;
    const auto photometry = std::ranges::find(scene.photometries, measured->photometry, &Photometry::id);
    if (photometry == scene.photometries.end() || photometry->candela.empty()) return std::nullopt;
    OpeningForm form;
    if (std::holds_alternative<MeasuredOpening>(luminaire.opening)) form = form_of(photometry->opening);
    if (const auto* flat = std::get_if<PolygonOpening>(&luminaire.opening)) form = form_of(convex_pieces(flat->region));
    if (!(form.radius > 0.0)) return std::nullopt;
    return MeasuredForm{&*photometry, form};
}

MeasuredOpenings measured_openings(const Scene& scene) {
    MeasuredOpenings found;
    std::map<ObjectId, double> points_beyond;  // of a photometry the farthest of its luminaires
    std::map<std::pair<ObjectId, double>, double> of_size;
    for (const Luminaire& luminaire : scene.luminaires) {
        if (dimming_of(scene, luminaire) <= 0.0) continue;
        const std::optional<MeasuredForm> opening = measured_opening_of(scene, luminaire);
        if (!opening) continue;
        ++found.luminaires;
        const auto& [photometry, form] = *opening;
        const auto [kept, is_new] = of_size.try_emplace({photometry->id, form.radius}, 0.0);
        if (is_new) kept->second = PointCertificate(*photometry, form).distance_for(share_left_out_by_points);
        double& beyond = points_beyond[photometry->id];
        beyond = std::max(beyond, kept->second);
    }
    if (found.luminaires == 0) return found;
    found.why = std::to_string(found.luminaires) + (found.luminaires == 1 ? " luminaire is" : " luminaires are") +
                " taken for a point only where that errs by at most 0.01 % of the peak and nothing is in the way: ";
    int listed = 0;
    for (const auto& [id, beyond] : points_beyond) {
        if (listed == 3) {
            found.why += ", and " + std::to_string(points_beyond.size() - 3) + " more";
            break;
        }
        const auto photometry = std::ranges::find(scene.photometries, id, &Photometry::id);
        const std::string& name = photometry->name.empty() ? photometry->source_file : photometry->name;
        found.why += (listed++ > 0 ? ", " : "") + name + " " + distance_text(beyond);
    }
    found.why += ". Nearer, light comes from the whole opening.";
    return found;
}

}  // namespace hanei
