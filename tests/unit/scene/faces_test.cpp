#include "engine/scene/faces.h"

#include "engine/geometry/polygon.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

namespace hanei {
namespace {

constexpr ObjectId room_id{1}, white{2}, grey{3}, desk_id{4}, screen_id{5}, door_id{6};

Room box_room() {
    Room room;
    room.id = room_id;
    room.plan = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 3.0}, {0.0, 3.0}};
    room.floor_height = 1.0;
    room.height = 2.5;
    room.floor_material = grey;
    room.ceiling_material = white;
    room.wall_materials = {white, white, grey, white};
    return room;
}

Scene furnished() {
    Scene scene;
    scene.materials = {{white, "white", 0.8, {}}, {grey, "grey", 0.3, {}}};
    scene.room = box_room();
    Furniture desk;
    desk.id = desk_id;
    desk.position = {2.0, 1.0, 1.0};
    desk.rotation = 0.3;
    desk.parts = {
        {BoxShape{{1.6, 0.8, 0.75}}, Vec3{0.0}, 0.0, grey, {}},
        {SolidShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}},
         Vec3{0.0, 0.0, 0.75},
         1.0,
         white,
         {}}};
    scene.furniture = {desk};
    FreeSurface screen;
    screen.id = screen_id;
    screen.region.outline = {{1, 1, 2}, {2, 1, 2}, {2, 1, 3}, {1, 1, 3}};
    screen.material = white;
    screen.own_exitance = {7.0};
    scene.surfaces = {screen};
    return scene;
}

Vec3 middle(const Face& face) { return centroid(face.region.outline); }

TEST(Faces, come_as_room_then_furniture_then_free_surfaces) {
    const std::vector<Face> faces = faces_of(furnished());
    ASSERT_EQ(faces.size(), 6U + 6U + 4U + 1U);
    EXPECT_EQ(faces[0].ref, (SurfaceRef{room_id, Room::floor_face}));
    EXPECT_EQ(faces[5].ref, (SurfaceRef{room_id, Room::wall_face(3)}));
    EXPECT_EQ(faces[6].ref, (SurfaceRef{desk_id, 0}));
    EXPECT_EQ(faces[12].ref, (SurfaceRef{desk_id, 6}));
    EXPECT_EQ(faces[16].ref, (SurfaceRef{screen_id, 0}));
    EXPECT_EQ(faces[16].own_exitance.value, 7.0);
}

TEST(Faces, of_a_room_look_inward) {
    const std::vector<Face> faces = faces_of(furnished());
    const Vec3 inside{2.0, 1.5, 2.25};
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_GT(glm::dot(faces[k].normal, inside - middle(faces[k])), 0.0) << "face " << k;
        EXPECT_NEAR(glm::dot(vector_area(faces[k].region), faces[k].normal),
                    k < 2        ? 12.0
                    : k % 2 == 0 ? 10.0
                                 : 7.5,
                    1e-12);  // rounding of metres
    }
    EXPECT_EQ(faces[0].normal, Vec3(0.0, 0.0, 1.0));
    EXPECT_EQ(faces[1].normal, Vec3(0.0, 0.0, -1.0));
    EXPECT_EQ(faces[2].normal, Vec3(0.0, 1.0, 0.0));  // wall 0 stands on plan[0] to plan[1]
    EXPECT_EQ(faces[4].material, grey);
}

TEST(Faces, of_a_room_close_it) {
    Scene scene = furnished();
    scene.room->plan = {{0, 0}, {5, 0}, {5, 2}, {2, 2}, {2, 4}, {0, 4}};
    scene.room->wall_materials.assign(6, white);
    Vec3 sum{0.0};
    for (const Face& face : faces_of(scene)) {
        if (face.ref.object == room_id) sum += vector_area(face.region);
    }
    EXPECT_NEAR(glm::length(sum), 0.0, 1e-12);  // the vector area of a closed surface vanishes
}

TEST(Faces, of_furniture_look_outward_and_close) {
    const Scene scene = furnished();
    const std::vector<Face> faces = faces_of(scene);
    for (const Shell& solid : shells_of(scene)) {
        Vec3 inside{0.0};
        for (const Vec3& vertex : solid.vertices) inside += vertex / static_cast<double>(solid.vertices.size());
        Vec3 sum{0.0};
        for (const Face& face : faces) {
            const int number = face.ref.face - solid.first_face;
            if (face.ref.object != solid.object || number < 0 || number >= static_cast<int>(solid.faces.size())) {
                continue;
            }
            EXPECT_LT(glm::dot(face.normal, inside - middle(face)), 0.0);
            sum += vector_area(face.region);
        }
        EXPECT_NEAR(glm::length(sum), 0.0, 1e-12);
    }
}

