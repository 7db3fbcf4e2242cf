/// Rooms that break lighting programs: gaps and walls of a millimetre, contact, slivers, coplanar
/// surfaces, hardly any absorption.
#pragma once

#include "tests/box_room.h"

#include <ostream>
#include <string>
#include <vector>

namespace hanei::test {

struct HardRoom {
    std::string name;
    Scene scene;
    friend void PrintTo(const HardRoom& room, std::ostream* out) { *out << room.name; }
};

/// 3 x 2.4 x 2.5 m under one panel, with points on the floor, on a wall and in the air.
inline Scene lit_room(double reflectance = 0.6) {
    Scene scene = box_room({3.0, 2.4, 2.5}, reflectance);
    scene.luminaires.push_back(panel(scene, {1.4, 1.1, 2.4}, {0.8, 0.4}, 3000.0));
    scene.points = {point(scene, {0.6, 0.5, 0.0}), point(scene, {2.6, 2.1, 0.0}),
                    point(scene, {1.5, 0.0, 1.0}, {0.0, 1.0, 0.0}), point(scene, {2.2, 0.6, 0.75})};
    return scene;
}

inline void stand(Scene& scene, const Vec3& position, const Vec3& size) {
    scene.furniture.push_back(box(scene, position, size));
}

inline void hang(Scene& scene, const Polygon& outline) {
    scene.surfaces.push_back({scene.new_id(), "sheet", {outline, {}}, scene.materials.front().id, {0.0}, {}});
}

inline HardRoom boxes_a_millimetre_apart() {
    Scene scene = lit_room();
    stand(scene, {1.2, 1.2, 0.0}, {0.6, 0.6, 0.8});
    stand(scene, {1.801, 1.2, 0.0}, {0.6, 0.6, 0.8});
    return {"boxes_a_millimetre_apart", scene};
}

inline HardRoom boxes_that_touch() {
    Scene scene = lit_room();
    stand(scene, {1.2, 1.2, 0.0}, {0.6, 0.6, 0.8});
    stand(scene, {1.8, 1.2, 0.0}, {0.6, 0.4, 0.5});
    return {"boxes_that_touch", scene};
}

/// No light gets past it: half of the room is dark. The last point lies in the dark.
inline HardRoom a_wall_of_a_millimetre() {
    Scene scene = lit_room();
    stand(scene, {2.0, 1.2, 0.0}, {0.001, 2.4, 2.5});
    scene.points.push_back(point(scene, {2.002, 1.0, 0.0}));
    return {"a_wall_of_a_millimetre", scene};
}

inline HardRoom a_box_in_a_corner() {
    Scene scene = lit_room();
    stand(scene, {0.3, 0.3, 0.0}, {0.6, 0.6, 1.8});
    scene.points.front() = point(scene, {0.7, 0.2, 0.0});
    return {"a_box_in_a_corner", scene};
}

inline HardRoom walls_that_keep_nearly_all_light() { return {"walls_that_keep_nearly_all_light", lit_room(0.99)}; }

inline HardRoom boxes_stacked() {
    Scene scene = lit_room();
    stand(scene, {1.6, 1.4, 0.0}, {0.8, 0.8, 0.5});
    stand(scene, {1.6, 1.4, 0.5}, {0.5, 0.5, 0.5});
    stand(scene, {1.7, 1.5, 1.0}, {0.7, 0.2, 0.3});
    return {"boxes_stacked", scene};
}

inline HardRoom a_sheet_without_thickness() {
    Scene scene = lit_room();
    hang(scene, {{1.8, 0.6, 0.0}, {1.8, 1.8, 0.0}, {1.8, 1.8, 1.4}, {1.8, 0.6, 1.4}});
    return {"a_sheet_without_thickness", scene};
}

inline HardRoom slivers() {
    Scene scene = lit_room();
    hang(scene, {{0.2, 1.9, 0.9}, {2.8, 1.9, 0.9}, {2.8, 1.901, 0.9}});
    hang(scene, {{0.5, 0.4, 1.2}, {0.5005, 0.4, 1.2}, {0.5005, 2.0, 1.2}, {0.5, 2.0, 1.2}});
    return {"slivers", scene};
}

inline HardRoom coplanar_sheets_that_overlap() {
    Scene scene = lit_room();
    hang(scene, {{0.8, 0.6, 0.7}, {1.8, 0.6, 0.7}, {1.8, 1.4, 0.7}, {0.8, 1.4, 0.7}});
    hang(scene, {{1.4, 1.0, 0.7}, {2.4, 1.0, 0.7}, {2.4, 1.8, 0.7}, {1.4, 1.8, 0.7}});
    return {"coplanar_sheets_that_overlap", scene};
}

inline HardRoom a_sheet_listed_twice() {
    Scene scene = lit_room();
    for (int k = 0; k < 2; ++k) hang(scene, {{0.8, 0.6, 0.7}, {1.8, 0.6, 0.7}, {1.8, 1.4, 0.7}, {0.8, 1.4, 0.7}});
    return {"a_sheet_listed_twice", scene};
}

inline HardRoom a_panel_partly_inside_a_box() {
    Scene scene = lit_room();
    stand(scene, {1.8, 1.1, 1.6}, {0.6, 0.8, 0.88});
    return {"a_panel_partly_inside_a_box", scene};
}

/// A floor and two walls under the sky; most light gets out.
inline HardRoom a_room_without_ceiling_and_half_of_its_walls() {
    Scene scene = lit_room();
    scene.room.reset();
    hang(scene, {{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {3.0, 2.4, 0.0}, {0.0, 2.4, 0.0}});
    hang(scene, {{0.0, 0.0, 0.0}, {0.0, 0.0, 2.5}, {3.0, 0.0, 2.5}, {3.0, 0.0, 0.0}});
    hang(scene, {{0.0, 0.0, 0.0}, {0.0, 2.4, 0.0}, {0.0, 2.4, 2.5}, {0.0, 0.0, 2.5}});
    return {"a_room_without_ceiling_and_half_of_its_walls", scene};
}

inline HardRoom one_patch() {
    Scene scene = lit_room();
    scene.room.reset();
    hang(scene, {{0.4, 0.4, 0.0}, {0.7, 0.4, 0.0}, {0.7, 0.7, 0.0}, {0.4, 0.7, 0.0}});
    scene.points = {point(scene, {0.6, 0.5, 0.0}), point(scene, {0.6, 0.5, 0.75}, {0.0, 0.0, -1.0})};
    return {"one_patch", scene};
}

inline HardRoom no_surfaces() {
    Scene scene = lit_room();
    scene.room.reset();
    scene.materials.clear();
    return {"no_surfaces", scene};
}

inline HardRoom no_light() {
    Scene scene = boxes_stacked().scene;
    scene.luminaires.clear();
    return {"no_light", scene};
}

inline std::vector<HardRoom> hard_rooms() {
    return {boxes_a_millimetre_apart(),
            boxes_that_touch(),
            a_wall_of_a_millimetre(),
            a_box_in_a_corner(),
            walls_that_keep_nearly_all_light(),
            boxes_stacked(),
            a_sheet_without_thickness(),
            slivers(),
            coplanar_sheets_that_overlap(),
            a_sheet_listed_twice(),
            a_panel_partly_inside_a_box(),
            a_room_without_ceiling_and_half_of_its_walls(),
            one_patch(),
            no_surfaces(),
            no_light()};
}

}  // namespace hanei::test
