#include "ui/panels/window_layout.h"

#include "ui/panels/elided.h"
#include "ui/panels/keyboard_map.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <vector>

namespace hanei {
namespace {

constexpr float menu_height = 21.0F;

void expect_apart(const ScreenRect& a, const ScreenRect& b) {
    EXPECT_TRUE(a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top);
}

TEST(TheLayout, divides_every_window_without_overlap) {
    for (const float width : {800.0F, 1280.0F, 1920.0F, 2560.0F}) {
        for (const float height : {600.0F, 800.0F, 1440.0F}) {
            for (const float scale : {1.0F, 1.5F, 2.0F, 3.0F}) {
                const WindowLayout made = lay_out({}, width, height, menu_height * scale, scale);
                const std::vector<ScreenRect> parts{made.left, made.right, made.bottom, made.centre, made.status};
                for (std::size_t k = 0; k < parts.size(); ++k) {
                    EXPECT_LT(parts[k].left, parts[k].right) << k;
                    EXPECT_LT(parts[k].top, parts[k].bottom) << k;
                    EXPECT_GE(parts[k].left, 0.0F);
                    EXPECT_LE(parts[k].right, width);
                    EXPECT_LE(parts[k].bottom, height);
                    for (std::size_t other = 0; other < k; ++other) expect_apart(parts[k], parts[other]);
                }
            }
        }
    }
}

TEST(TheLayout, stacks_lists_over_fields_where_two_columns_have_no_room) {
    const WindowLayout wide = lay_out({}, 1280.0F, 800.0F, menu_height, 1.0F);
    EXPECT_FALSE(wide.stacked);
    EXPECT_EQ(wide.right.right - wide.right.left + 1.0F, Preferences().right_width);
    const WindowLayout dense = lay_out({}, 1280.0F, 800.0F, 2.0F * menu_height, 2.0F);
    EXPECT_TRUE(dense.stacked);
    EXPECT_EQ(dense.left.left, dense.right.left);
    EXPECT_GT(dense.right.right - dense.right.left, 250.0F * 2.0F) << "fields keep the width that their words need";
    EXPECT_GT(dense.centre.right - dense.centre.left, 0.5F * 1280.0F);
}

class Elided : public testing::Test {
protected:
    Elided() : context(ImGui::CreateContext()) {
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().DisplaySize = {400.0F, 400.0F};
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
        ImGui::NewFrame();
    }
    ~Elided() override {
        ImGui::EndFrame();
        ImGui::DestroyContext(context);
    }
    ImGuiContext* context;
};

TEST_F(Elided, text_fits_its_room_and_keeps_what_tells_names_apart) {
    const std::string name = "Panel 600, microprismatic, recessed 12";
    for (const float room : {300.0F, 150.0F, 60.0F, 20.0F, 3.0F, 0.0F}) {
        for (const Elide elide : {Elide::end, Elide::middle}) {
            const std::string shown = elided(name, room, elide);
            EXPECT_LE(ImGui::CalcTextSize(shown.c_str()).x, room);
        }
    }
    EXPECT_EQ(elided(name, 1e4F), name);
    EXPECT_TRUE(elided(name, 150.0F, Elide::middle).ends_with(" 12"));
    EXPECT_TRUE(elided(name, 150.0F, Elide::middle).starts_with("Panel"));
    EXPECT_TRUE(elided(name, 150.0F, Elide::end).ends_with("…"));
}

TEST_F(Elided, text_is_never_cut_within_a_letter) {
    const std::string name = "照明器具の長い名前と番号十二";
    for (float room = 0.0F; room < 200.0F; room += 7.0F) {
        for (const char letter : elided(name, room, Elide::middle).substr(0, 1))
            EXPECT_NE(static_cast<unsigned char>(letter) & 0xC0U, 0x80U);
        EXPECT_EQ(elided(name, room, Elide::middle).size() % 3, 0U) << "each of these letters has three bytes";
    }
}

TEST(TheKeyboardMap, names_every_key_once_and_balances_its_columns) {
    std::size_t rows = 0;
    for (const KeyGroup& group : keyboard_map()) {
        EXPECT_FALSE(group.rows.empty()) << group.title;
        rows += group.rows.size();
    }
    EXPECT_GT(rows, 60U);
    EXPECT_EQ(balanced(std::vector<float>{3.0F, 1.0F, 2.0F, 2.0F}), 2U);
    EXPECT_EQ(balanced(std::vector<float>{1.0F, 1.0F, 1.0F, 3.0F}), 3U);
    EXPECT_EQ(balanced(std::vector<float>{5.0F}), 1U);
    EXPECT_EQ(balanced(std::vector<float>{}), 0U);
}

}  // namespace
}  // namespace hanei
