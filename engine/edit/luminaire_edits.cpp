#include "engine/edit/luminaire_edits.h"

#include "engine/scene/colour.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

bool uses(const Luminaire& luminaire, ObjectId photometry) {
    const auto* measured = std::get_if<Measured>(&luminaire.distribution);
    return measured != nullptr && measured->photometry == photometry;
}

/// The luminaire and, when `all` is set, those that share its photometry.
std::vector<Luminaire*> affected(Scene& scene, ObjectId id, bool all) {
    const Luminaire* chosen = find_luminaire(scene, id);
    const auto* measured = chosen != nullptr ? std::get_if<Measured>(&chosen->distribution) : nullptr;
    const ObjectId shared = measured != nullptr ? measured->photometry : ObjectId{};
    std::vector<Luminaire*> found;
    for (Luminaire& luminaire : scene.luminaires) {
        if (luminaire.id == id || (all && shared && uses(luminaire, shared))) found.push_back(&luminaire);
    }
    return found;
}

}  // namespace

const Luminaire* find_luminaire(const Scene& scene, ObjectId id) {
    const auto found = std::find_if(scene.luminaires.begin(), scene.luminaires.end(),
                                    [&](const Luminaire& luminaire) { return luminaire.id == id; });
    return found == scene.luminaires.end() ? nullptr : &*found;
}

const Photometry* photometry_of(const Scene& scene, const Luminaire& luminaire) {
    const auto found = std::find_if(scene.photometries.begin(), scene.photometries.end(),
                                    [&](const Photometry& photometry) { return uses(luminaire, photometry.id); });
    return found == scene.photometries.end() ? nullptr : &*found;
}

int users_of(const Scene& scene, ObjectId photometry) {
    return static_cast<int>(std::count_if(scene.luminaires.begin(), scene.luminaires.end(),
                                          [&](const Luminaire& luminaire) { return uses(luminaire, photometry); }));
}

ObjectId photometry_in(Scene& scene, Photometry photometry) {
    for (const Photometry& present : scene.photometries) {
        photometry.id = present.id;
        if (present == photometry) return present.id;
    }
    photometry.id = scene.new_id();
    scene.photometries.push_back(std::move(photometry));
    return scene.photometries.back().id;
}

Scene with_photometry(Scene scene, ObjectId luminaire, Photometry photometry, bool all) {
    const std::vector<Luminaire*> changed = affected(scene, luminaire, all);
    if (changed.empty()) return scene;
    const auto* measured = std::get_if<Measured>(&changed.front()->distribution);
    const ObjectId before = measured != nullptr ? measured->photometry : ObjectId{};
    const ObjectId after = photometry_in(scene, std::move(photometry));
    for (Luminaire* each : changed) each->distribution = Measured{after};
    if (users_of(scene, before) == 0) {
        std::erase_if(scene.photometries, [&](const Photometry& present) { return present.id == before; });
    }
    return scene;
}

Scene with_other_file(Scene scene, ObjectId luminaire, Photometry photometry, bool all) {
    const std::optional<double> stated = stated_colour_temperature(photometry);
    for (Luminaire* each : affected(scene, luminaire, all)) {
        each->colour_temperature = stated.value_or(each->colour_temperature);
        if (!std::holds_alternative<Measured>(each->distribution)) each->opening = MeasuredOpening{};
        each->output = AsMeasured{};
    }
    return with_photometry(std::move(scene), luminaire, std::move(photometry), all);
}

double turned_by_a_quarter(double angle) {
    constexpr double quarter = 0.5 * std::numbers::pi;
    return std::remainder(angle + quarter, 4.0 * quarter);
}

Photometry turned_by_a_quarter(Photometry photometry) {
    photometry.quarter_turns = (photometry.quarter_turns + 1) & 3;
    return photometry;
}

Scene turned_by_a_quarter(Scene scene, ObjectId object) {
    for (Luminaire& luminaire : scene.luminaires) {
        if (luminaire.id == object) luminaire.yaw = turned_by_a_quarter(luminaire.yaw);
    }
    for (Furniture& furniture : scene.furniture) {
        if (furniture.id == object) furniture.rotation = turned_by_a_quarter(furniture.rotation);
    }
    return scene;
}

}  // namespace hanei
