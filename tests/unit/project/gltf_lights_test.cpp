#include "engine/project/gltf_lights.h"

#include "engine/project/gltf_punctual.h"
#include "engine/scene/intensity.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>

namespace hanei {
namespace {

constexpr double pi = std::numbers::pi;

/// A scene of these nodes, the first of which is its root, with a spot, a sun and a profile beside it.
std::string scene_of(const std::string& nodes) {
    return R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [)" + nodes + R"(],
        "extensions": {"KHR_lights_punctual": {"lights": [
            {"type": "spot", "intensity": 100, "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.5}},
            {"type": "directional", "intensity": 5}, {"type": "point", "intensity": 40, "range": 3}]},
          "EXT_lights_ies": {"lights": [{"uri": "a%20profile.ies"}]}}})";
}

std::string node_of(const std::string& fields, const std::string& light) {
    return "{" + fields + R"("extensions": {)" + light + "}}";
}
const std::string spot = R"("KHR_lights_punctual": {"light": 0})";
const std::string profile = R"("EXT_lights_ies": {"light": 0, "multiplier": 0.5})";

std::optional<std::string> beside(const std::string& name) {
    if (name != "a profile.ies") return std::nullopt;
    return "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 2 1 2 0 0 0\n1 1 1\n0 90\n0 90\n100 0 100 50\n";
}

GltfRead read(const std::string& text) { return read_gltf(text, "room.gltf", beside); }

std::string told(const GltfRead& read) {
    std::string text;
    for (const Diagnostic& finding : read.findings) text += to_text(finding) + '\n';
    return text;
}

void expect_vector(const Vec3& found, const Vec3& wanted) {
    EXPECT_LT(glm::distance(found, wanted), 1e-12) << found.x << ' ' << found.y << ' ' << found.z;
}

TEST(GltfLights, a_light_hangs_where_its_parents_carry_it_and_scale_dims_nothing) {
    // the parent lifts by 3 along glTF's y and doubles; the child turns its -Z to the floor
    const GltfRead found = read(scene_of(R"({"translation": [0, 3, 0], "scale": [2, 2, 2], "children": [1]},)" +
                                         node_of(R"("name": "down", "translation": [1, 0, 0.5],
                                                    "rotation": [-0.7071067811865476, 0, 0, 0.7071067811865476],)",
                                                 spot)));
    ASSERT_EQ(found.lights.size(), 1U) << told(found);
    const GltfLight& light = found.lights[0];
    EXPECT_EQ(light.luminaire.name, "down");
    expect_vector(light.position, {2, -1, 3});
    expect_vector(light.nadir, {0, 0, -1});
    expect_vector(light.plane_0, {1, 0, 0});
    EXPECT_EQ(peak_intensity(light.luminaire.photometry).value, 100.0);
}

TEST(GltfLights, the_table_of_a_spot_misses_its_falloff_by_a_ten_thousandth_of_the_peak) {
    for (const auto& [inner, outer] : {std::pair{0.2, 0.5}, std::pair{0.0, pi / 2.0}, std::pair{0.0, 1e-3},
                                       std::pair{1.2, 1.3}, std::pair{0.0, 0.7}}) {
        const Photometry table = spot_light(1000.0, inner, outer);
        double worst = 0.0;
        for (int k = 0; k <= 5000; ++k) {
            const double angle = 1.1 * outer * k / 5000;
            const double share =
                std::clamp((std::cos(angle) - std::cos(outer)) / (std::cos(inner) - std::cos(outer)), 0.0, 1.0);
            const double found = intensity(table, {std::sin(angle), 0.0, -std::cos(angle)}).value;
            worst = std::max(worst, std::abs(found - 1000.0 * share * share));
        }
        EXPECT_LE(worst, 1e-4 * 1000.0) << inner << " to " << outer;
    }
}

TEST(GltfLights, a_spot_with_a_hard_edge_fills_its_cone) {
    const Photometry table = spot_light(10.0, 0.5, 0.5);
    // flux of a cone: 2 pi I (1 - cos); the edge is a millionth of a radian wide
    EXPECT_NEAR(luminous_flux(table).value, 20.0 * pi * (1.0 - std::cos(0.5)), 1e-4);
}

TEST(GltfLights, a_point_light_sends_its_intensity_all_around) {
    EXPECT_NEAR(luminous_flux(point_light(40.0)).value, 160.0 * pi, 1e-9);
}

