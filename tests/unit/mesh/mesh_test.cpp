#include "engine/mesh/mesh.h"

#include "engine/geometry/polygon.h"
#include "engine/mesh/cells.h"
#include "tests/unit/mesh/sample_scenes.h"
#include "tests/unit/mesh/sound_mesh.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace hanei {
namespace {

/// Index of the face of an object; -1 when the mesh lacks it.
int face_of(const Mesh& mesh, ObjectId object, int face) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        if (mesh.faces[f].face.ref == SurfaceRef{object, face}) return static_cast<int>(f);
    }
    return -1;
}

/// The face of an object whose normal is nearest to a direction.
std::size_t face_towards(const Mesh& mesh, ObjectId object, const Vec3& direction) {
    std::size_t best = 0;
    double cosine = -2.0;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        if (mesh.faces[f].face.ref.object != object) continue;
        if (glm::dot(mesh.faces[f].face.normal, direction) <= cosine) continue;
        best = f;
        cosine = glm::dot(mesh.faces[f].face.normal, direction);
    }
    return best;
}

TEST(Mesh, the_number_of_patches_follows_equation_5_and_is_never_zero) {
    EXPECT_EQ(patches_along(8.0, 0.5), 16);
    EXPECT_EQ(patches_along(1.2, 0.5), 2);
    EXPECT_EQ(patches_along(1.3, 0.5), 3);
    EXPECT_EQ(patches_along(0.2, 0.5), 1);
}

TEST(Mesh, crowded_lines_are_as_many_and_nearer_to_each_other_towards_both_ends) {
    for (const double wished : {0.11, 0.5, 0.9, 2.0, 9.0}) {
        const std::vector<double> even = grid_lines(-1.0, 4.0, wished, Grading::uniform);
        const std::vector<double> crowded = grid_lines(-1.0, 4.0, wished, Grading::crowded);
        ASSERT_EQ(crowded.size(), even.size());
        EXPECT_EQ(crowded.front(), -1.0);
        EXPECT_EQ(crowded.back(), 4.0);
        for (std::size_t k = 1; k < crowded.size(); ++k) {
            EXPECT_GT(crowded[k], crowded[k - 1]);
            const std::size_t mirrored = crowded.size() - 1 - k;
            EXPECT_NEAR(crowded[k] - -1.0, 4.0 - crowded[mirrored], 1e-14);  // rounding of coordinates of 4 m
            if (2 * k + 1 >= crowded.size()) continue;
            EXPECT_LT(crowded[k] - crowded[k - 1], (crowded[k + 1] - crowded[k]) * (1.0 + 1e-12));
        }
    }
}

TEST(Mesh, a_crowded_room_has_as_many_patches_and_the_same_area) {
    const auto mesh = make_mesh(sample::box_room(8.0, 6.0, 3.0), 0.5, Grading::crowded);
    EXPECT_EQ(mesh->patches.size(), 2U * (16 * 12 + 16 * 6 + 12 * 6));
    EXPECT_NEAR(area_of(*mesh, 0), 48.0, rounding);
    expect_sound(*mesh);
    expect_sound(*make_mesh(sample::computer_room(), 0.4, Grading::crowded));
}

TEST(Mesh, an_empty_room_has_the_patches_of_its_grids) {
    const auto mesh = make_mesh(sample::box_room(8.0, 6.0, 3.0), 0.5);
    EXPECT_EQ(mesh->patches.size(), 2U * (16 * 12 + 16 * 6 + 12 * 6));
    EXPECT_EQ(mesh->vertices.size(), 2U * (17 * 13 + 17 * 7 + 13 * 7));
    EXPECT_EQ(mesh->faces[0].rows.size(), 13U);
    expect_sound(*mesh);
}

TEST(Mesh, a_box_on_the_floor_takes_its_footprint_and_loses_its_bottom) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    const ObjectId box = sample::add_box(scene, {1.37, 1.21, 0.0}, {0.6, 0.4, 0.7}, 0.3);
    const auto mesh = make_mesh(scene, 0.5);
    EXPECT_NEAR(area_of(*mesh, 0), 12.0 - 0.24, rounding);
    EXPECT_EQ(mesh->faces[face_towards(*mesh, box, {0.0, 0.0, -1.0})].patch_count, 0U);
    EXPECT_NEAR(area_of(*mesh, face_towards(*mesh, box, {0.0, 0.0, 1.0})), 0.24, rounding);
    expect_sound(*mesh);
}

