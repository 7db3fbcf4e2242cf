/// What the materials of a glTF file mean for diffuse light.
#pragma once

#include "engine/project/gltf_document.h"
#include "engine/scene/scene.h"

namespace hanei {

/// A material, and what its surfaces do beside reflecting. Its id is the one the exporter wrote; none in
/// foreign files.
struct GltfMaterial {
    Material material;
    LuminousExitance own_exitance;
    bool two_sided = false;
};

/// materials[number] as light sees it:
///
///   - baseColorFactor, linear red, green and blue, is what all of the light that returns is coloured by,
///     whether it returns diffusely or, from metal, as from a mirror: reflectance is its luminance, the
///     rest its tint. No band reflects more than most_of_a_chosen_band.
///   - an image (baseColorTexture) is not looked at: a middle grey, half of the factor, stands for it.
///   - emissiveFactor x KHR_materials_emissive_strength is a luminance in cd/m2; times pi it is the
///     exitance. Without the extension's strength it has no unit and is left out.
///   - transparent materials are opaque.
///
/// A warning says whatever of this had to be done. Figures the exporter put beside it (gltf_export.h) are
/// taken in place of the factor that they agree with.
///
/// Needs     a number that counts a material.
/// Returns   errors for figures out of range.
GltfMaterial read_gltf_material(GltfDocument& document, std::size_t number);

/// What stands for no material: reflectance 0.5, two-sided.
GltfMaterial unstated_gltf_material();

}  // namespace hanei
