#include "engine/plan/colour_reason.h"

#include "engine/scene/colour.h"
#include "engine/scene/dimmers.h"
#include "engine/scene/faces.h"

#include <cmath>
#include <set>
#include <vector>

namespace hanei {
namespace {

constexpr std::size_t most_named = 4;

/// "a", "a and b", "a, b, c, d and 3 more".
std::string listed(const std::vector<std::string>& names) {
    std::string text;
    const std::size_t shown = std::min(names.size(), most_named);
    for (std::size_t k = 0; k < shown; ++k) {
        if (k > 0) text += k + 1 == names.size() ? " and " : ", ";
        text += names[k];
    }
    if (names.size() > shown) text.append(" and ").append(std::to_string(names.size() - shown)).append(" more");
    return text;
}

std::vector<std::string> names_of(const Scene& scene, const std::vector<ObjectId>& materials) {
    std::vector<std::string> names;
    for (const ObjectId id : materials) {
        const Material* const material = find_material(scene, id);
        std::string& name = names.emplace_back("material " + std::to_string(id.value));
        if (!material->name.empty()) name.assign(1, '"').append(material->name).append(1, '"');
    }
    return names;
}

/// "neutral, 2700 K and 4000 K".
std::string temperatures_of(const Scene& scene) {
    std::set<double> kelvins;
    for (const Luminaire& lamp : scene.luminaires) kelvins.insert(colour_temperature_of(scene, lamp));
    for (const FreeSurface& surface : scene.surfaces)
        if (surface.own_exitance.value > 0.0) kelvins.insert(0.0);
    std::vector<std::string> names;
    for (const double kelvin : kelvins)
        names.push_back(kelvin > 0.0 ? std::to_string(std::lround(kelvin)) + " K" : "neutral");
    return listed(names);
}

}  // namespace

ColourReason colour_reason(const Scene& scene) {
    const std::vector<ObjectId> materials = coloured_materials(scene);
    const bool of_one_colour = is_light_of_one_colour(scene);
    if (materials.empty() && of_one_colour) {
        return {false, "All surfaces are neutral and all light is of one colour: one band stands for three."};
    }
    std::string why;
    if (!materials.empty()) why = "Surfaces have a colour (" + listed(names_of(scene, materials)) + ")";
    if (!of_one_colour) {
        why += why.empty() ? "Light" : ", and light";
        why.append(" is of several colours (").append(temperatures_of(scene)).append(")");
    }
    return {true, why + "."};
}

}  // namespace hanei