TEST(Mesh, a_part_that_is_not_convex_covers_what_it_stands_on_and_nothing_of_itself) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    const ObjectId shelf = sample::add_l_shape(scene, {1, 1, 0}, 0.7);
    const std::shared_ptr<const Mesh> mesh = make_mesh(scene, 0.3);
    expect_sound(*mesh);
    constexpr double plan = 1.2 * 0.5 + 0.5 * 0.5;
    EXPECT_NEAR(area_of(*mesh, 0), 4.0 * 3.0 - plan, rounding);
    EXPECT_NEAR(area_of(*mesh, static_cast<std::size_t>(face_of(*mesh, shelf, 1))), plan, rounding);
    const int underside = face_of(*mesh, shelf, 0);
    EXPECT_TRUE(underside < 0 || area_of(*mesh, static_cast<std::size_t>(underside)) < rounding);
    double sides = 0.0;
    for (int k = 2; k < 8; ++k) sides += area_of(*mesh, static_cast<std::size_t>(face_of(*mesh, shelf, k)));
    EXPECT_NEAR(sides, (1.2 + 1.0) * 2.0 * 0.7, rounding);
}

TEST(Mesh, a_box_a_millimetre_above_another_covers_nothing) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    const ObjectId low = sample::add_box(scene, {1.0, 1.0, 0.0}, {0.5, 0.5, 0.5});
    const ObjectId high = sample::add_box(scene, {1.0, 1.0, 0.501}, {0.5, 0.5, 0.5});
    const auto mesh = make_mesh(scene, 0.5);
    EXPECT_NEAR(area_of(*mesh, face_towards(*mesh, low, {0.0, 0.0, 1.0})), 0.25, rounding);
    EXPECT_NEAR(area_of(*mesh, face_towards(*mesh, high, {0.0, 0.0, -1.0})), 0.25, rounding);
}

TEST(Mesh, stacked_boxes_cover_each_other_where_they_touch) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    const ObjectId low = sample::add_box(scene, {1.0, 1.0, 0.0}, {1.0, 0.5, 0.5});
    const ObjectId high = sample::add_box(scene, {1.3, 1.0, 0.5}, {0.8, 0.3, 0.5});
    const auto mesh = make_mesh(scene, 0.3);
    EXPECT_NEAR(area_of(*mesh, face_towards(*mesh, low, {0.0, 0.0, 1.0})), 0.5 - 0.6 * 0.3, rounding);
    EXPECT_NEAR(area_of(*mesh, face_towards(*mesh, high, {0.0, 0.0, -1.0})), 0.24 - 0.6 * 0.3, rounding);
    expect_sound(*mesh);
}

TEST(Mesh, a_solid_through_the_wall_of_another_covers_what_is_inside) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    const ObjectId big = sample::add_box(scene, {1.0, 1.0, 0.0}, {1.0, 1.0, 1.0});
    const ObjectId stick = sample::add_box(scene, {1.5, 1.0, 0.4}, {0.6, 0.1, 0.1});
    const auto mesh = make_mesh(scene, 0.5);
    EXPECT_NEAR(area_of(*mesh, face_towards(*mesh, big, {1.0, 0.0, 0.0})), 1.0 - 0.01, rounding);
    EXPECT_NEAR(area_of(*mesh, face_towards(*mesh, stick, {0.0, 0.0, 1.0})), 0.03, rounding);
    EXPECT_EQ(mesh->faces[face_towards(*mesh, stick, {-1.0, 0.0, 0.0})].patch_count, 0U);
}

TEST(Mesh, boxes_without_bottoms_and_legs_without_ends_cover_what_they_touch) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    sample::add_box_of_surfaces(scene, {1.0, 1.0, 0.0}, {1.05, 1.7, 0.69}, sample::sides_only);
    sample::add_box_of_surfaces(scene, {0.9, 0.9, 0.69}, {2.0, 1.8, 0.72}, sample::closed_box);
    sample::add_box_of_surfaces(scene, {1.2, 1.2, 0.72}, {1.6, 1.6, 1.1}, sample::without_bottom);
    const auto mesh = make_mesh(scene, 0.5);
    EXPECT_NEAR(area_of(*mesh, 0), 12.0 - 0.05 * 0.7, rounding);
    const std::size_t desk = 6 + 4;  // after the room's faces and the leg's sides
    EXPECT_NEAR(area_of(*mesh, desk), 1.1 * 0.9 - 0.05 * 0.7, rounding);
    EXPECT_NEAR(area_of(*mesh, desk + 1), 1.1 * 0.9 - 0.16, rounding);
    expect_sound(*mesh);
}

