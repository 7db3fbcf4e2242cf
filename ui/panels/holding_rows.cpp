#include "ui/panels/holding_rows.h"

#include "engine/edit/aiming.h"
#include "engine/edit/arrangements.h"
#include "engine/edit/luminaire_edits.h"
#include "engine/edit/mounting.h"
#include "ui/panels/language.h"
#include "ui/panels/property_rows.h"
#include "ui/view/pick.h"

#include <cmath>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace hanei {

std::optional<Scene> mounting_rows(const Scene& scene, std::span<const ObjectId> luminaires, Form& form) {
    const Luminaire* const first = luminaires.empty() ? nullptr : find_luminaire(scene, luminaires.front());
    if (!first || !scene.room) return std::nullopt;
    MountingWish wish = mounting_of(scene, *first);
    std::vector<std::string> names;
    for (const Mounting mounting : mountings) names.emplace_back(tr(name_of(mounting)));
    int chosen = static_cast<int>(wish.mounting);
    bool changed = false;
    if (form.choice("luminaire.mounting", "Held", "How it hangs or stands; its place and direction follow", names,
                    chosen)) {
        wish.mounting = mountings[static_cast<std::size_t>(chosen)];
        constexpr double usual_suspension = 0.5, usual_wall = 2.0, usual_stand = 1.8;  // m
        wish.suspension = usual_suspension;
        wish.height = wish.mounting == Mounting::wall ? usual_wall : usual_stand;
        changed = true;
    }
    if (wish.mounting == Mounting::pendant)
        changed |= form.number({"luminaire.suspension", "Suspension", "m", "From the ceiling to the top of its opening",
                                0.0, 1000.0, 0.01, 3},
                               wish.suspension);
    if (wish.mounting == Mounting::wall || wish.mounting == Mounting::standing)
        changed |=
            form.number({"luminaire.height", "Height", "m", "Above the floor", 0.0, 1000.0, 0.01, 3}, wish.height);
    if (!changed) return std::nullopt;
    return mounted(scene, luminaires, wish);
}

std::optional<Scene> aim_rows(const Scene& scene, std::span<const ObjectId> luminaires, Form& form) {
    const Luminaire* const first = luminaires.empty() ? nullptr : find_luminaire(scene, luminaires.front());
    if (!first) return std::nullopt;
    const Vec3 beam = beam_in_scene(scene, *first);
    const auto met = first_face(scene, Ray{first->position, beam});
    Vec3 target = met ? met->place : first->position + beam;
    for (int k = 0; k < 3; ++k) target[k] = std::round(target[k] * 1e4) / 1e4;  // as it is shown
    if (!place_rows("luminaire.aim", target, form)) return std::nullopt;
    return aimed(scene, luminaires, target);
}

}  // namespace hanei
