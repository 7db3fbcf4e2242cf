#include "ui/view/standpoint.h"

namespace hanei {
namespace {

constexpr double axis_slack = 1e-6;  // of the line of sight: less is rounding

struct Entry {
    Standpoint standpoint;
    std::string_view name, word;
    Vec3 from;  ///< unit, from the room to the eye; zero: not along an axis
};

const std::array entries{Entry{Standpoint::overview, "Overview", "overview", {0, 0, 0}},
                         Entry{Standpoint::plan, "Plan", "plan", {0, 0, 1}},
                         Entry{Standpoint::ceiling_plan, "Ceiling plan", "ceiling-plan", {0, 0, -1}},
                         Entry{Standpoint::front, "Front", "front", {0, -1, 0}},
                         Entry{Standpoint::back, "Back", "back", {0, 1, 0}},
                         Entry{Standpoint::left, "Left", "left", {-1, 0, 0}},
                         Entry{Standpoint::right, "Right", "right", {1, 0, 0}}};

const Entry& entry_of(Standpoint standpoint) { return entries[static_cast<std::size_t>(standpoint)]; }

}  // namespace

std::string_view name_of(Standpoint standpoint) { return entry_of(standpoint).name; }
std::string_view word_of(Standpoint standpoint) { return entry_of(standpoint).word; }

Camera camera_at(Standpoint standpoint, const Bounds& bounds, double aspect) {
    if (standpoint == Standpoint::overview) return overview(bounds, aspect);
    return along_axis(entry_of(standpoint).from, bounds, aspect);
}

std::optional<Standpoint> standpoint_of(const Camera& camera) {
    if (!camera.orthographic) return std::nullopt;
    const Vec3 from = -axes_of(camera).forward;
    for (const Entry& entry : entries) {
        if (entry.from != Vec3(0.0) && glm::length(from - entry.from) < axis_slack) return entry.standpoint;
    }
    return std::nullopt;
}

}  // namespace hanei
