#pragma once

#include "engine/base/diagnostic.h"
#include "engine/plan/settings.h"
#include "engine/scene/scene.h"

#include <optional>

namespace hanei {

/// What the window edits and saves.
struct ProjectContent {
    Scene scene;
    Settings settings;
};

template <class Content>
struct Opened {
    std::optional<Content> content;  ///< empty when the file cannot be used
    Diagnostics findings;
};

}  // namespace hanei
