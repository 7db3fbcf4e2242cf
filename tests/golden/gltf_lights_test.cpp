// glTF files with known lights, and hostile ones. They lie beside the project when present.

#include "engine/project/gltf_lights.h"

#include "engine/scene/intensity.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace hanei {
namespace {

using nlohmann::json;

const std::filesystem::path shared_folder = std::filesystem::path{HANEI_SHARED} / "photometry";

GltfRead read(const std::filesystem::path& file) {
    std::ifstream stream{file, std::ios::binary};
    const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    return read_gltf(bytes, file.string(), gltf_neighbours(file));
}

std::string told(const GltfRead& read) {
    std::string text;
    for (const Diagnostic& finding : read.findings) text += to_text(finding) + '\n';
    return text;
}

/// The expected values are in the axes of glTF: y up.
Vec3 upright(const json& v) { return {v[0].get<double>(), -v[2].get<double>(), v[1].get<double>()}; }

void expect_near(const Vec3& found, const Vec3& wanted, const std::string& what) {
    // the files hold single precision, the expected values nine digits
    EXPECT_LT(glm::distance(found, wanted), 1e-6) << what;
}

void expect_light(const GltfLight& found, const json& wanted, const std::string& what) {
    EXPECT_EQ(found.luminaire.name, wanted["name"].get<std::string>());
    expect_near(found.position, upright(wanted["position"]), what + " position");
    expect_near(found.nadir, upright(wanted["direction"]), what + " direction");
    expect_near(found.plane_0, upright(wanted["local_x"]), what + " plane 0");
    const Photometry& photometry = found.luminaire.photometry;
    const double peak = peak_intensity(photometry).value;
    if (wanted["extension"] == "EXT_lights_ies") {
        const json& profile = wanted["profile"];
        const double factor = wanted["multiplier"].get<double>();
        EXPECT_NEAR(peak, factor * profile["max_cd"].get<double>(), 1e-6) << what;
        const double flux = factor * profile["flux_lm"].get<double>();
        EXPECT_NEAR(luminous_flux(photometry).value, flux, 1e-4 * flux) << what;
    } else {
        const double candela = wanted["intensity"].get<double>();
        EXPECT_NEAR(peak, candela, 1e-8 * candela) << what;  // nine digits
    }
    if (!wanted.contains("outer") || wanted["outer"].is_null()) return;
    const auto at = [&](double angle) { return intensity(photometry, {std::sin(angle), 0.0, -std::cos(angle)}).value; };
    EXPECT_DOUBLE_EQ(at(0.999 * wanted["inner"].get<double>()), peak) << what;
    EXPECT_GT(at(0.999 * wanted["outer"].get<double>()), 0.0) << what;
    EXPECT_EQ(at(1.001 * wanted["outer"].get<double>()), 0.0) << what;
}

TEST(GltfLights, public_scenes_show_the_lights_that_are_known) {
    const std::filesystem::path index = shared_folder / "public_containers_expected.json";
    if (!std::filesystem::exists(index)) GTEST_SKIP() << "skipped: no " << index;
    std::ifstream stream{index};
    const json expected = json::parse(stream);
    int scenes = 0;
    for (const auto& [name, file] : expected["files"].items()) {
        if (!name.starts_with("gltf/")) continue;
        ++scenes;
        const GltfRead found = read(shared_folder / "public" / name);
        std::vector<json> lights;
        for (const json& light : file["lights"])
            if (light.value("type", "") != "directional") lights.push_back(light);
        ASSERT_EQ(found.lights.size(), lights.size()) << name << '\n' << told(found);
        for (std::size_t k = 0; k < lights.size(); ++k)
            expect_light(found.lights[k], lights[k], name + " light " + std::to_string(k));
        EXPECT_EQ(has_errors(found.findings), lights.empty()) << told(found);
    }
    EXPECT_EQ(scenes, 8);
}

/// Cells of a row of index.tsv: file, verdict, what is wrong, a good answer, line, field.
std::vector<std::string> cells(const std::string& row) {
    std::vector<std::string> result;
    std::istringstream stream{row};
    for (std::string cell; std::getline(stream, cell, '\t');) result.push_back(cell);
    result.resize(6);
    return result;
}

TEST(GltfLights, hostile_scenes_are_answered_in_a_sentence_with_its_place) {
    const std::filesystem::path folder = shared_folder / "malformed";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "skipped: no " << folder;
    std::ifstream index{folder / "index.tsv"};
    int scenes = 0;
    for (std::string row; std::getline(index, row);) {
        const std::vector<std::string> demand = cells(row);
        if (!demand[0].starts_with("gltf_")) continue;
        ++scenes;
        const GltfRead found = read(folder / demand[0]);
        EXPECT_EQ(found.lights.empty(), has_errors(found.findings)) << demand[0];
        EXPECT_FALSE(demand[1] == "reject" && !found.lights.empty()) << demand[0];
        // a binary file has no lines: its place is the byte
        const std::string byte = demand[0].ends_with(".glb") ? "at byte " : "";
        const bool placed = std::any_of(found.findings.begin(), found.findings.end(), [&](const Diagnostic& finding) {
            return finding.place.field.find(demand[5]) != std::string::npos &&
                   finding.message.find(byte) != std::string::npos;
        });
        EXPECT_TRUE(placed) << demand[0] << ": " << demand[5] << '\n' << told(found);
    }
    EXPECT_EQ(scenes, 14);
}

}  // namespace
}  // namespace hanei
