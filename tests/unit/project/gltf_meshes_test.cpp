#include "engine/project/gltf_import.h"

#include <gtest/gtest.h>
#include <string>

namespace hanei {
namespace {

/// A triangle of three corners of single precision, 36 bytes, and three corners' numbers of one byte each.
struct File {
    std::string accessors = R"([{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
        {"bufferView": 0, "byteOffset": 36, "componentType": 5121, "count": 3, "type": "SCALAR"}])";
    std::string primitive = R"({"attributes": {"POSITION": 0}, "indices": 1})";
    std::string view = R"({"buffer": 0, "byteLength": 39})";
    std::string nodes = R"([{"name": "sheet", "mesh": 0}])";
    std::string more = "";
    /// (0 0 0), (1 0 0), (0 0 -1), and 0 1 2
    std::string bytes = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAAAAAIC/AAEC";

    std::string text() const {
        return R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 39, "uri": "data:;base64,)" + bytes +
               R"("}], "bufferViews": [)" + view + R"(], "accessors": )" + accessors +
               R"(, "meshes": [{"primitives": [)" + primitive + R"(]}], "nodes": )" + nodes + more + "}";
    }
};

std::string told(const GltfImport& import) {
    std::string text;
    for (const Diagnostic& finding : import.findings) text += to_text(finding) + '\n';
    return text;
}

GltfImport imported(const File& file) { return import_gltf(file.text(), "file.gltf", {}, {}); }

/// Refused with one sentence that has both in it.
void expect_refused(const File& file, const std::string& place, const std::string& words) {
    const GltfImport import = imported(file);
    EXPECT_FALSE(import.scene.has_value());
    EXPECT_NE(told(import).find(place), std::string::npos) << told(import);
    EXPECT_NE(told(import).find(words), std::string::npos) << told(import);
}

TEST(GltfMeshes, a_triangle_without_a_material_is_a_sheet_of_reflectance_one_half_with_two_sides) {
    const GltfImport import = imported({});
    ASSERT_TRUE(import.scene.has_value()) << told(import);
    ASSERT_EQ(import.scene->surfaces.size(), 2U);
    EXPECT_EQ(import.scene->surfaces[0].region.outline, (Polygon{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    ASSERT_EQ(import.scene->materials.size(), 1U);
    EXPECT_EQ(import.scene->materials[0].reflectance, 0.5);
}

TEST(GltfMeshes, counts_that_the_bytes_cannot_hold_are_refused_before_memory_is_asked_for) {
    File file;
    file.accessors = R"([{"bufferView": 0, "componentType": 5126, "count": 1000000000, "type": "VEC3"}])";
    expect_refused(file, "accessors[0].count", "found 1000000000");
    file.accessors = R"([{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}])";
    expect_refused(file, "accessors[0]", "end at byte 48 of a buffer view of 39 bytes");
}

TEST(GltfMeshes, numbers_of_vertices_that_are_not_there_are_refused) {
    File file;
    file.bytes = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAAAAAIC/AAED";  // the last is 3
    expect_refused(file, "accessors[1]", "element 2 is vertex 3, there are 3");
    file = {};
    file.primitive = R"({"attributes": {"POSITION": 7}, "indices": 1})";
    expect_refused(file, "meshes[0].primitives[0].attributes.POSITION", "found 7");
    file.primitive = R"({"attributes": {"POSITION": 0}, "indices": -1})";
    expect_refused(file, "meshes[0].primitives[0].indices", "found -1");
    file.primitive = R"({"attributes": {"POSITION": 0}, "indices": 1, "material": 0})";
    expect_refused(file, "meshes[0].primitives[0].material", "the list it counts in is empty");
}

TEST(GltfMeshes, types_that_places_cannot_have_are_refused) {
    File file;
    file.accessors = R"([{"bufferView": 0, "componentType": 5126, "count": 3, "type": "banana"}])";
    expect_refused(file, "accessors[0].type", "expected \"VEC3\" here");
    file.accessors = R"([{"bufferView": 0, "componentType": 5124, "count": 3, "type": "VEC3"}])";
    expect_refused(file, "accessors[0].componentType", "found 5124");
    file = {};
    file.view = R"({"buffer": 0, "byteLength": 39, "byteStride": 2})";
    expect_refused(file, "bufferViews[0].byteStride", "expected a number of bytes from 12");
}

TEST(GltfMeshes, places_that_are_no_numbers_or_out_of_this_world_are_refused) {
    File file;
    file.bytes = "AADAfwAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAAAAAIC/AAEC";  // the first figure is not a number
    expect_refused(file, "accessors[0]", "element 0 is nan");
    file = {};
    file.nodes = R"([{"mesh": 0, "scale": [1e9, 1, 1]}])";
    expect_refused(file, "nodes[0]", "units from the origin");
}

TEST(GltfMeshes, an_extension_that_geometry_hangs_on_is_refused_by_its_name) {
    File file;
    file.more = R"(, "extensionsRequired": ["KHR_draco_mesh_compression"])";
    expect_refused(file, "extensionsRequired[0]", "KHR_draco_mesh_compression");
    file.more = R"(, "extensionsRequired": ["KHR_materials_unlit", "KHR_texture_transform"])";
    EXPECT_TRUE(imported(file).scene.has_value());
}

TEST(GltfMeshes, materials_out_of_range_are_refused_and_images_stand_for_a_middle_grey) {
    File file;
    file.primitive = R"({"attributes": {"POSITION": 0}, "indices": 1, "material": 0})";
    file.more = R"(, "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [2, 0, 0, 1]}}])";
    expect_refused(file, "materials[0].pbrMetallicRoughness.baseColorFactor", "expected 4 figures from 0 to 1");
    file.more = R"(, "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}])";
    const GltfImport image = imported(file);
    ASSERT_TRUE(image.scene.has_value());
    EXPECT_EQ(image.scene->materials[0].reflectance, 0.5);
    EXPECT_NE(told(image).find("its colour is an image"), std::string::npos);
}

TEST(GltfMeshes, emission_counts_by_its_luminance_and_not_without_a_unit) {
    File file;
    file.primitive = R"({"attributes": {"POSITION": 0}, "indices": 1, "material": 0})";
    file.more = R"(, "materials": [{"emissiveFactor": [1, 1, 1], "extensions":
        {"KHR_materials_emissive_strength": {"emissiveStrength": 100}}}])";
    const GltfImport bright = imported(file);
    ASSERT_TRUE(bright.scene.has_value()) << told(bright);
    EXPECT_NEAR(bright.scene->surfaces[0].own_exitance.value, 314.159265, 1e-6);
    file.more = R"(, "materials": [{"emissiveFactor": [1, 1, 1]}])";
    const GltfImport dark = imported(file);
    EXPECT_EQ(dark.scene->surfaces[0].own_exitance.value, 0.0);
    EXPECT_NE(told(dark).find("in no unit"), std::string::npos);
}

TEST(GltfMeshes, a_file_without_triangles_and_lights_is_no_import) {
    File file;
    file.nodes = R"([{"name": "nothing"}])";
    expect_refused(file, "nodes", "no triangles and no lights");
}

}  // namespace
}  // namespace hanei
