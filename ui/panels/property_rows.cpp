#include "ui/panels/property_rows.h"

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
    int chosen = -1;
    for (const Material& entry : scene.materials) {
        if (entry.id == material) chosen = static_cast<int>(names.size());
        names.push_back(fmt::format("{} ({:.0f} %)", entry.name, 100.0 * entry.reflectance));
    }
    if (!form.choice(name, label, "Which material covers it, with its reflectance", names, chosen)) return false;
    material = scene.materials[static_cast<std::size_t>(chosen)].id;
    return true;
}

}  // namespace hanei
