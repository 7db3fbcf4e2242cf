#include "engine/solution/shadows.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

using enum LightClass;

Shadows two_luminaires() {
    Shadows shadows;
    shadows.luminaires = {{ObjectId{4}, {lit, lit, umbra, away}, {}}, {ObjectId{9}, {lit, umbra, umbra, partly}, {}}};
    return shadows;
}

TEST(Shadows, of_one_luminaire_are_its_own_and_of_none_are_all_together) {
    EXPECT_EQ(patch_classes(two_luminaires(), ObjectId{4}, 4), (std::vector{lit, lit, umbra, away}));
    EXPECT_EQ(patch_classes(two_luminaires(), ObjectId{}, 4), (std::vector{lit, partly, umbra, partly}));
    EXPECT_EQ(patch_classes(two_luminaires(), ObjectId{77}, 4), (std::vector{lit, partly, umbra, partly}));
    EXPECT_EQ(patch_classes(Shadows{}, ObjectId{}, 2), (std::vector{away, away}));
}

TEST(Shadows, classes_are_counted_by_patches_and_area) {
    Mesh mesh;
    for (const double area : {1.0, 2.0, 4.0, 8.0}) {
        Patch patch;
        patch.area = area;
        mesh.patches.push_back(patch);
    }
    const auto shares = class_shares(mesh, {lit, umbra, lit, partly});
    EXPECT_EQ(shares[static_cast<std::size_t>(lit)].patches, 2U);
    EXPECT_EQ(shares[static_cast<std::size_t>(lit)].area, 5.0);
    EXPECT_EQ(shares[static_cast<std::size_t>(umbra)].area, 2.0);
    EXPECT_EQ(shares[static_cast<std::size_t>(partly)].area, 8.0);
    EXPECT_EQ(shares[static_cast<std::size_t>(away)].patches, 0U);
}

}  // namespace
}  // namespace hanei
