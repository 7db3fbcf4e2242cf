#pragma once

#include "app/desktop.h"
#include "ui/window/driver.h"

#include <gtest/gtest.h>

namespace hanei {

/// The computer room with wide patches: the window is on trial here, not the figures.
inline Driver::Setup computer_room() {
    Opened<ProjectContent> opened =
        project_door().open(std::filesystem::path(HANEI_SOURCE) / "assets/rooms/computer-room-panels.hanei");
    EXPECT_TRUE(opened.content);
    opened.content->settings.max_patch = 1.5;
    return {*opened.content, {}, project_door()};
}

}  // namespace hanei
