#include "engine/base/check.h"
#include "engine/project/gltf_lights.h"
#include "tests/fuzz/what_holds.h"

#include <glm/geometric.hpp>

#include <cmath>

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

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    const hanei::GltfRead read = hanei::read_gltf(hanei::text_of(bytes, count), "file", profile);
    hanei::check_findings(read.findings, !hanei::has_errors(read.findings));
    HANEI_CHECK(!read.lights.empty() || hanei::has_errors(read.findings));
    for (const hanei::GltfLight& light : read.lights) check_light(light);
    return 0;
}
