#include "ui/panels/property_rows.h"

#include "engine/scene/colour.h"
#include "engine/scene/dimmers.h"
#include "ui/panels/style.h"
#include "ui/view/tone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace hanei {
namespace {

constexpr double farthest = 1e5;  // m; beyond it millimetres are lost in display precision

}  // namespace

bool place_rows(const std::string& owner, Vec3& place, Form& form) {
    const std::string x = owner + ".x";
    const std::string y = owner + ".y";
    const std::string z = owner + ".z";
    bool changed =
        form.number({x.c_str(), "x", "m", "To the right in the plan", -farthest, farthest, 0.01, 3}, place.x);
    changed |= form.number({y.c_str(), "y", "m", "Upwards in the plan", -farthest, farthest, 0.01, 3}, place.y);
    changed |= form.number({z.c_str(), "z", "m", "Height", -farthest, farthest, 0.01, 3}, place.z);
    return changed;
}

bool angle_row(const NumberField& field, double& radians, Form& form) {
    double degrees = radians * 180.0 / std::numbers::pi;
    if (!form.number(field, degrees)) return false;
    radians = degrees * std::numbers::pi / 180.0;
    return true;
}

bool percent_row(const NumberField& field, double& share, Form& form) {
    double percent = 100.0 * share;
    if (!form.number(field, percent)) return false;
    share = percent / 100.0;
    return true;
}

bool material_row(const char* name, const char* label, const Scene& scene, ObjectId& material, Form& form) {
    std::vector<std::string> names;
    std::vector<ImU32> marks;
    int chosen = -1;
    for (const Material& entry : scene.materials) {
        if (entry.id == material) chosen = static_cast<int>(names.size());
        names.push_back(fmt::format("{} ({:.0f} %)", entry.name, 100.0 * entry.reflectance));
        marks.push_back(mark_of(entry));
    }
    if (!form.choice(name, label, "Which material covers it, with its reflectance", names, chosen, marks)) return false;
    material = scene.materials[static_cast<std::size_t>(chosen)].id;
    return true;
}

bool light_colour_rows(const LightColourRows& rows, double& kelvin, Form& form) {
    constexpr std::array usual{0.0, 2700.0, 3000.0, 4000.0, 5000.0, 6500.0};  // K
    std::vector<std::string> names;
    std::vector<ImU32> marks;
    for (const double each : usual) {
        names.push_back(each > 0.0 ? fmt::format("{:.0f} K", each) : rows.neutral);
        marks.push_back(each > 0.0 ? mark_of_light(each) : ImU32{style::text});
    }
    names.emplace_back("Other");
    marks.push_back(mark_of_light(kelvin));
    int chosen = static_cast<int>(std::find(usual.begin(), usual.end(), kelvin) - usual.begin());
    bool changed = false;
    if (form.choice(rows.choice, "Light colour",
                    "Colour temperature. Neutral light is what pictures show as white; where every luminaire has a "
                    "temperature, the mean of them is",
                    names, chosen, marks)) {
        constexpr double between_the_usual = 3500.0;
        const auto place = static_cast<std::size_t>(chosen);
        kelvin = place < usual.size() ? usual[place] : between_the_usual;
        changed = true;
    }
    if (kelvin > 0.0)
        changed |= form.number({rows.temperature, "Temperature", "K", "Colour temperature of the light",
                                lowest_colour_temperature, highest_colour_temperature, 10.0, 0},
                               kelvin);
    return changed;
}

ImU32 mark_of(const Material& material) {
    // Greys by their reflectance, so that they differ as numbers do; colours as the screen shows them.
    const Vec3 shown = material.tint == Vec3(1.0) ? Vec3(material.reflectance) : srgb_from(material);
    const auto shade = [](double share) { return static_cast<float>(0.15 + 0.8 * share); };
    return ImGui::ColorConvertFloat4ToU32({shade(shown.x), shade(shown.y), shade(shown.z), 1.0F});
}

ImU32 mark_of(const Luminaire& luminaire, const Scene& scene) {
    if (dimming_of(scene, luminaire) <= 0.0) return style::quiet_text;
    return mark_of_light(colour_temperature_of(scene, luminaire));
}

ImU32 mark_of_light(double kelvin) {
    if (kelvin <= 0.0) return style::accent;
    const glm::vec3 light(light_of_temperature(kelvin));
    const glm::vec3 shown = encoded_srgb(light / std::max({light.x, light.y, light.z}));
    return ImGui::ColorConvertFloat4ToU32({shown.x, shown.y, shown.z, 1.0F});
}

}  // namespace hanei
