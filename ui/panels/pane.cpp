#include "ui/panels/pane.h"

namespace hanei {

bool Pane::holds(ImVec2 at) const { return at.x >= left && at.x < left + width && at.y >= top && at.y < top + height; }

Vec2 Pane::within(ImVec2 at) const {
    return {static_cast<double>((at.x - left) / width), static_cast<double>((at.y - top) / height)};
}

std::optional<ImVec2> Pane::on_screen(const Vec3& place) const {
    const std::optional<Vec2> at = projected(camera, place, aspect());
    if (!at) return std::nullopt;
    return ImVec2(left + static_cast<float>(at->x) * width, top + static_cast<float>(at->y) * height);
}

std::vector<std::vector<ImVec2>> Pane::on_screen(const std::vector<Vec3>& places) const {
    std::vector<std::vector<ImVec2>> runs(1);
    for (const Vec3& place : places) {
        if (const auto at = on_screen(place))
            runs.back().push_back(*at);
        else if (!runs.back().empty())
            runs.emplace_back();
    }
    return runs;
}

}  // namespace hanei
