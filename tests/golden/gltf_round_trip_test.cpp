// Scenes written as glTF and read again are equal to what was written, in everything a scene holds.

#include "app/lit_picture.h"
#include "engine/project/gltf_export.h"
#include "engine/project/gltf_import.h"
#include "engine/project/project_file.h"
#include "engine/study/study.h"
#include "tests/unit/project/project_scene_with_everything.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

namespace hanei {
namespace {

constexpr double single = 2e-6;  // m: single precision of places some metres from their frame's origin

std::string told(const Diagnostics& findings) {
    std::string text;
    for (const Diagnostic& finding : findings) text += to_text(finding) + '\n';
    return text;
}

Scene read_room(const std::filesystem::path& file) {
    ProjectRead read = read_project(file);
    EXPECT_TRUE(read.project.has_value()) << told(read.findings);
    return read.project ? std::move(read.project->scene) : Scene{};
}

/// Written and read again.
Scene exchanged(const Scene& scene, bool binary, const LitPicture* picture = nullptr) {
    const GltfImport import = import_gltf(gltf_file({scene, {}}, picture, binary), "exchanged", {}, {});
    EXPECT_TRUE(import.scene.has_value()) << told(import.findings);
    return import.scene.value_or(Scene{});
}

/// Bit by bit; the text says where they differ.
void expect_same(const Scene& scene, const Scene& again) {
    EXPECT_EQ(project_text({again, {}}), project_text({scene, {}}));
    EXPECT_TRUE(again == scene);
}

TEST(GltfRoundTrip, every_room_of_the_project_comes_back_as_it_was) {
    int rooms = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path{HANEI_SOURCE} / "assets/rooms")) {
        if (entry.path().extension() != ".hanei") continue;
        SCOPED_TRACE(entry.path().filename().string());
        const Scene scene = read_room(entry.path());
        expect_same(scene, exchanged(scene, true));
        expect_same(scene, exchanged(scene, false));
        ++rooms;
    }
    EXPECT_GE(rooms, 4);
}

TEST(GltfRoundTrip, a_scene_with_everything_comes_back_with_everything) {
    const Scene scene = project_with_everything().scene;
    expect_same(scene, exchanged(scene, true));
    expect_same(scene, exchanged(scene, false));
}

TEST(GltfRoundTrip, imported_models_come_back_as_they_were_imported) {
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path{HANEI_SOURCE} / "tests/golden/gltf")) {
        const auto ending = entry.path().extension();
        if (ending != ".gltf" && ending != ".glb") continue;
        SCOPED_TRACE(entry.path().filename().string());
        const GltfImport import = import_gltf(entry.path(), {});
        ASSERT_TRUE(import.scene.has_value());
        expect_same(*import.scene, exchanged(*import.scene, true));
    }
}

TEST(GltfRoundTrip, every_piece_of_the_library_comes_back_as_that_piece) {
    Scene scene = empty_room();
    for (const FurnitureKind& kind : furniture_library())
        scene = with_furniture(std::move(scene), {std::string(kind.kind), {}}, ObjectId{}).scene;
    ASSERT_GT(scene.furniture.size(), 20U);
    expect_same(scene, exchanged(scene, true));
}

TEST(GltfRoundTrip, settings_come_back_with_the_scene_and_only_with_one_of_ours) {
    const Project project = project_with_everything();
    EXPECT_EQ(import_gltf(gltf_file(project, nullptr, true), "ours", {}, {}).settings, project.settings);
    const auto foreign = std::filesystem::path{HANEI_SOURCE} / "tests/golden/gltf/chair.gltf";
    EXPECT_FALSE(import_gltf(foreign, {}).settings.has_value());
}

