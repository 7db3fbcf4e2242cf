#include "engine/edit/arrangements.h"

#include "engine/edit/hanging.h"
#include "engine/edit/luminaire_edits.h"
#include "engine/scene/suspension.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace hanei {
namespace {

constexpr double at_its_place = 1e-6;  // m

Arrangement* arrangement_in(Scene& scene, ObjectId id) {
    const auto found = std::find_if(scene.arrangements.begin(), scene.arrangements.end(),
                                    [&](const Arrangement& each) { return each.id == id; });
    return found == scene.arrangements.end() ? nullptr : &*found;
}

Luminaire* luminaire_in(Scene& scene, ObjectId id) {
    const auto found = std::find_if(scene.luminaires.begin(), scene.luminaires.end(),
                                    [&](const Luminaire& each) { return each.id == id; });
    return found == scene.luminaires.end() ? nullptr : &*found;
}

bool is_empty(const Arrangement& arrangement) { return luminaires_in(arrangement) == 0; }

/// Only fields are cut by the plan: lines and circles are drawn where they are wanted.
bool is_wanted(const Scene& scene, const Layout& layout, const Vec3& place) {
    return !std::holds_alternative<FieldLayout>(layout) || !scene.room || is_over_plan(*scene.room, Vec2(place));
}

/// Which place of the old layout is the same as place k of the new one.
std::size_t old_number(const Layout& before, const Layout& after, std::size_t k) {
    const auto* old_field = std::get_if<FieldLayout>(&before);
    const auto* new_field = std::get_if<FieldLayout>(&after);
    if (!old_field || !new_field) return k;
    const std::size_t columns = static_cast<std::size_t>(new_field->columns);
    const std::size_t row = k / columns, column = k % columns;
    if (column >= static_cast<std::size_t>(old_field->columns)) return place_count(before);
    return row * static_cast<std::size_t>(old_field->columns) + column;
}

/// "Panel" of "Panel 12".
std::string stem_of(const std::string& name) {
    const std::size_t last = name.find_last_not_of("0123456789");
    if (last == std::string::npos || last + 1 == name.size() || name[last] != ' ') return name;
    return name.substr(0, last);
}

/// Names copies "Panel 3", "Panel 4", each by a number that is free.
class FreeNames {
public:
    explicit FreeNames(const Scene& scene) {
        for (const Luminaire& luminaire : scene.luminaires) taken_.insert(luminaire.name);
    }
    std::string next(const std::string& stem) {
        std::string name;
        do name = fmt::format("{} {}", stem, ++number_);
        while (!taken_.insert(name).second);
        return name;
    }

private:
    std::set<std::string> taken_;
    int number_ = 0;
};

struct MovedLayout {
    Vec3 by;
    void operator()(LineLayout& line) const { line = {line.from + by, line.to + by, line.count}; }
    void operator()(FieldLayout& field) const { field.corner += by; }
    void operator()(CircleLayout& circle) const { circle.middle += by; }
};

const char* kind_of(const Layout& layout) {
    constexpr const char* kinds[] = {"Line", "Field", "Circle"};
    return kinds[layout.index()];
}

}  // namespace

const Arrangement* find_arrangement(const Scene& scene, ObjectId id) {
    const auto found = std::find_if(scene.arrangements.begin(), scene.arrangements.end(),
                                    [&](const Arrangement& each) { return each.id == id; });
    return found == scene.arrangements.end() || !id ? nullptr : &*found;
}

const Arrangement* arrangement_of(const Scene& scene, ObjectId luminaire) {
    if (!luminaire) return nullptr;
    for (const Arrangement& each : scene.arrangements)
        if (std::find(each.luminaires.begin(), each.luminaires.end(), luminaire) != each.luminaires.end()) return &each;
    return nullptr;
}

