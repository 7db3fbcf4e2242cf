// Luminaires as other programs know them: the profiles of EXT_lights_ies that the exporter writes, read
// again, and a room that is lit by nothing else.

#include "engine/edit/intensity_of.h"
#include "engine/edit/luminaire_edits.h"
#include "engine/project/gltf_export.h"
#include "engine/project/gltf_import.h"
#include "engine/project/gltf_lights.h"
#include "engine/project/ies_profile.h"
#include "engine/project/luminaire_file.h"
#include "engine/scene/dimmers.h"
#include "engine/scene/intensity.h"
#include "engine/study/study.h"
#include "tests/unit/project/project_scene_with_everything.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>

namespace hanei {
namespace {

using json = nlohmann::ordered_json;

std::string told(const Diagnostics& findings) {
    std::string text;
    for (const Diagnostic& finding : findings) text += to_text(finding) + '\n';
    return text;
}

Project read_room(const std::string& name) {
    ProjectRead read = read_project(std::filesystem::path{HANEI_SOURCE} / "assets/rooms" / name);
    EXPECT_TRUE(read.project.has_value()) << told(read.findings);
    return read.project.value_or(Project{});
}

Photometry read_profile(const Scene& scene, const Luminaire& luminaire) {
    const LuminaireFileRead read = read_luminaire_text(ies_profile(scene, luminaire), "profile");
    EXPECT_TRUE(read.photometry.has_value()) << told(read.findings);
    EXPECT_TRUE(read.findings.empty()) << told(read.findings);
    return read.photometry.value_or(Photometry{});
}

Vec3 any_direction(std::mt19937& random) {
    std::normal_distribution<double> coordinate;
    Vec3 there{0.0};
    while (glm::length(there) < 1e-3) there = {coordinate(random), coordinate(random), coordinate(random)};
    return glm::normalize(there);
}

/// In any direction, as a share of the greatest of both.
double greatest_difference(const Scene& scene, const Luminaire& luminaire, const Photometry& profile) {
    const IntensityOf wanted(scene, luminaire);
    std::mt19937 random(1);
    double peak = 0.0, difference = 0.0;
    for (int k = 0; k < 5000; ++k) {
        const Vec3 there = any_direction(random);
        const double found = intensity(profile, there).value;
        peak = std::max({peak, found, wanted(there)});
        difference = std::max(difference, std::abs(found - wanted(there)));
    }
    return peak > 0.0 ? difference / peak : 0.0;
}

TEST(GltfProfiles, of_measured_luminaires_are_their_own_tables) {
    const Project office = read_room("office.hanei");
    int measured = 0;
    for (const Luminaire& luminaire : office.scene.luminaires) {
        const Photometry* const table = photometry_of(office.scene, luminaire);
        if (table == nullptr) continue;
        ++measured;
        const Photometry profile = read_profile(office.scene, luminaire);
        EXPECT_LT(greatest_difference(office.scene, luminaire, profile), 2e-7) << luminaire.name;  // digits written
        EXPECT_EQ(profile.opening.shape, table->opening.shape);
    }
    EXPECT_GE(measured, 10);
}

TEST(GltfProfiles, of_every_other_kind_send_the_same_light_in_every_direction) {
    Scene scene = project_with_everything().scene;
    Photometry& table = scene.photometries[0];  // one that means something in all directions
    table.type = PhotometricType::B;
    table.symmetry = PhotometricSymmetry::none;
    table.horizontal_deg = {-90, -45, 0, 45, 90};
    table.vertical_deg = {-90, 0, 90};
    table.candela = {0, 0, 0, 0, 300, 0, 0, 900, 0, 0, 200, 0, 0, 0, 0};
    table.tilt.reset();
    for (const Luminaire& luminaire : scene.luminaires) {
        SCOPED_TRACE(luminaire.id.value);
        const Photometry profile = read_profile(scene, luminaire);
        // at the folds of the table of type B a share of the step of 2.5 degrees; smooth curves miss less
        EXPECT_LT(greatest_difference(scene, luminaire, profile), 0.03);
        const double flux = IntensityOf(scene, luminaire).flux();
        EXPECT_NEAR(luminous_flux(profile).value, flux, 3e-3 * flux);
    }
}

TEST(GltfProfiles, of_turned_and_halved_tables_are_written_all_around) {
    Scene scene;
    Photometry table;
    table.id = scene.new_id();
    table.horizontal_deg = {90, 180, 270};
    table.vertical_deg = {10, 45, 85};
    table.candela = {900, 500, 30, 700, 300, 20, 400, 200, 10};
    table.symmetry = PhotometricSymmetry::plane_90;
    table.quarter_turns = 1;
    scene.photometries.push_back(table);
    Luminaire luminaire;
    luminaire.opening = MeasuredOpening{};
    luminaire.distribution = Measured{table.id};
    luminaire.output = AsMeasured{};
    const Photometry profile = read_profile(scene, luminaire);
    EXPECT_EQ(profile.vertical_deg, (std::vector<double>{0, 9.99, 10, 45, 85, 85.01, 90}));
    std::mt19937 random(2);
    for (int k = 0; k < 2000; ++k) {
        const Vec3 there = any_direction(random);
        const double gamma = photometric_angles(PhotometricType::C, there).vertical_deg;
        if (std::abs(gamma - 10.0) < 0.02 || std::abs(gamma - 85.0) < 0.02) continue;  // where it goes dark at once
        EXPECT_NEAR(intensity(profile, there).value, intensity(table, there).value, 1e-3);
    }
}

/// The file as a program leaves it that keeps no extras: meshes, materials and lights alone.
Project without_extras(const Project& project) {
    json file = json::parse(gltf_file(project, nullptr, false));
    file.erase("extras");
    for (const char* const list : {"nodes", "materials"})
        for (json& each : file[list]) each.erase("extras");
    const GltfImport import = import_gltf(file.dump(), "bare.gltf", {}, {});
    EXPECT_TRUE(import.scene.has_value()) << told(import.findings);
    Project bare{import.scene.value_or(Scene{}), project.settings};
    bare.scene.grids = project.scene.grids;
    return bare;
}

TEST(GltfProfiles, hang_each_luminaire_once_at_what_it_burns_at) {
    Project office = read_room("office.hanei");
    office.scene.maintenance_factor = 0.8;
    office.scene.luminaires[0].dimming = 0.25;
    const Project bare = without_extras(office);
    ASSERT_EQ(bare.scene.luminaires.size(), office.scene.luminaires.size());
    for (std::size_t k = 0; k < office.scene.luminaires.size(); ++k) {
        const Luminaire& was = office.scene.luminaires[k];
        const double burning = IntensityOf(office.scene, was).flux() * dimming_of(office.scene, was) * 0.8;
        EXPECT_NEAR(IntensityOf(bare.scene, bare.scene.luminaires[k]).flux(), burning, 1e-5 * burning) << was.name;
        EXPECT_LT(glm::distance(bare.scene.luminaires[k].position, was.position), 2e-6) << was.name;
    }
}

std::vector<double> means_of(const Project& project) {
    Study study;
    const auto solution =
        study.run(std::make_shared<const Scene>(project.scene), project.settings, {}, Work{2, {}, nullptr});
    std::vector<double> means;
    for (const GridResult& grid : solution->grids) means.push_back(figures_of(grid).mean);
    return means;
}

TEST(GltfProfiles, light_the_office_alike_even_where_nothing_else_of_it_was_kept) {
    Project office = read_room("office.hanei");
    office.settings.max_patch = 1.0;
    const std::vector<double> wanted = means_of(office);
    const std::vector<double> found = means_of(without_extras(office));
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t k = 0; k < wanted.size(); ++k)
        EXPECT_NEAR(found[k], wanted[k], 0.01 * wanted[k]) << office.scene.grids[k].name;
}

TEST(GltfProfiles, a_room_that_came_back_is_lit_bit_by_bit_as_it_was) {
    const Project room = read_room("painted-room.hanei");
    const GltfImport import = import_gltf(gltf_file(room, nullptr, true), "room.glb", {}, {});
    ASSERT_TRUE(import.scene && import.settings);
    EXPECT_EQ(means_of({*import.scene, *import.settings}), means_of(room));
}

}  // namespace
}  // namespace hanei