TEST(Faces, run_along_their_longest_edge) {
    const std::vector<Face> faces = faces_of(furnished());
    EXPECT_EQ(std::abs(faces[0].along.x), 1.0);
    EXPECT_EQ(std::abs(faces[3].along.y), 1.0);
    for (const Face& face : faces) EXPECT_NEAR(glm::dot(face.along, face.normal), 0.0, 1e-12);
}

TEST(Faces, a_door_is_measured_from_the_first_point_of_its_wall) {
    Scene scene = furnished();
    scene.room->sub_areas = {{door_id, "door", Room::wall_face(1), {0.5, 0.0}, {1.4, 2.0}, grey, {}}};
    const Face wall = faces_of(scene)[3];
    ASSERT_EQ(wall.areas.size(), 1U);
    EXPECT_EQ(wall.areas[0].sub_area, door_id);
    EXPECT_EQ(centroid(wall.areas[0].outline), Vec3(4.0, 0.95, 2.0));
    EXPECT_NEAR(glm::dot(vector_area(wall.areas[0].outline), wall.normal), 1.8, 1e-12);
}

TEST(Faces, a_board_wider_than_its_wall_ends_at_the_wall) {
    Scene scene = furnished();
    scene.room->sub_areas = {{door_id, "board", Room::wall_face(0), {-1.0, 1.0}, {9.0, 9.0}, grey, {}},
                             {door_id, "beside the wall", Room::wall_face(0), {5.0, 1.0}, {9.0, 9.0}, grey, {}}};
    const Face wall = faces_of(scene)[2];
    ASSERT_EQ(wall.areas.size(), 1U);
    EXPECT_NEAR(glm::dot(vector_area(wall.areas[0].outline), wall.normal), 4.0 * 1.5, 1e-12);
}

TEST(Faces, areas_of_floor_and_ceiling_lie_in_plan_coordinates_and_face_the_room) {
    Scene scene = furnished();
    scene.room->sub_areas = {{door_id, "carpet", Room::floor_face, {1.0, 1.0}, {2.0, 1.5}, white, {}},
                             {door_id, "skylight", Room::ceiling_face, {1.0, 1.0}, {2.0, 1.5}, white, {}}};
    const std::vector<Face> faces = faces_of(scene);
    for (const std::size_t k : {0U, 1U}) {
        ASSERT_EQ(faces[k].areas.size(), 1U);
        EXPECT_EQ(centroid(faces[k].areas[0].outline), Vec3(1.5, 1.25, k == 0 ? 1.0 : 3.5));
        EXPECT_NEAR(glm::dot(vector_area(faces[k].areas[0].outline), faces[k].normal), 0.5, 1e-15);
    }
}

TEST(Faces, without_area_or_with_missing_vertices_are_left_out_and_keep_their_neighbours_numbers) {
    Scene scene = furnished();
    auto& shape = std::get<SolidShape>(scene.furniture[0].parts[1].shape);
    shape.faces[0] = {0, 1, 1};
    shape.faces[1] = {0, 1, 99};
    const std::vector<Face> faces = faces_of(scene);
    ASSERT_EQ(faces.size(), 15U);
    EXPECT_EQ(faces[12].ref, (SurfaceRef{desk_id, 8}));
    scene.surfaces[0].region.outline[0].x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(faces_of(scene).size(), 14U);
}

TEST(Faces, a_material_is_found_by_its_id_and_a_missing_one_is_null) {
    const Scene scene = furnished();
    ASSERT_NE(find_material(scene, grey), nullptr);
    EXPECT_EQ(find_material(scene, grey)->reflectance, 0.3);
    EXPECT_EQ(find_material(scene, ObjectId{77}), nullptr);
}

TEST(Bounds, hold_room_furniture_surfaces_and_turned_luminaires) {
    Scene scene = furnished();
    Luminaire line;
    line.position = {2.0, 1.5, 5.0};
    line.yaw = std::numbers::pi / 2.0;
    line.opening = LineOpening{{-4.0, 0.0, 0.0}, {4.0, 0.0, 0.0}};
    scene.luminaires = {line};
    const Bounds bounds = bounds_of(scene);
    EXPECT_EQ(bounds.low, Vec3(0.0, -2.5, 1.0));
    EXPECT_EQ(bounds.high, Vec3(4.0, 5.5, 5.0));
}

TEST(Bounds, hold_the_opening_a_luminaire_file_states) {
    Scene scene;
    Photometry photometry;
    photometry.id = ObjectId{9};
    photometry.opening = {OpeningShape::box, 0.6, 0.4, 0.1};
    scene.photometries = {photometry};
    Luminaire luminaire;
    luminaire.opening = MeasuredOpening{};
    luminaire.distribution = Measured{ObjectId{9}};
    scene.luminaires = {luminaire};
    EXPECT_EQ(bounds_of(scene).high, Vec3(0.3, 0.2, 0.05));
}

TEST(Bounds, of_nothing_are_a_point_at_the_origin) { EXPECT_EQ(bounds_of(Scene{}).diameter(), 0.0); }

}  // namespace
}  // namespace hanei
