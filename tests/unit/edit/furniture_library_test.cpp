#include "engine/edit/furniture_library.h"

#include "engine/edit/furniture_edits.h"
#include "engine/edit/material_palette.h"
#include "engine/scene/scene_check.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace hanei {
namespace {

/// A hall that every piece fits into.
Scene hall() {
    Scene scene = empty_room();
    scene.room->plan = {{-20.0, -20.0}, {20.0, -20.0}, {20.0, 20.0}, {-20.0, 20.0}};
    scene.room->height = 31.0;
    return scene;
}

FurnitureModel model_of(const FurnitureKind& kind) { return {std::string(kind.kind), {}}; }

bool touch(const Bounds& a, const Bounds& b) {
    constexpr double crack = 1e-9;  // m: a thousand times what rounding to the picometre leaves
    return glm::all(glm::lessThanEqual(a.low, b.high + Vec3{crack})) &&
           glm::all(glm::lessThanEqual(b.low, a.high + Vec3{crack}));
}

/// Parts that neither stand on the floor nor touch one that does, over whatever others.
int loose_parts(const Furniture& furniture) {
    std::vector<Bounds> loose, held;
    for (const Part& part : furniture.parts) {
        Furniture alone;
        alone.parts = {part};
        const Bounds bounds = own_bounds(alone);
        (bounds.low.z <= 0.0 ? held : loose).push_back(bounds);
    }
    for (std::size_t next = 0; next < held.size(); ++next) {
        const auto rest = std::stable_partition(loose.begin(), loose.end(),
                                                [&](const Bounds& bounds) { return !touch(bounds, held[next]); });
        const std::vector<Bounds> won(rest, loose.end());
        loose.erase(rest, loose.end());
        held.insert(held.end(), won.begin(), won.end());
    }
    return static_cast<int>(loose.size());
}

void expect_sound(const FurnitureModel& model) {
    if (model.kind == "box") return;  // as large as a building, by right
    const Added added = with_furniture(hall(), model, {0.0, 0.0, 0.0});
    std::string sizes;
    for (const ModelSize& size : model.sizes) sizes += size.name + " " + std::to_string(size.metres) + ", ";
    for (const Diagnostic& finding : check_scene(added.scene))
        EXPECT_EQ(finding.severity, Severity::note) << model.kind << " " << sizes << to_text(finding);
    const Bounds bounds = own_bounds(added.scene.furniture.back());
    EXPECT_NEAR(bounds.low.z, 0.0, 1e-9) << model.kind << " " << sizes;  // a nanometre: figures are rounded to 1e-12
    EXPECT_LT(std::abs(bounds.low.x + bounds.high.x), 0.15 * (bounds.high.x - bounds.low.x)) << model.kind;
    EXPECT_EQ(loose_parts(added.scene.furniture.back()), 0) << model.kind << " " << sizes;
    EXPECT_TRUE(follows_model(added.scene.furniture.back()));
}

TEST(TheFurnitureLibrary, holds_twenty_kinds_with_names_of_their_own) {
    std::set<std::string_view> kinds, labels;
    for (const FurnitureKind& kind : furniture_library()) {
        EXPECT_TRUE(kinds.insert(kind.kind).second) << kind.kind;
        EXPECT_TRUE(labels.insert(kind.label).second) << kind.label;
        EXPECT_FALSE(kind.sizes.empty());
        EXPECT_FALSE(kind.finishes.empty());
        for (const FurnitureSize& size : kind.sizes) {
            EXPECT_LE(size.low, size.usual) << kind.kind << " " << size.name;
            EXPECT_LE(size.usual, size.high) << kind.kind << " " << size.name;
            EXPECT_FALSE(size.help.empty());
        }
        for (const FurnitureFinish& finish : kind.finishes)
            EXPECT_NE(find_in_palette(finish.material), nullptr) << finish.material;
    }
    EXPECT_GE(kinds.size(), 20U);
}

TEST(TheFurnitureLibrary, every_finish_covers_some_part_of_the_usual_piece) {
    for (const FurnitureKind& kind : furniture_library()) {
        std::set<int> used;
        for (const ModelPart& made : parts_of(model_of(kind))) used.insert(made.finish);
        EXPECT_EQ(used.size(), kind.finishes.size()) << kind.kind;
    }
}

TEST(TheFurnitureLibrary, parts_of_every_usual_piece_touch_and_never_share_space) {
    for (const FurnitureKind& kind : furniture_library()) expect_sound(model_of(kind));
}

TEST(TheFurnitureLibrary, pieces_are_sound_at_both_ends_of_every_size) {
    for (const FurnitureKind& kind : furniture_library()) {
        FurnitureModel least = model_of(kind), most = model_of(kind);
        for (const FurnitureSize& size : kind.sizes) {
            for (const double end : {size.low, size.high}) {
                FurnitureModel model = model_of(kind);
                model.sizes.push_back({std::string(size.name), end});
                expect_sound(model);
            }
            least.sizes.push_back({std::string(size.name), size.low});
            most.sizes.push_back({std::string(size.name), size.high});
        }
        expect_sound(least);
        if (kind.kind != "pallet-rack") expect_sound(most);  // wider than the hall
    }
}

TEST(TheFurnitureLibrary, pieces_of_random_sizes_are_sound) {
    std::mt19937 random(3);
    for (const FurnitureKind& kind : furniture_library())
        for (int k = 0; k < 40; ++k) {
            FurnitureModel model = model_of(kind);
            for (const FurnitureSize& size : kind.sizes) {
                const double high = kind.kind == "pallet-rack" && size.name == "bays" ? 4.0 : size.high;
                const double value = std::uniform_real_distribution<double>(size.low, high)(random);
                model.sizes.push_back({std::string(size.name), value});
            }
            expect_sound(model);
        }
}

TEST(TheFurnitureLibrary, a_desk_keeps_its_top_at_the_stated_height) {
    const std::vector<ModelPart> parts = parts_of({"desk", {{"height", 0.68}}});
    const BoxShape& top = std::get<BoxShape>(parts.front().part.shape);
    EXPECT_DOUBLE_EQ(parts.front().part.position.z + top.size.z, 0.68);
}

TEST(TheFurnitureLibrary, sizes_out_of_range_are_taken_as_their_nearer_end) {
    const FurnitureKind& shelf = *find_furniture_kind("shelf");
    EXPECT_EQ(size_of(shelf, {"shelf", {{"levels", 99.0}}}, "levels"), 12.0);
    EXPECT_EQ(size_of(shelf, {"shelf", {{"levels", 3.4}}}, "levels"), 3.0);
    EXPECT_EQ(size_of(shelf, {"shelf", {{"width", std::nan("")}}}, "width"), 0.8);
    EXPECT_EQ(size_of(shelf, {"shelf", {}}, "colour"), 0.0);
    EXPECT_TRUE(parts_of({"throne", {}}).empty());
}

TEST(FurnitureOfAModel, keeps_its_materials_when_a_size_changes) {
    Added added = with_furniture(empty_room(), {"shelf", {}});
    Furniture& shelf = added.scene.furniture.back();
    const ObjectId red = material_named(added.scene, "Red paint");
    set_finish(shelf, 0, red);
    const std::size_t before = shelf.parts.size();
    set_model_size(shelf, "levels", 9.0);
    EXPECT_EQ(shelf.parts.size(), before + 4);
    EXPECT_EQ(material_of_finish(shelf, 0), red);
    EXPECT_TRUE(follows_model(shelf));
    set_model_size(shelf, "levels", 1.0);
    EXPECT_EQ(material_of_finish(shelf, 0), red);
}

TEST(FurnitureOfAModel, a_single_part_of_another_material_stays_so_when_a_size_changes) {
    Added added = with_furniture(empty_room(), {"desk", {}});
    Furniture& desk = added.scene.furniture.back();
    const ObjectId red = material_named(added.scene, "Red paint");
    desk.parts[2].material = red;
    EXPECT_FALSE(material_of_finish(desk, 1));
    set_model_size(desk, "width", 2.0);
    EXPECT_EQ(desk.parts[2].material, red);
    EXPECT_NE(desk.parts[3].material, red);
    set_model_size(desk, "panel", 0.0);
    set_model_size(desk, "panel", 0.4);
    EXPECT_TRUE(desk.parts.back().material);
}

TEST(FurnitureOfAModel, edited_by_itself_loses_the_model_and_keeps_its_parts) {
    Added added = with_furniture(empty_room(), {"desk", {}});
    Furniture& desk = added.scene.furniture.back();
    desk.parts[0].position.z += 0.1;
    const std::vector<Part> parts = desk.parts;
    const Diagnostics findings = settle_models(added.scene);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].severity, Severity::warning);
    EXPECT_EQ(added.scene.furniture.back().parts, parts);
    EXPECT_TRUE(added.scene.furniture.back().model.kind.empty());
    EXPECT_TRUE(settle_models(added.scene).empty());
}