std::vector<ObjectId> luminaires_among(const Scene& scene, std::span<const ObjectId> objects) {
    const auto chosen = [&](ObjectId id) {
        return id && std::find(objects.begin(), objects.end(), id) != objects.end();
    };
    const auto in_chosen_group = [&](ObjectId id) {
        return std::any_of(scene.object_groups.begin(), scene.object_groups.end(), [&](const ObjectGroup& group) {
            return chosen(group.id) && std::find(group.members.begin(), group.members.end(), id) != group.members.end();
        });
    };
    std::vector<ObjectId> found;
    for (const Luminaire& luminaire : scene.luminaires) {
        const Arrangement* const arrangement = arrangement_of(scene, luminaire.id);
        const bool meant = chosen(luminaire.id) || chosen(luminaire.group) ||
                           (arrangement && chosen(arrangement->id)) || in_chosen_group(luminaire.id);
        if (meant) found.push_back(luminaire.id);
    }
    return found;
}

std::size_t luminaires_in(const Arrangement& arrangement) {
    return static_cast<std::size_t>(std::count_if(arrangement.luminaires.begin(), arrangement.luminaires.end(),
                                                  [](ObjectId id) { return static_cast<bool>(id); }));
}

Vec3 middle_of(const Layout& layout) {
    if (const auto* line = std::get_if<LineLayout>(&layout)) return 0.5 * (line->from + line->to);
    if (const auto* field = std::get_if<FieldLayout>(&layout))
        return field->corner + 0.5 * (field->along + field->across);
    return std::get<CircleLayout>(layout).middle;
}

Layout moved(Layout layout, const Vec3& by) {
    std::visit(MovedLayout{by}, layout);
    return layout;
}

Layout line_over_room(const Scene& scene, double z, int count) {
    const PlanBounds plan = bounds_of_plan(scene);
    const Vec2 size = plan.high - plan.low;
    const Vec2 along = size.x >= size.y ? Vec2(size.x, 0.0) : Vec2(0.0, size.y);
    // half a spacing from the walls, as a field keeps it
    const Vec2 from = plan.middle() - 0.5 * along * (1.0 - 1.0 / count);
    const Vec2 to = plan.middle() + 0.5 * along * (1.0 - 1.0 / count);
    return LineLayout{Vec3(from, z), Vec3(to, z), count};
}

Layout field_over_room(const Scene& scene, double z, int columns, int rows) {
    const PlanBounds plan = bounds_of_plan(scene);
    const Vec2 size = plan.high - plan.low;
    return FieldLayout{Vec3(plan.low, z), {size.x, 0.0, 0.0}, {0.0, size.y, 0.0}, columns, rows};
}

Layout circle_in_room(const Scene& scene, double z, int count) {
    const PlanBounds plan = bounds_of_plan(scene);
    const Vec2 size = plan.high - plan.low;
    return CircleLayout{Vec3(plan.middle(), z), 0.3 * std::min(size.x, size.y), count, 0.0, false};
}

Added arranged(Scene scene, ObjectId luminaire, const Layout& layout) {
    for (Arrangement& each : scene.arrangements)
        std::replace(each.luminaires.begin(), each.luminaires.end(), luminaire, ObjectId{});
    std::erase_if(scene.arrangements, is_empty);
    Arrangement made;
    made.id = scene.new_id();
    made.name = fmt::format("{} {}", kind_of(layout), scene.arrangements.size() + 1);
    made.luminaires = {luminaire};
    // one place to begin with, where the luminaire hangs
    made.layout = LineLayout{{}, {}, 1};
    if (const Luminaire* found = find_luminaire(scene, luminaire))
        made.layout = LineLayout{found->position, found->position, 1};
    const ObjectId id = made.id;
    scene.arrangements.push_back(std::move(made));
    return {with_layout(std::move(scene), id, layout, 0.0), id};
}

