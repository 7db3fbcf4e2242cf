/// What takes its time, in one place: how far it is, how long it will still take, and a way to stop it.
#pragma once

#include "ui/panels/widget_registry.h"

#include <functional>
#include <string>

namespace hanei {

struct Task {
    std::string id;    ///< "export": its widgets are "export.progress" and "export.cancel"
    std::string name;  ///< "Exporting 2 of 4"
    float fraction = 0.0F;
    std::string left;              ///< "12 s left"; empty while unknown
    std::function<void()> cancel;  ///< empty where it cannot be stopped
};

/// Draws it into the present line; its width at scale 1 is task_bar_width.
inline constexpr float task_bar_width = 330.0F;
void task_bar(const Task& task, WidgetRegistry& widgets);

}  // namespace hanei
