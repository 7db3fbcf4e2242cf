#include "engine/transport/visible_shares.h"

#include "engine/geometry/visible_part.h"
#include "tests/unit/mesh/sample_scenes.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace hanei {
namespace {

std::vector<Receiver> centres_of(const Mesh& mesh) {
    std::vector<Receiver> centres;
    for (const Patch& patch : mesh.patches) centres.push_back(mesh.centre_of(patch));
    return centres;
}

std::vector<float> shares_of(const Mesh& mesh, const OccluderSet& occluders, std::span<const Receiver> receivers,
                             std::size_t at_once = 16) {
    VisibleShares shares(mesh, occluders);
    std::vector<float> rows(receivers.size() * mesh.patches.size(), 1.0F);
    for (std::size_t k = 0; k < receivers.size(); k += at_once) {
        const std::size_t count = std::min(at_once, receivers.size() - k);
        shares.write(receivers.subspan(k, count), rows.data() + k * mesh.patches.size());
    }
    return rows;
}

struct Differences {
    double worst = 0.0, sum = 0.0;
    std::size_t parts = 0;  ///< patches seen in part
};

/// Of shares and the exact visible part past every body, over some receivers and all patches.
Differences compare(const Scene& scene, double max_patch, std::size_t every) {
    const auto mesh = make_mesh(scene, max_patch);
    const OccluderSet occluders = occluders_of(scene);
    std::vector<BodyIndex> all(occluders.bodies().size());
    for (BodyIndex k = 0; k < all.size(); ++k) all[k] = k;
    const std::vector<Receiver> centres = centres_of(*mesh);
    const std::vector<float> shares = shares_of(*mesh, occluders, centres);
    Differences found;
    for (std::size_t i = 0; i < centres.size(); i += every) {
        for (std::size_t j = 0; j < mesh->patches.size(); ++j) {
            const double whole = configuration_factor(mesh->patches[j].outline, centres[i]);
            if (whole < 1e-12) continue;
            const double exact =
                visible_configuration_factor(mesh->patches[j].outline, centres[i], occluders, all) / whole;
            const double off = std::abs(double{shares[i * centres.size() + j]} - exact);
            found.worst = std::max(found.worst, off);
            found.sum += off;
            found.parts += exact > 0.0 && exact < 1.0;
        }
    }
    return found;
}

/// Boxes that stand anywhere, touch or stand on one another, some made of surfaces, and free sheets.
Scene random_room(unsigned seed) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    Scene scene = sample::box_room(5.0, 4.0, 2.6);
    for (int k = 0; k < 3; ++k) {
        const Vec3 size{between(0.2, 1.2), between(0.2, 1.0), between(0.05, 1.2)};
        const Vec3 low{between(0.0, 3.5), between(0.0, 2.8), k == 0 ? 0.0 : between(0.0, 1.2)};
        sample::add_box(scene, low + Vec3{0.5 * size.x, 0.5 * size.y, 0.0}, size);
        sample::add_box(scene, low + Vec3{1.5 * size.x, 0.5 * size.y, 0.0}, size);  // beside it, touching
        const Vec3 on_top = low + Vec3{0.0, 0.0, size.z};
        sample::add_box_of_surfaces(scene, on_top, on_top + Vec3{0.5 * size.x, 0.4 * size.y, 0.02}, sample::closed_box);
    }
    return scene;
}

TEST(VisibleShares, are_those_of_the_exact_visible_part_in_rooms_of_boxes_that_touch) {
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
        const Differences off = compare(random_room(seed), 0.35, 23);
        EXPECT_GT(off.parts, 500U);
        EXPECT_LT(off.worst, 1e-4) << seed;  // of patches no nearer than twice their size (FlatView)
        EXPECT_LT(off.sum, 1e-6 * static_cast<double>(off.parts)) << seed;
    }
}

TEST(VisibleShares, do_not_depend_on_the_receivers_asked_together) {
    const Scene scene = sample::computer_room();
    const auto mesh = make_mesh(scene, 0.6);
    const OccluderSet occluders = occluders_of(scene);
    const std::vector<Receiver> centres = centres_of(*mesh);
    const std::vector<float> together = shares_of(*mesh, occluders, centres, 16);
    EXPECT_EQ(shares_of(*mesh, occluders, centres, 1), together);
    EXPECT_EQ(shares_of(*mesh, occluders, centres, 7), together);
    EXPECT_EQ(shares_of(*mesh, occluders, centres, centres.size()), together);
}

TEST(VisibleShares, rewritten_after_a_body_moved_have_the_bits_of_shares_made_from_the_start) {
    const Scene scene = sample::computer_room();
    const auto mesh = make_mesh(scene, 0.5);
    const std::vector<Receiver> centres = centres_of(*mesh);
    const OccluderSet after = occluders_of(scene);
    for (std::size_t moved = 0; moved < after.bodies().size(); moved += 5) {
        std::vector<ConvexBody> bodies(after.bodies().begin(), after.bodies().end());
        for (Vec3& vertex : bodies[moved].vertices) vertex += Vec3{0.3, 0.2, 0.0};
        const OccluderSet before(bodies), changed({bodies[moved], after.bodies()[moved]});

        std::vector<float> rows = shares_of(*mesh, before, centres);
        const std::vector<float> expected = shares_of(*mesh, after, centres);
        EXPECT_NE(rows, expected);
        VisibleShares shares(*mesh, after);
        for (std::size_t k = 0; k < centres.size(); k += 16) {
            const auto tile = std::span(centres).subspan(k, std::min<std::size_t>(16, centres.size() - k));
            shares.rewrite(tile, changed, rows.data() + k * mesh->patches.size());
        }
        EXPECT_EQ(rows, expected) << moved;
    }
}

TEST(VisibleShares, far_from_the_body_that_moved_are_left_alone) {
    const Scene scene = sample::computer_room();
    const auto mesh = make_mesh(scene, 0.5);
    const OccluderSet occluders = occluders_of(scene), none;
    ConvexBody speck{{{0.1, 0.1, 0.001}, {0.101, 0.1, 0.001}, {0.1, 0.101, 0.001}}, {{0, 1, 2}}, 0};
    const OccluderSet changed({speck});
    VisibleShares shares(*mesh, occluders);
    std::vector<float> row(mesh->patches.size(), 0.25F);  // whatever was kept
    const Receiver receiver = mesh->centre_of(mesh->patches.back());
    EXPECT_FALSE(shares.rewrite(std::span(&receiver, 1), none, row.data()));
    shares.rewrite(std::span(&receiver, 1), changed, row.data());
    EXPECT_GT(std::ranges::count(row, 0.25F), static_cast<std::ptrdiff_t>(row.size()) - 3);
}

TEST(VisibleShares, nothing_is_hidden_in_an_empty_room) {
    const Scene scene = sample::box_room(4.0, 3.0, 2.5);
    const auto mesh = make_mesh(scene, 0.5);
    const OccluderSet occluders = occluders_of(scene);
    std::vector<float> row(mesh->patches.size(), 1.0F);
    const Receiver receiver = mesh->centre_of(mesh->patches[0]);
    EXPECT_FALSE(VisibleShares(*mesh, occluders).write(std::span(&receiver, 1), row.data()));
    EXPECT_TRUE(std::ranges::all_of(row, [](float share) { return share == 1.0F; }));
}

}  // namespace
}  // namespace hanei