Scene with_layout(Scene scene, ObjectId id, const Layout& layout, double yaw) {
    Arrangement* const arrangement = arrangement_in(scene, id);
    if (!arrangement || is_empty(*arrangement) || place_count(layout) == 0) return scene;
    const std::vector<LayoutPlace> before = places_of(arrangement->layout), after = places_of(layout);
    const double turned = arrangement->yaw;
    Arrangement made = *arrangement;
    made.layout = layout;
    made.yaw = yaw;
    made.luminaires.assign(after.size(), {});
    const ObjectId first = *std::find_if(arrangement->luminaires.begin(), arrangement->luminaires.end(),
                                         [](ObjectId each) { return static_cast<bool>(each); });
    const Luminaire like = *find_luminaire(scene, first);
    const auto place_of_first =
        static_cast<std::size_t>(std::find(arrangement->luminaires.begin(), arrangement->luminaires.end(), first) -
                                 arrangement->luminaires.begin());
    const double own_yaw = like.yaw - turned - before[place_of_first].yaw;
    const std::string stem = stem_of(like.name);
    FreeNames names(scene);
    std::set<ObjectId> kept;
    bool none_wanted = true;
    for (std::size_t k = 0; k < after.size(); ++k) {
        if (!is_wanted(scene, layout, after[k].position)) continue;
        none_wanted = false;
        const std::size_t old = old_number(arrangement->layout, layout, k);
        const bool was_there = old < before.size() && old < arrangement->luminaires.size();
        const ObjectId member = was_there ? arrangement->luminaires[old] : ObjectId{};
        // what was emptied by hand stays so; what lay outside the plan is filled
        if (was_there && !member && is_wanted(scene, arrangement->layout, before[old].position)) continue;
        if (Luminaire* luminaire = luminaire_in(scene, member)) {
            luminaire->position = after[k].position;
            luminaire->yaw += yaw + after[k].yaw - turned - before[old].yaw;
            made.luminaires[k] = member;
            kept.insert(member);
            continue;
        }
        Luminaire copy = like;
        copy.id = made.luminaires[k] = scene.new_id();
        copy.name = stem.empty() ? stem : names.next(stem);
        copy.position = after[k].position;
        copy.yaw = own_yaw + yaw + after[k].yaw;
        kept.insert(copy.id);
        scene.luminaires.push_back(std::move(copy));
    }
    if (none_wanted || kept.empty()) return scene;
    const std::vector<ObjectId> members = arrangement->luminaires;
    *arrangement = std::move(made);
    for (const ObjectId member : members)
        if (member && kept.count(member) == 0) scene = removed(std::move(scene), member);
    return scene;
}

Scene dissolved(Scene scene, ObjectId id) {
    std::erase_if(scene.arrangements, [&](const Arrangement& each) { return each.id == id; });
    return scene;
}

std::size_t places_outside(const Scene& scene, const Arrangement& arrangement) {
    const std::vector<LayoutPlace> places = places_of(arrangement.layout);
    std::size_t count = 0;
    for (std::size_t k = 0; k < places.size() && k < arrangement.luminaires.size(); ++k)
        if (!arrangement.luminaires[k] && !is_wanted(scene, arrangement.layout, places[k].position)) ++count;
    return count;
}

Scene with_arrangements_kept(Scene scene) {
    for (Arrangement& each : scene.arrangements) {
        const std::vector<LayoutPlace> places = places_of(each.layout);
        if (places.size() != each.luminaires.size()) continue;
        std::optional<Vec3> by;
        bool alike = true;
        for (std::size_t k = 0; k < places.size(); ++k) {
            const Luminaire* const luminaire = find_luminaire(scene, each.luminaires[k]);
            if (!luminaire) continue;
            const Vec3 moved_by = luminaire->position - places[k].position;
            if (!by) by = moved_by;
            alike = alike && glm::length(moved_by - *by) < at_its_place;
        }
        if (!by || (alike && glm::length(*by) < at_its_place)) continue;
        if (alike) {
            each.layout = moved(each.layout, *by);
            continue;
        }
        for (std::size_t k = 0; k < places.size(); ++k) {
            const Luminaire* const luminaire = find_luminaire(scene, each.luminaires[k]);
            if (luminaire && glm::length(luminaire->position - places[k].position) >= at_its_place)
                each.luminaires[k] = {};
        }
    }
    std::erase_if(scene.arrangements, is_empty);
    return scene;
}

}  // namespace hanei
