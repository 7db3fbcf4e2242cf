#include "engine/mesh/patch_count.h"

#include "engine/mesh/mesh.h"
#include "sample_scenes.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

TEST(PatchCount, is_that_of_the_mesh_where_nothing_is_cut) {
    const Scene scene = sample::box_room(5.0, 4.0, 3.0);
    for (const double width : {0.1, 0.37, 0.5, 1.3, 20.0})
        EXPECT_EQ(patch_count(faces_of(scene), width), static_cast<double>(make_mesh(scene, width)->patches.size()));
}

TEST(PatchCount, leaves_a_width_that_makes_few_enough_as_it_is) {
    EXPECT_EQ(width_for(faces_of(sample::box_room(5.0, 4.0, 3.0)), 0.5, 1000.0), 0.5);
}

TEST(PatchCount, widens_patches_no_more_than_needed) {
    const std::vector<Face> faces = faces_of(sample::box_room(5.0, 4.0, 3.0));
    const double width = width_for(faces, 1e-4, 50'000.0);
    EXPECT_LE(patch_count(faces, width), 50'000.0);
    EXPECT_GT(patch_count(faces, 0.99 * width), 50'000.0);
}

TEST(PatchCount, ends_with_one_patch_a_face) {
    const std::vector<Face> faces = faces_of(sample::box_room(5.0, 4.0, 3.0));
    EXPECT_EQ(patch_count(faces, width_for(faces, 0.01, 3.0)), 6.0);
}

}  // namespace
}  // namespace hanei