TEST(GltfRoundTrip, a_figure_that_is_no_number_is_not_written) {
    Scene scene = empty_room();
    scene.maintenance_factor = std::numeric_limits<double>::quiet_NaN();
    const auto file = std::filesystem::path(testing::TempDir()) / "gltf without a number.glb";
    std::filesystem::remove(file);
    const auto fault = write_gltf({scene, {}}, nullptr, file);
    ASSERT_TRUE(fault.has_value());
    EXPECT_NE(fault->message.find("infinite or no number"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(GltfRoundTrip, a_lamp_moved_in_the_file_hangs_where_it_was_moved_to) {
    const Scene scene = read_room(std::filesystem::path{HANEI_SOURCE} / "assets/rooms/painted-room.hanei");
    nlohmann::json file = nlohmann::json::parse(gltf_file({scene, {}}, nullptr, false));
    for (auto& node : file["nodes"])
        if (node["extras"]["hanei"]["kind"] == "luminaire") node["translation"][1] = 1.25;
    const GltfImport import = import_gltf(file.dump(), "moved.gltf", {}, {});
    ASSERT_TRUE(import.scene.has_value()) << told(import.findings);
    ASSERT_FALSE(import.scene->luminaires.empty());
    for (std::size_t k = 0; k < scene.luminaires.size(); ++k) {
        EXPECT_EQ(import.scene->luminaires[k].position.z, 1.25);
        EXPECT_NEAR(import.scene->luminaires[k].position.x, scene.luminaires[k].position.x, single);
        EXPECT_EQ(import.scene->luminaires[k].distribution, scene.luminaires[k].distribution);
    }
}

TEST(GltfRoundTrip, a_part_of_a_project_that_names_files_is_refused) {
    const Scene scene = read_room(std::filesystem::path{HANEI_SOURCE} / "assets/rooms/painted-room.hanei");
    nlohmann::json file = nlohmann::json::parse(gltf_file({scene, {}}, nullptr, false));
    file["extras"]["hanei"]["project"]["photometries"] = {{{"id", 999}, {"name", "x"}, {"file", "../secret.ies"}}};
    const GltfImport import = import_gltf(file.dump(), "bad.gltf", {}, {});
    EXPECT_FALSE(import.scene.has_value());
    EXPECT_NE(told(import.findings).find("extras.hanei.project.photometries[0].file"), std::string::npos);
}

/// The room lit, its colours at the vertices.
LitPicture lit_room(const Scene& scene, Scale scale) {
    Study study;
    Settings settings;
    settings.max_patch = 0.5;
    const auto solution =
        study.run(std::make_shared<const Scene>(scene), settings, StudyRequest{.display = true}, Work{});
    ViewOptions look;
    look.scale = scale;
    look.range = suggested_range(*solution);
    return lit_picture(*solution, look);
}

TEST(GltfRoundTrip, the_light_is_in_the_scene_that_is_shown_first_and_the_plain_one_comes_back) {
    const Scene scene = read_room(std::filesystem::path{HANEI_SOURCE} / "assets/rooms/painted-room.hanei");
    for (const Scale scale : {Scale::photo, Scale::false_colour}) {
        const LitPicture picture = lit_room(scene, scale);
        ASSERT_FALSE(picture.surfaces.empty());
        expect_same(scene, exchanged(scene, true, &picture));
        const nlohmann::json file = nlohmann::json::parse(gltf_file({scene, {}}, &picture, false));
        EXPECT_EQ(file["scene"], 0);
        ASSERT_EQ(file["scenes"].size(), 2U);
        std::size_t coloured = 0;
        for (const auto& node : file["scenes"][0]["nodes"]) {
            const auto& object = file["nodes"][node.get<std::size_t>()];
            if (!object.contains("mesh")) continue;
            for (const auto& primitive : file["meshes"][object["mesh"].get<std::size_t>()]["primitives"])
                coloured += primitive["attributes"].contains("COLOR_0") ? 1 : 0;
        }
        EXPECT_EQ(coloured, picture.surfaces.size());
    }
}

TEST(GltfRoundTrip, colours_of_a_photo_are_those_of_the_light_and_not_all_alike) {
    const Scene scene = read_room(std::filesystem::path{HANEI_SOURCE} / "assets/rooms/painted-room.hanei");
    float low = 1.0F, high = 0.0F;
    for (const LitSurface& surface : lit_room(scene, Scale::photo).surfaces) {
        ASSERT_EQ(surface.places.size(), surface.colours.size());
        for (const auto& colour : surface.colours)
            for (const float band : colour) {
                low = std::min(low, band);
                high = std::max(high, band);
            }
    }
    EXPECT_GE(low, 0.0F);
    EXPECT_LE(high, 1.0F);
    EXPECT_GT(high - low, 0.2F);
}

}  // namespace
}  // namespace hanei
