#include "engine/project/reference_case.h"

#include "engine/geometry/polygon.h"
#include "engine/scene/faces.h"
#include "engine/scene/intensity.h"
#include "engine/scene/placement.h"
#include "engine/scene/scene_check.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

namespace hanei {
namespace {

const std::filesystem::path folder = std::filesystem::path(HANEI_SHARED) / "reference";

class ReferenceCases : public ::testing::Test {
protected:
    void SetUp() override {
        if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "skipped: no test data at " << folder;
    }

    static std::vector<ReferenceCase> read(const std::string& name) {
        ReferenceRead read = read_reference(folder / name);
        for (const Diagnostic& finding : read.findings)
            if (finding.severity == Severity::error) ADD_FAILURE() << to_text(finding);
        return std::move(read.cases);
    }
};

TEST_F(ReferenceCases, every_case_of_the_folder_is_read_and_makes_a_sound_scene) {
    const std::vector<std::filesystem::path> files = reference_files(folder);
    EXPECT_GE(files.size(), 61U);
    for (const std::filesystem::path& file : files) {
        const ReferenceRead read = read_reference(file);
        EXPECT_FALSE(has_errors(read.findings)) << file;
        EXPECT_FALSE(read.cases.empty()) << file;
        for (const ReferenceCase& reference : read.cases) {
            for (const Diagnostic& finding : check_scene(reference.scene))
                ADD_FAILURE() << reference.id << ": " << to_text(finding);
            const bool asks = !reference.points.empty() || !reference.form_factors.empty() || !reference.means.empty();
            EXPECT_NE(asks, !reference.unsupported.empty()) << reference.id;
        }
    }
}

TEST_F(ReferenceCases, a_file_is_its_own_list_and_index_files_are_left_out) {
    EXPECT_EQ(reference_files(folder / "P-A1.json").size(), 1U);
    for (const std::filesystem::path& file : reference_files(folder)) EXPECT_NE(file.filename(), "index.json");
}

TEST_F(ReferenceCases, coordinates_keep_their_bits) {
    const ReferenceCase far = read("P-B10.json").at(0);
    ASSERT_EQ(far.scene.luminaires.size(), 1U);
    const Luminaire& luminaire = far.scene.luminaires[0];
    const auto& outline = std::get<PolygonOpening>(luminaire.opening).region.outline;
    EXPECT_EQ(outline[0], Vec3(1048576.0, -524286.75, 262147.0));
    EXPECT_EQ(placement(luminaire).region({outline, {}}).outline, outline);
}

TEST_F(ReferenceCases, variants_become_cases_with_reflectances_of_their_own) {
    const std::vector<ReferenceCase> cases = read("P-G3.json");
    ASSERT_GE(cases.size(), 3U);
    EXPECT_EQ(cases[0].id, "P-G3 rho=0.05");
    const auto reflectance = [](const ReferenceCase& reference, std::size_t surface) {
        return find_material(reference.scene, reference.scene.surfaces[surface].material)->reflectance;
    };
    EXPECT_EQ(reflectance(cases[0], 0), 0.05);
    EXPECT_EQ(reflectance(cases[1], 5), 0.1);
    EXPECT_EQ(cases[0].points.size(), 5U);
    EXPECT_EQ(cases[0].means.size(), 6U);
    EXPECT_EQ(cases[0].means[0].top.relative, 0.001);
}

TEST_F(ReferenceCases, furnaces_carry_the_tolerance_of_their_class) {
    const ReferenceCase furnace = read("P-G2.json").at(0);
    ASSERT_EQ(furnace.means.size(), 15U);
    EXPECT_EQ(furnace.means[0].expected, 500.0);
    EXPECT_EQ(furnace.means[0].top.relative, 1e-6);
    EXPECT_EQ(furnace.means[0].pass.relative, 1e-3);
    const FreeSurface& floor = furnace.scene.surfaces[0];
    EXPECT_EQ(floor.name, "floor");
    EXPECT_EQ(floor.own_exitance.value, 400.0);
    ASSERT_EQ(floor.region.holes.size(), 1U);
    EXPECT_LT(vector_area(floor.region.holes[0]).z, 0.0);
}

TEST_F(ReferenceCases, the_mean_of_all_surfaces_together_has_no_surface) {
    const std::vector<ReferenceCase> cases = read("P-G4.json");
    ASSERT_EQ(cases.size(), 3U);
    EXPECT_EQ(cases[2].id, "P-G4 rho=0.98");
    ASSERT_EQ(cases[2].means.size(), 1U);
    EXPECT_EQ(cases[2].means[0].surface, ObjectId{});
    EXPECT_EQ(cases[2].means[0].expected, 6527.7278041950085);
}

TEST_F(ReferenceCases, occluders_are_black) {
    const ReferenceCase first = read("P-E1.json").at(0);
    ASSERT_FALSE(first.scene.surfaces.empty());
    for (const FreeSurface& surface : first.scene.surfaces)
        EXPECT_EQ(find_material(first.scene, surface.material)->reflectance, 0.0);
}

TEST_F(ReferenceCases, a_parallel_beam_makes_its_surface_shine) {
    for (const auto& [file, exitance] : {std::pair{"P-H3.json", 3000.0}, std::pair{"P-H4.json", 2457.4561328669756}}) {
        const ReferenceCase reference = read(file).at(0);
        EXPECT_TRUE(reference.scene.luminaires.empty());
        EXPECT_NEAR(reference.scene.surfaces[0].own_exitance.value, exitance, 1e-9);  // one product of figures near 1e4
    }
}

TEST_F(ReferenceCases, a_table_keeps_its_handedness) {
    // the case: 720 cd at C 0, gamma 45; 1040 cd at C 180, gamma 45 lies towards -x
    const ReferenceCase reference = read("P-A3.json").at(0);
    const Photometry& photometry = reference.scene.photometries.at(0);
    EXPECT_EQ(photometry.horizontal_deg, (std::vector<double>{0, 45, 90, 135, 180, 225, 270, 315}));
    EXPECT_DOUBLE_EQ(intensity(photometry, glm::normalize(Vec3{1, 0, -1})).value, 720.0);
    // a measuring point straight below sees 1000 cd from 2.75 m
    EXPECT_DOUBLE_EQ(reference.points[0].expected, 1000.0 / (2.75 * 2.75));
}

/// The case gives a horizontal plane under the luminaire: E = I cos / r^2 with the table alone.
TEST_F(ReferenceCases, every_point_under_a_table_is_what_its_intensity_gives) {
    const ReferenceCase reference = read("P-A3.json").at(0);
    const Luminaire& luminaire = reference.scene.luminaires.at(0);
    const Placement placed = placement(luminaire);
    for (const ReferencePoint& point : reference.points) {
        const Vec3 ray = point.position - luminaire.position;
        const Vec3 local = glm::transpose(placed.rotation) * glm::normalize(ray);
        const double illuminance = intensity(reference.scene.photometries[0], local).value *
                                   std::max(0.0, -glm::dot(glm::normalize(ray), point.normal)) / glm::dot(ray, ray);
        EXPECT_NEAR(illuminance, point.expected, 1e-9 * point.expected) << point.id;  // the case's own grade top
    }
}

TEST_F(ReferenceCases, a_polyhedron_keeps_the_luminance_of_every_face) {
    const ReferenceCase reference = read("P-D2.json").at(0);
    const Luminaire& luminaire = reference.scene.luminaires.at(0);
    const auto& solid = std::get<PolyhedronOpening>(luminaire.opening);
    EXPECT_EQ(solid.relative_luminance.size(), solid.faces.size());
    EXPECT_EQ(*std::max_element(solid.relative_luminance.begin(), solid.relative_luminance.end()), 1.0);
}

TEST_F(ReferenceCases, luminaires_of_a_furnished_scene_share_one_photometry) {
    const ReferenceCase office = read("scenes/scene_S4.json").at(0);
    EXPECT_EQ(office.scene.luminaires.size(), 48U);
    ASSERT_EQ(office.scene.photometries.size(), 1U);
    EXPECT_EQ(office.scene.photometries[0].opening.extent_0, 0.6);
    EXPECT_TRUE(office.scene.luminaires[0].opaque);
    EXPECT_EQ(std::get<LuminousFlux>(office.scene.luminaires[0].output).value, 3600.0);
    EXPECT_EQ(std::get<PolygonOpening>(office.scene.luminaires[0].opening).region.outline[0].z, 2.99);
    EXPECT_EQ(office.points[0].set, "workplane");
    EXPECT_GT(office.points[0].pass.absolute, 0.0);
}

TEST_F(ReferenceCases, form_factors_have_their_reverse_where_it_is_known) {
    const ReferenceCase first = read("P-F1.json").at(0);
    ASSERT_EQ(first.form_factors.size(), 9U);
    EXPECT_TRUE(first.form_factors[0].reverse.has_value());
    EXPECT_FALSE(read("P-F5.json").at(0).form_factors[0].reverse.has_value());
}

TEST_F(ReferenceCases, daylight_is_unsupported_with_a_reason) {
    for (const char* const file : {"P-I1.json", "P-I2.json", "P-I3.json", "P-I4.json"})
        for (const ReferenceCase& reference : read(file))
            EXPECT_EQ(reference.unsupported, "light from the sky is not simulated") << reference.id;
}

TEST(ReferenceFiles, a_missing_file_is_a_finding) {
    const ReferenceRead read = read_reference("no such case.json");
    ASSERT_EQ(read.findings.size(), 1U);
    EXPECT_EQ(to_text(read.findings[0]), "no such case.json: there is no such file");
    EXPECT_TRUE(read.cases.empty());
}

TEST(ReferenceFiles, a_scene_that_cannot_be_computed_is_refused) {
    const ReferenceRead read = read_reference_text(
        R"({"schema": "hanei-reference/1", "id": "P", "category": "a", "scene": {"surfaces": [
            {"id": "a", "vertices": [], "reflectance": 0.5},
            {"id": "b", "vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0]], "reflectance": 2}]}})",
        "case.json");
    EXPECT_TRUE(read.cases.empty());
    std::string told;
    for (const Diagnostic& finding : read.findings) told += to_text(finding) + '\n';
    EXPECT_NE(told.find("found 2, allowed are 0 to 1"), std::string::npos) << told;
    EXPECT_NE(told.find("surfaces[0]"), std::string::npos) << told;
}

}  // namespace
}  // namespace hanei
