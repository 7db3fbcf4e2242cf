#include "ui/panels/icon.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace hanei {
namespace {

class EveryIcon : public testing::Test {
protected:
    EveryIcon() : context(ImGui::CreateContext()) {
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().DisplaySize = {100.0F, 100.0F};
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
        ImGui::NewFrame();
    }
    ~EveryIcon() override {
        ImGui::EndFrame();
        ImGui::DestroyContext(context);
    }
    ImGuiContext* context;
};

TEST_F(EveryIcon, is_drawn_within_its_square_at_every_scale) {
    for (int k = 1; k < icon_count; ++k) {
        for (const float size : {14.0F, 28.0F, 43.0F}) {
            ImDrawList list(ImGui::GetDrawListSharedData());
            list._ResetForNewFrame();
            list.PushClipRectFullScreen();
            list.PushTextureID(ImGui::GetIO().Fonts->TexID);
            draw_icon(list, static_cast<Icon>(k), {20.0F, 20.0F}, size, IM_COL32_WHITE);
            ASSERT_GT(list.VtxBuffer.Size, 0) << k;
            const float slack = 1.0F + size / 12.0F;  // half a stroke and its soft edge
            for (const ImDrawVert& corner : list.VtxBuffer) {
                EXPECT_GE(std::min(corner.pos.x, corner.pos.y), 20.0F - slack) << k;
                EXPECT_LE(std::max(corner.pos.x, corner.pos.y), 20.0F + size + slack) << k;
            }
        }
    }
}

TEST_F(EveryIcon, has_a_shape_of_its_own) {
    std::set<std::string_view> shapes;
    for (int k = 1; k < icon_count; ++k) EXPECT_TRUE(shapes.insert(shape_of(static_cast<Icon>(k))).second) << k;
}

TEST(CommandIcons, belong_to_commands_that_exist) {
    for (const CommandIcon& entry : command_icons()) {
        const bool known = std::any_of(commands().begin(), commands().end(),
                                       [&](const Command& command) { return command.name == entry.command; });
        EXPECT_TRUE(known) << entry.command;
    }
}

}  // namespace
}  // namespace hanei