TEST(Mesh, a_sub_area_has_its_own_material_and_the_later_one_is_seen) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    const ObjectId door = sample::material(scene, 0.1);
    const ObjectId pane = sample::material(scene, 0.9);
    scene.room->sub_areas.push_back({scene.new_id(), "door", Room::wall_face(0), {1.1, 0.0}, {2.0, 2.1}, door, {}});
    scene.room->sub_areas.push_back({scene.new_id(), "pane", Room::wall_face(0), {1.3, 1.0}, {1.8, 1.9}, pane, {}});
    const auto mesh = make_mesh(scene, 0.5);
    std::map<ObjectId, double> areas;
    const int wall = face_of(*mesh, scene.room->id, Room::wall_face(0));
    ASSERT_GE(wall, 0);
    for (const Patch& patch : mesh->patches) {
        if (patch.face == static_cast<std::uint32_t>(wall)) areas[patch.material] += patch.area;
    }
    EXPECT_NEAR(areas[pane], 0.45, rounding);
    EXPECT_NEAR(areas[door], 0.9 * 2.1 - 0.45, rounding);
    EXPECT_NEAR(area_of(*mesh, static_cast<std::size_t>(wall)), 10.0, rounding);
    expect_sound(*mesh);
}

TEST(Mesh, reflectance_runs_tell_a_row_as_the_grid_points_do) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    const ObjectId board = sample::material(scene, 0.1);
    scene.room->sub_areas.push_back({scene.new_id(), "board", Room::floor_face, {1.0, 0.0}, {2.5, 3.0}, board, {}});
    const auto mesh = make_mesh(scene, 0.5);
    const VertexRow& row = mesh->faces[0].rows[2];
    const std::vector<ReflectanceRun> runs = reflectance_runs(*mesh, scene, row);
    ASSERT_EQ(runs.size(), 3U);
    EXPECT_EQ(runs.front().first, 0U);
    EXPECT_EQ(runs.back().last, row.vertices.size() - 1);
    EXPECT_EQ(runs[1].reflectance, 0.1);
    EXPECT_EQ(runs[0].last + 1, runs[1].first);
    const std::vector<double> all = vertex_reflectances(*mesh, scene);
    for (const ReflectanceRun& run : runs) {
        for (std::uint32_t k = run.first; k <= run.last; ++k) {
            EXPECT_EQ(all[static_cast<std::size_t>(row.vertices[k])], run.reflectance);
        }
    }
}

TEST(Mesh, an_l_shaped_floor_keeps_its_area_and_its_whole_cells) {
    const auto mesh = make_mesh(sample::l_room(), 0.5);
    EXPECT_NEAR(area_of(*mesh, 0), 4.0 * 1.5 + 1.5 * 2.5, rounding);
    EXPECT_EQ(mesh->faces[0].patch_count, 39U);  // 9.75 m2 in squares of 0.5 m
    expect_sound(*mesh);
}

TEST(Mesh, vertices_on_a_border_look_inward) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    sample::add_box(scene, {2.0, 1.5, 0.0}, {1.0, 1.0, 1.0});
    const auto mesh = make_mesh(scene, 0.5);
    const MeshFace& floor = mesh->faces[0];
    for (std::uint32_t k = 0; k < floor.vertex_count; ++k) {
        const Receiver& r = mesh->vertices[floor.first_vertex + k].receiver;
        const auto [x, y, z] = std::tuple(r.position.x, r.position.y, r.position.z);
        const double to_wall = std::min(std::min(x, 4.0 - x), std::min(y, 3.0 - y));
        const double off_box = std::max(std::abs(x - 2.0), std::abs(y - 1.5)) - 0.5;
        if (to_wall < 1e-6 || off_box < 1e-6) {
            ASSERT_NEAR(glm::length(r.inward), 1.0, 1e-12);
            const Vec3 step = r.position + 0.01 * r.inward;
            EXPECT_TRUE(step.x > 0.0 && step.x < 4.0 && step.y > 0.0 && step.y < 3.0);
            EXPECT_GT(std::max(std::abs(step.x - 2.0), std::abs(step.y - 1.5)), 0.5);
            EXPECT_EQ(step.z, z);
        } else {
            EXPECT_EQ(r.inward, Vec3(0.0));
        }
    }
}

