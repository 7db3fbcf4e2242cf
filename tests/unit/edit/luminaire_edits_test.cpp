#include "engine/edit/luminaire_edits.h"

#include "engine/edit/edit.h"
#include "engine/edit/excerpt.h"
#include "engine/scene/intensity.h"

#include <gtest/gtest.h>
#include <numbers>

namespace hanei {
namespace {

Photometry spot(double candela) {
    Photometry photometry;
    photometry.name = "Spot";
    photometry.horizontal_deg = {0.0, 90.0};
    photometry.vertical_deg = {0.0, 90.0};
    photometry.symmetry = PhotometricSymmetry::quadrant;
    photometry.candela = {candela, candela, candela, 0.0};
    return photometry;
}

/// Two luminaires of one photometry.
struct Pair {
    Scene scene;
    ObjectId first, second;
};

Pair pair() {
    Pair made;
    Added added = with_measured_luminaire(empty_room(), spot(100.0));
    made.first = added.object;
    AddedSeveral copy = duplicated(std::move(added.scene), std::array{added.object});
    made.second = copy.objects.front();
    made.scene = std::move(copy.scene);
    return made;
}

const Photometry& photometry(const Scene& scene, ObjectId luminaire) {
    return *photometry_of(scene, *find_luminaire(scene, luminaire));
}

TEST(APhotometry, is_changed_for_all_that_share_it_or_for_one_alone) {
    const Pair made = pair();
    const Photometry turned = turned_by_a_quarter(photometry(made.scene, made.first));
    const Scene all = with_photometry(made.scene, made.first, turned, true);
    EXPECT_EQ(photometry(all, made.second).quarter_turns, 1);
    EXPECT_EQ(all.photometries.size(), 1U);
    const Scene one = with_photometry(made.scene, made.first, turned, false);
    EXPECT_EQ(photometry(one, made.first).quarter_turns, 1);
    EXPECT_EQ(photometry(one, made.second).quarter_turns, 0);
    EXPECT_EQ(one.photometries.size(), 2U);
}

TEST(APhotometry, is_used_again_when_the_scene_holds_it_already) {
    const Pair made = pair();
    const Photometry before = photometry(made.scene, made.first);
    Scene scene = with_photometry(made.scene, made.first, turned_by_a_quarter(before), false);
    scene = with_photometry(std::move(scene), made.first, before, false);
    EXPECT_EQ(scene.photometries.size(), 1U);
    EXPECT_EQ(photometry(scene, made.first).id, photometry(scene, made.second).id);
}

TEST(FourQuarterTurns, are_none) {
    Photometry turned = spot(10.0);
    for (int k = 0; k < 4; ++k) turned = turned_by_a_quarter(turned);
    EXPECT_EQ(turned, spot(10.0));
    const Pair made = pair();
    Scene scene = made.scene;
    for (int k = 0; k < 4; ++k) scene = turned_by_a_quarter(scene, made.first);
    EXPECT_NEAR(find_luminaire(scene, made.first)->yaw, 0.0, 1e-15);  // rounding of pi
}

TEST(AQuarterTurn, of_the_luminaire_leaves_its_photometry_alone) {
    const Pair made = pair();
    const Scene scene = turned_by_a_quarter(made.scene, made.first);
    EXPECT_DOUBLE_EQ(find_luminaire(scene, made.first)->yaw, 0.5 * std::numbers::pi);
    EXPECT_EQ(scene.photometries, made.scene.photometries);
    EXPECT_EQ(*find_luminaire(scene, made.second), *find_luminaire(made.scene, made.second));
}

TEST(AnotherFile, is_as_measured_again_and_drops_what_nobody_uses) {
    Pair made = pair();
    for (Luminaire& luminaire : made.scene.luminaires) luminaire.output = LuminousFlux{700.0};
    const Scene scene = with_other_file(made.scene, made.first, spot(250.0), true);
    EXPECT_EQ(scene.photometries.size(), 1U);
    EXPECT_EQ(peak_intensity(photometry(scene, made.second)).value, 250.0);
    EXPECT_TRUE(std::holds_alternative<AsMeasured>(find_luminaire(scene, made.first)->output));
}

TEST(AnotherFile, changes_the_light_colour_only_where_it_states_one) {
    Pair made = pair();
    for (Luminaire& luminaire : made.scene.luminaires) luminaire.colour_temperature = 3000.0;
    Scene scene = with_other_file(made.scene, made.first, spot(250.0), true);
    EXPECT_EQ(find_luminaire(scene, made.first)->colour_temperature, 3000.0);
    Photometry cold = spot(300.0);
    cold.lamp_sets.resize(1);
    cold.lamp_sets[0].colour = "6500";
    scene = with_other_file(std::move(scene), made.first, cold, true);
    EXPECT_EQ(find_luminaire(scene, made.second)->colour_temperature, 6500.0);
}

TEST(AnotherFile, gives_a_luminaire_of_a_formula_the_opening_of_the_file) {
    const Added added = with_panel_luminaire(empty_room());
    const Scene scene = with_other_file(added.scene, added.object, spot(250.0), true);
    const Luminaire& luminaire = *find_luminaire(scene, added.object);
    EXPECT_TRUE(std::holds_alternative<MeasuredOpening>(luminaire.opening));
    EXPECT_EQ(photometry(scene, added.object).name, "Spot");
}

}  // namespace
}  // namespace hanei
