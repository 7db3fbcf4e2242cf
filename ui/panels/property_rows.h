/// Rows that several property panels share.
#pragma once

#include "engine/scene/scene.h"
#include "ui/panels/form.h"

#include <string>

namespace hanei {

/// x, y and z of a place; `owner` is the first part of the fields' names.
bool place_rows(const std::string& owner, Vec3& place, Form& form);

/// An angle kept in radians and shown in degrees.
bool angle_row(const NumberField& field, double& radians, Form& form);

/// A share kept as 0 to 1 and shown in percent.
bool percent_row(const NumberField& field, double& share, Form& form);

/// The choice of one of the scene's materials.
bool material_row(const char* name, const char* label, const Scene& scene, ObjectId& material, Form& form);

/// One of the usual colour temperatures, or any; `neutral` is what none is called. Several kinds of
/// objects have one, so the fields' names are given.
struct LightColourRows {
    const char *choice, *temperature, *neutral;
};
bool light_colour_rows(const LightColourRows& names, double& kelvin, Form& form);

/// How a list marks a material: its colour, light enough to be seen on the ground.
ImU32 mark_of(const Material& material);

/// How a list marks a luminaire that is lit: lamp light, or the colour it has.
ImU32 mark_of(const Luminaire& luminaire, const Scene& scene);
ImU32 mark_of_light(double kelvin);  ///< of neutral light for 0

}  // namespace hanei