TEST(Mesh, the_border_of_a_straight_edge_looks_straight_inward) {
    const auto mesh = make_mesh(sample::box_room(4.0, 3.0, 2.5), 0.5);
    const LocatedReceiver on_edge = locate(*mesh, {1.25, 0.0, 0.0}, {0.0, 0.0, 1.0});
    EXPECT_EQ(on_edge.face, 0);
    EXPECT_NEAR(glm::length(on_edge.receiver.inward - Vec3(0.0, 1.0, 0.0)), 0.0, 1e-12);
    const LocatedReceiver in_corner = locate(*mesh, {0.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
    EXPECT_NEAR(glm::length(in_corner.receiver.inward - glm::normalize(Vec3(1.0, 1.0, 0.0))), 0.0, 1e-12);
    EXPECT_EQ(locate(*mesh, {1.3, 1.1, 0.0}, {0.0, 0.0, 1.0}).receiver.inward, Vec3(0.0));
    EXPECT_EQ(locate(*mesh, {1.3, 1.1, 0.8}, {0.0, 0.0, 1.0}).face, -1);
    EXPECT_EQ(locate(*mesh, {1.3, 1.1, 0.0}, {0.0, 0.0, -1.0}).face, -1);
}

TEST(Mesh, a_hole_in_a_free_surface_stays_open) {
    Scene scene;
    const ObjectId plate = sample::add_surface(scene, {{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}});
    scene.surfaces.back().region.holes.push_back({{1, 0.5, 0}, {1, 1.5, 0}, {2, 1.5, 0}, {2, 0.5, 0}});
    const auto mesh = make_mesh(scene, 0.4);
    EXPECT_NEAR(area_of(*mesh, 0), 5.0, rounding);
    EXPECT_EQ(mesh->faces[0].face.ref.object, plate);
    expect_sound(*mesh);
}

TEST(Mesh, no_patch_lies_on_both_sides_of_a_screen_that_stands_on_it) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    sample::add_surface(scene, {{1.75, 1.0, 0.0}, {1.75, 2.1, 0.0}, {1.75, 2.1, 1.4}, {1.75, 1.0, 1.4}});
    const auto mesh = make_mesh(scene, 0.5);
    EXPECT_NEAR(area_of(*mesh, 0), 12.0, rounding);
    for (const Patch& patch : mesh->patches) {
        if (patch.face != 0 || patch.centre.y < 1.0 || patch.centre.y > 2.0) continue;
        const auto [low, high] = std::minmax_element(patch.outline.begin(), patch.outline.end(),
                                                     [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
        EXPECT_FALSE(low->x < 1.75 - 1e-6 && high->x > 1.75 + 1e-6);
    }
    expect_sound(*mesh);
}

TEST(Mesh, an_opaque_opening_flush_with_the_ceiling_covers_it) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    Luminaire panel;
    panel.id = scene.new_id();
    panel.position = {2.0, 1.5, 2.5};
    panel.opening = PolygonOpening{{{{-0.6, -0.3, 0}, {-0.6, 0.3, 0}, {0.6, 0.3, 0}, {0.6, -0.3, 0}}, {}}};
    scene.luminaires.push_back(panel);
    EXPECT_NEAR(area_of(*make_mesh(scene, 0.5), 1), 12.0, rounding);
    scene.luminaires.back().opaque = true;
    EXPECT_NEAR(area_of(*make_mesh(scene, 0.5), 1), 12.0 - 0.72, rounding);
}

TEST(Mesh, no_patch_of_a_ceiling_lies_half_under_an_opaque_opening_just_below_it) {
    Scene scene = sample::box_room(4.0, 3.0, 2.5);
    Luminaire panel;
    panel.id = scene.new_id();
    panel.opening = PolygonOpening{{{{-0.6, -0.3, 0}, {-0.6, 0.3, 0}, {0.6, 0.3, 0}, {0.6, -0.3, 0}}, {}}};
    panel.opaque = true;
    const auto patches_across = [&](double below_ceiling) {
        scene.luminaires.assign(1, panel);
        scene.luminaires[0].position = {2.0, 1.5, 2.5 - below_ceiling};
        const auto mesh = make_mesh(scene, 0.7);
        EXPECT_NEAR(area_of(*mesh, 1), 12.0, rounding);
        expect_sound(*mesh);
        int across = 0;
        for (const Patch& patch : mesh->patches) {
            bool under = false, beside = false;
            for (const Vec3& corner : patch.outline) {
                const double outside = std::max(std::abs(corner.x - 2.0) - 0.6, std::abs(corner.y - 1.5) - 0.3);
                under = under || outside < -1e-6;
                beside = beside || outside > 1e-6;
            }
            if (patch.face == 1 && under && beside) ++across;
        }
        return across;
    };
    EXPECT_EQ(patches_across(0.01), 0);
    EXPECT_GT(patches_across(0.2), 0);  // its shadow there is soft
}

TEST(Mesh, a_furnished_room_is_sound) { expect_sound(*make_mesh(sample::computer_room(), 0.4)); }

}  // namespace
}  // namespace hanei