TEST(GltfLights, a_profile_is_found_beside_the_scene_and_multiplied) {
    const GltfRead found = read(scene_of(node_of("", profile)));
    ASSERT_EQ(found.lights.size(), 1U) << told(found);
    EXPECT_EQ(found.lights[0].luminaire.name, "node 0");
    EXPECT_EQ(peak_intensity(found.lights[0].luminaire.photometry).value, 50.0);
    EXPECT_EQ(found.lights[0].luminaire.photometry.warnings.back(), "the scene multiplies its intensities by 0.5");
}

TEST(GltfLights, a_directional_light_is_no_luminaire) {
    const GltfRead found = read(scene_of(node_of("", R"("KHR_lights_punctual": {"light": 1})")));
    EXPECT_TRUE(found.lights.empty());
    EXPECT_NE(told(found).find("1 of its lights are directional, without place or candela"), std::string::npos);
    EXPECT_NE(told(found).find("shows no point, spot or profile light"), std::string::npos);
}

TEST(GltfLights, a_mirrored_profile_is_told_and_a_mirrored_spot_is_itself) {
    const GltfRead turned = read(scene_of(node_of(R"("scale": [-1, 1, 1],)", profile)));
    ASSERT_EQ(turned.lights.size(), 1U) << told(turned);
    EXPECT_EQ(turned.lights[0].luminaire.photometry.warnings.back(), "its node is mirrored; the intensities are not");
    const GltfRead round = read(scene_of(node_of(R"("scale": [-1, 1, 1],)", spot)));
    EXPECT_TRUE(round.lights.at(0).luminaire.photometry.warnings.empty());
}

TEST(GltfLights, a_broken_light_leaves_the_others) {
    const GltfRead found = read(scene_of(
        R"({"children": [1, 2]},)" + node_of("", R"("KHR_lights_punctual": {"light": 9})") + "," + node_of("", spot)));
    EXPECT_EQ(found.lights.size(), 1U);
    EXPECT_NE(told(found).find("nodes[1].extensions.KHR_lights_punctual.light: found 9, expected a whole number from "
                               "0 to 2"),
              std::string::npos)
        << told(found);
}

TEST(GltfLights, nodes_that_go_in_a_circle_or_share_a_child_are_refused) {
    const auto refusal = [](const std::string& nodes) { return told(read(scene_of(nodes))); };
    EXPECT_NE(refusal(R"({}, {"children": [2]}, {"children": [1]})").find("node 1 is among its own"),
              std::string::npos);
    EXPECT_NE(refusal(R"({"children": [0]})").find("node 0 is among its own"), std::string::npos);
    EXPECT_NE(refusal(R"({"children": [1, 1]}, {})").find("node 1 has a parent already"), std::string::npos);
    EXPECT_NE(refusal(R"({}, {"children": [0]})").find("node 0 has a parent; a scene lists"), std::string::npos);
    EXPECT_NE(refusal(R"({"children": [-1]}, {})").find("nodes[0].children[0]: found -1"), std::string::npos);
}

TEST(GltfLights, a_node_without_extent_leaves_no_direction) {
    const GltfRead found = read(scene_of(node_of(R"("scale": [1, 1, 0],)", spot)));
    EXPECT_TRUE(found.lights.empty());
    EXPECT_NE(told(found).find("nodes[0]: its scale leaves the light no direction"), std::string::npos) << told(found);
}

TEST(GltfUris, only_files_at_or_below_the_scene_are_named) {
    EXPECT_EQ(neighbour_name("photometry/a%20b.ies"), "photometry/a b.ies");
    for (const char* const uri : {"../a.ies", "a/%2e%2e/b.ies", "/etc/passwd", "file:///etc/passwd", "http://a/b.ies",
                                  "C:\\a.ies", "a%00b", "a%2", "", "%2fetc/passwd"})
        EXPECT_FALSE(neighbour_name(uri)) << uri;
}

TEST(GltfUris, base64_data_is_decoded_whatever_it_calls_itself) {
    EXPECT_EQ(data_uri_bytes("data:text/plain;base64,aGFuZWk="), "hanei");
    EXPECT_EQ(data_uri_bytes("data:;base64,aGFuZQ"), "hane");
    EXPECT_FALSE(data_uri_bytes("data:;base64,a"));
    EXPECT_FALSE(data_uri_bytes("data:;base64,a*bc"));
    EXPECT_FALSE(data_uri_bytes("data:,hanei"));
}

}  // namespace
}  // namespace hanei
