#include "ui/panels/scene_difference.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace hanei {
namespace {

template <class Object>
std::string of_list(const std::vector<Object>& before, const std::vector<Object>& after, const char* one,
                    const char* many) {
    std::map<std::uint32_t, const Object*> old;
    for (const Object& object : before) old[object.id.value] = &object;
    std::size_t added = 0, changed = 0;
    for (const Object& object : after) {
        const auto found = old.find(object.id.value);
        added += found == old.end();
        changed += found != old.end() && !(*found->second == object);
        if (found != old.end()) old.erase(found);
    }
    std::string text;
    for (const auto& [count, what] : {std::pair{added, "added"}, {changed, "changed"}, {old.size(), "removed"}}) {
        if (count == 0) continue;
        if (text.empty())
            text = fmt::format("{} {} {}", count, count == 1 ? one : many, what);
        else
            text += fmt::format(", {} {}", count, what);
    }
    return text;
}

}  // namespace

std::string difference_text(const Scene& before, const Scene& after) {
    std::string text;
    const auto add = [&](const std::string& part) {
        if (!part.empty()) text += (text.empty() ? "" : "; ") + part;
    };
    add(before.room == after.room ? "" : "room changed");
    add(of_list(before.luminaires, after.luminaires, "luminaire", "luminaires"));
    add(of_list(before.furniture, after.furniture, "piece of furniture", "pieces of furniture"));
    add(of_list(before.surfaces, after.surfaces, "surface", "surfaces"));
    add(of_list(before.materials, after.materials, "material", "materials"));
    add(of_list(before.photometries, after.photometries, "photometry", "photometries"));
    add(of_list(before.grids, after.grids, "grid", "grids"));
    add(of_list(before.points, after.points, "point", "points"));
    add(of_list(before.views, after.views, "view", "views"));
    add(of_list(before.control_groups, after.control_groups, "control group", "control groups"));
    add(of_list(before.light_scenes, after.light_scenes, "light scene", "light scenes"));
    add(of_list(before.arrangements, after.arrangements, "arrangement", "arrangements"));
    add(of_list(before.object_groups, after.object_groups, "group", "groups"));
    if (!text.empty()) return text;
    return before == after ? "Nothing" : "Title, scale or maintenance factor changed";
}

}  // namespace hanei
