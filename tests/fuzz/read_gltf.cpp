#include "engine/base/check.h"
#include "engine/project/gltf_export.h"
#include "engine/project/gltf_import.h"
#include "engine/project/gltf_lights.h"
#include "engine/scene/scene_check.h"
#include "tests/fuzz/what_holds.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <iostream>

namespace {

/// A file of its own bytes lies beside every scene, so that names lead somewhere.
std::optional<std::string> profile(const std::string& name) {
    HANEI_CHECK(!name.starts_with('/') && name.find("..") == std::string::npos);
    return "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 1\n0 90\n0\n100 0\n";
}

void check_light(const hanei::GltfLight& light) {
    hanei::check_photometry(light.luminaire.photometry);
    HANEI_CHECK(!light.luminaire.name.empty());
    HANEI_CHECK(std::isfinite(glm::length(light.position)));
    constexpr double rounding = 1e-9;
    HANEI_CHECK(std::abs(glm::length(light.nadir) - 1.0) < rounding);
    HANEI_CHECK(std::abs(glm::length(light.plane_0) - 1.0) < rounding);
    HANEI_CHECK(std::abs(glm::dot(light.nadir, light.plane_0)) < rounding);
}

void check_lights(std::string_view bytes) {
    const hanei::GltfRead read = hanei::read_gltf(bytes, "file", profile);
    hanei::check_findings(read.findings, !hanei::has_errors(read.findings));
    HANEI_CHECK(!read.lights.empty() || hanei::has_errors(read.findings));
    for (const hanei::GltfLight& light : read.lights) check_light(light);
}

/// All or nothing; a scene without errors, that a project keeps; and another file of it can be read.
void check_import(std::string_view bytes, const hanei::GltfImportOptions& options) {
    const hanei::GltfImport import = hanei::import_gltf(bytes, "file", profile, options);
    hanei::check_findings(import.findings, import.scene.has_value());
    if (!import.scene) return;
    constexpr std::size_t most_faces = 60;  // more, and the checks of a scene would take all the time
    std::size_t faces = import.scene->surfaces.size();
    for (const hanei::Furniture& furniture : import.scene->furniture)
        for (const hanei::Part& part : furniture.parts)
            if (const auto* const solid = std::get_if<hanei::SolidShape>(&part.shape)) faces += solid->faces.size();
    if (faces > most_faces) return;
    for (const hanei::Diagnostic& finding : hanei::check_scene(*import.scene)) {
        if (finding.severity == hanei::Severity::error) std::cerr << hanei::to_text(finding) << '\n';
        HANEI_CHECK(finding.severity != hanei::Severity::error);
    }
    hanei::check_project({*import.scene, {}});
    const hanei::GltfImport again =
        hanei::import_gltf(hanei::gltf_file({*import.scene, {}}, nullptr, true), "again", {}, {});
    for (const hanei::Diagnostic& finding : again.findings)
        if (!again.scene) std::cerr << hanei::to_text(finding) << '\n';
    HANEI_CHECK(again.scene.has_value());
    HANEI_CHECK(*again.scene == *import.scene);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const std::string_view text = hanei::text_of(bytes, count);
    check_lights(text);
    check_import(text, {});
    check_import(text, {0.0254, hanei::GltfUpAxis::z, hanei::GltfKind::room});
    return 0;
}
