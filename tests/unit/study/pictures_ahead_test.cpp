#include "engine/study/study.h"
#include "tests/box_room.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace hanei {
namespace {

/// Corners of the room and of the box's top: vertices of every mesh.
const std::vector<Vec3> probes{{0.0, 0.0, 0.0}, {6.0, 4.0, 0.0}, {6.0, 0.0, 2.8}, {1.2, 1.6, 0.72}};

/// Mean light of the vertices at a place, one a face that meets there, lx.
struct Seen {
    double direct = 0.0, interreflected = 0.0;
    double total() const { return direct + interreflected; }
};
Seen seen_at(const DisplayMesh& display, const Vec3& place) {
    Seen seen;
    int count = 0;
    for (const DisplayVertex& vertex : display.vertices) {
        if (glm::distance(vertex.position, place) > 1e-6) continue;
        seen.direct += static_cast<double>(vertex.direct);
        seen.interreflected += static_cast<double>(vertex.interreflected);
        ++count;
    }
    EXPECT_GT(count, 0);
    return {seen.direct / std::max(1, count), seen.interreflected / std::max(1, count)};
}

/// Every picture of one study that follows a scene, those on the way too.
class Watched {
public:
    explicit Watched(double max_patch) { settings_.max_patch = max_patch; }

    void show(const Scene& scene, bool live) {
        const StudyRequest request{.display = true, .live = live, .mesh_error = false};
        on_way_ = 0;
        const auto note = [&](const SolutionSnapshot& solution) {
            ASSERT_TRUE(solution && solution->display);
            pictures_.push_back(solution->display);
        };
        last_.clear();
        const auto before = pictures_.size();
        const auto answer =
            study_.run(std::make_shared<const Scene>(scene), settings_, request, Work{}, [&](SolutionSnapshot part) {
                EXPECT_FALSE(part->complete);
                note(part);
            });
        on_way_ = static_cast<int>(pictures_.size() - before);
        note(answer);
        last_.assign(pictures_.begin() + static_cast<std::ptrdiff_t>(before), pictures_.end());
    }
    int on_way() const { return on_way_; }

    /// Of the pictures of the last show, none is further from its answer than the one before.
    void expect_no_way_back(const std::vector<Vec3>& places, double allowed) const {
        for (const Vec3& place : places) {
            const double final = seen_at(*last_.back(), place).total();
            double off = std::numeric_limits<double>::infinity();
            for (const auto& picture : last_) {
                const double now = std::abs(seen_at(*picture, place).total() - final);
                EXPECT_LE(now, off + allowed * final) << place.x << ' ' << place.y << ' ' << place.z;
                off = now;
            }
        }
    }
    /// Every picture shows interreflection everywhere.
    void expect_interreflection() const {
        for (const auto& picture : pictures_)
            for (const DisplayVertex& vertex : picture->vertices) ASSERT_GT(vertex.interreflected, 0.0F);
    }

private:
    Study study_;
    Settings settings_;
    std::vector<std::shared_ptr<const DisplayMesh>> pictures_, last_;
    int on_way_ = 0;
};

constexpr double unseen = 0.02;  // of the final light: no eye sees it

TEST(PicturesAhead, of_a_large_room_never_seen_come_in_wide_patches_then_fine_then_whole) {
    Watched watched(0.3);
    watched.show(test::small_office(), false);
    EXPECT_EQ(watched.on_way(), 2);
    watched.expect_no_way_back(probes, unseen);
    watched.expect_interreflection();
}

TEST(PicturesAhead, of_a_dragged_luminaire_and_of_a_dragged_box_never_go_back) {
    Watched watched(0.3);
    watched.show(test::small_office(), false);
    for (const double share : {0.2, 0.4, 0.6, 0.8, 1.0}) {
        Scene scene = test::small_office();
        scene.luminaires.front().position.x += 0.6 * share;
        watched.show(scene, true);
        watched.expect_no_way_back(probes, unseen);
    }
    std::vector<Vec3> room_corners(probes.begin(), probes.begin() + 3);
    for (const double share : {0.2, 0.4, 0.6, 0.8, 1.0}) {
        Scene scene = test::small_office();
        scene.furniture.front().position.x += 0.6 * share;
        watched.show(scene, true);
        EXPECT_GE(watched.on_way(), 1) << "patches and form factors are new: that takes long";
        watched.expect_no_way_back(room_corners, unseen);
    }
    watched.expect_interreflection();
}

TEST(PicturesAhead, of_dimmed_luminaires_keep_the_share_of_interreflection) {
    Watched watched(0.3);
    watched.show(test::small_office(), false);
    for (const double dimming : {0.8, 0.5, 0.2}) {
        Scene scene = test::small_office();
        for (Luminaire& luminaire : scene.luminaires) luminaire.dimming = dimming;
        watched.show(scene, true);
        watched.expect_no_way_back(probes, 1e-3);  // all dimmed alike: known at once
    }
    watched.expect_interreflection();
}

}  // namespace
}  // namespace hanei