TEST(FurnitureOfAModel, of_a_newer_library_keeps_the_model) {
    Added added = with_furniture(empty_room(), {"desk", {}});
    added.scene.furniture.back().model.kind = "hammock";
    EXPECT_EQ(settle_models(added.scene).size(), 1U);
    EXPECT_EQ(added.scene.furniture.back().model.kind, "hammock");
}

TEST(NewFurniture, finds_a_place_where_nothing_stands_yet) {
    Scene scene = empty_room();
    for (int k = 0; k < 5; ++k) scene = with_furniture(std::move(scene), {"desk", {}}).scene;
    for (const Diagnostic& finding : check_scene(scene))
        EXPECT_EQ(finding.severity, Severity::note) << to_text(finding);
    std::set<std::string> names;
    for (const Furniture& desk : scene.furniture) names.insert(desk.name);
    EXPECT_EQ(names.size(), 5U);
    EXPECT_EQ(scene.materials.size(), empty_room().materials.size() + 3);  // shared by all desks
}

TEST(NewFurniture, that_belongs_on_a_desk_stands_on_the_chosen_one) {
    const Added desk = with_furniture(empty_room(), {"desk", {}}, {1.0, 2.0, 0.0}, 0.5);
    const Added computer = with_furniture(desk.scene, {"computer", {}}, desk.object);
    EXPECT_DOUBLE_EQ(computer.scene.furniture.back().position.z, 0.74);
    EXPECT_EQ(computer.scene.furniture.back().rotation, 0.5);
    for (const Diagnostic& finding : check_scene(computer.scene))
        EXPECT_EQ(finding.severity, Severity::note) << to_text(finding);
}

TEST(NewFurniture, columns_reach_the_ceiling) {
    Scene scene = empty_room();
    scene.room->height = 3.3;
    const Added column = with_furniture(scene, {"column", {}});
    EXPECT_EQ(own_bounds(column.scene.furniture.back()).high.z, 3.3);
}

TEST(NewFurniture, of_an_unknown_kind_changes_nothing) {
    const Added none = with_furniture(empty_room(), {"throne", {}});
    EXPECT_FALSE(none.object);
    EXPECT_EQ(none.scene, empty_room());
}

}  // namespace
}  // namespace hanei
