#include "engine/edit/several.h"
#include "ui/panels/drag.h"
#include "ui/window/driver.h"

#include <algorithm>
#include <array>
#include <cmath>

// Where the driver aims at objects of the room.

namespace hanei {

/// No widget stands over the picture there, nor a handle that would be taken hold of.
bool Driver::is_free(ImVec2 at) const {
    for (const auto& [name, rect] : workbench().widgets().all()) {
        if (name == "view") continue;
        const float around = name.rfind("handle.", 0) == 0 ? 8.0F : 0.0F;  // pixels a handle reaches beyond its mark
        if (at.x >= rect.left - around && at.x <= rect.right + around && at.y >= rect.top - around &&
            at.y <= rect.bottom + around)
            return false;
    }
    return true;
}

/// A place where a click meets the object: its own place on the screen when that is seen, else the
/// nearest to it of a raster over all of the object. Empty when none is seen.
std::optional<ImVec2> Driver::object_on_screen(const std::string& object) const {
    const Scene& scene = *workbench().document().shown();
    const ObjectIds ids = objects_of(scene, std::array{object_named(scene, object)});
    const std::optional<Vec3> middle = middle_of(scene, ids);
    const std::optional<Bounds> bounds = bounds_of_objects(scene, ids);
    if (!middle || !bounds) return std::nullopt;
    const Viewport& view = workbench().viewport();
    const auto meets = [&](ImVec2 at) {
        const ObjectId met = view.pointed(scene, at).object;
        return is_free(at) && std::find(ids.begin(), ids.end(), met) != ids.end();
    };
    const std::optional<ImVec2> own = view.on_screen(*middle);
    if (own && meets(*own)) return own;
    ImVec2 low{1e6F, 1e6F}, high{-1e6F, -1e6F};
    for (int corner = 0; corner < 8; ++corner) {
        const auto at = view.on_screen({(corner & 1) != 0 ? bounds->high.x : bounds->low.x,
                                        (corner & 2) != 0 ? bounds->high.y : bounds->low.y,
                                        (corner & 4) != 0 ? bounds->high.z : bounds->low.z});
        if (!at) continue;
        low = {std::min(low.x, at->x), std::min(low.y, at->y)};
        high = {std::max(high.x, at->x), std::max(high.y, at->y)};
    }
    constexpr int steps = 24;
    std::vector<ImVec2> places;
    for (int row = 0; row <= steps; ++row) {
        for (int column = 0; column <= steps; ++column)
            places.emplace_back(low.x + (high.x - low.x) * static_cast<float>(column) / steps,
                                low.y + (high.y - low.y) * static_cast<float>(row) / steps);
    }
    const ImVec2 about = own.value_or(ImVec2(0.5F * (low.x + high.x), 0.5F * (low.y + high.y)));
    const auto away = [&](ImVec2 at) { return std::hypot(at.x - about.x, at.y - about.y); };
    std::sort(places.begin(), places.end(), [&](ImVec2 a, ImVec2 b) { return away(a) < away(b); });
    const auto seen = std::find_if(places.begin(), places.end(), meets);
    return seen == places.end() ? std::nullopt : std::optional(*seen);
}

namespace {

/// How far above `foot` the place is that stands at the screen's row `y`, m: halved down from 20 m.
double height_of_tip(const Viewport& viewport, const Vec3& foot, float y) {
    double low = 0.0, high = 20.0;
    for (int step = 0; step < 40; ++step) {
        const double middle = 0.5 * (low + high);
        const auto seen = viewport.on_screen(foot + Vec3{0.0, 0.0, middle});
        (seen && seen->y > y ? low : high) = middle;
    }
    return low;
}

}  // namespace

Driver::Fault Driver::drag_object(const std::string& object, const Vec3& by) { return drag_object(object, by, 0.0); }

Driver::Fault Driver::drag_object(const std::string& object, const Vec3& by, double seconds) {
    const ObjectId id = object_named(*workbench().document().shown(), object);
    if (workbench().chosen() != id) {
        if (Fault fault = click_object(object); !fault.empty()) return fault;
        if (workbench().chosen() != id) return "a click on \"" + object + "\" chose something else";
    }
    const Vec3 start = *place_of(*workbench().document().shown(), id);
    const bool upwards = by.z != 0.0;
    Vec3 grip = start;
    if (upwards) {
        const ScreenRect* tip = workbench().widgets().find("handle.z");
        if (tip == nullptr) return "the z arrow is not on the screen";
        grip.z += height_of_tip(workbench().viewport(), start, tip->y());
    }
    const Viewport& view = workbench().viewport();
    auto from = view.on_screen(grip);
    if (const auto seen = upwards ? std::nullopt : object_on_screen(object)) {
        const auto ray = view.pointed(*workbench().document().shown(), *seen).ray;
        const auto held = ray ? on_horizontal_plane(*ray, start.z, 1e3) : std::nullopt;
        if (held) {
            from = seen;
            grip = *held;
        }
    }
    const auto to = view.on_screen(grip + by);
    if (!from || !to) return "\"" + object + "\" would leave the view";
    drag_path(*from, *to, seconds);
    return place_of(*workbench().document().shown(), id) == start ? "\"" + object + "\" did not move" : Fault{};
}

}  // namespace hanei
