#include "engine/scene/colour.h"
#include "engine/scene/dimmers.h"
#include "engine/scene/layout.h"
#include "engine/scene/scene_findings.h"

#include <algorithm>

namespace hanei {
namespace {

void check_control_groups(SceneChecks& checks) {
    const std::vector<ControlGroup>& groups = checks.scene.control_groups;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        ObjectFindings object = checks.about("control_groups", i, "control group", groups[i].name, groups[i].id);
        checks.check_id(object, groups[i].id);
        object.within("dimming", groups[i].dimming, 0.0, 1.0);
        check_colour_temperature(object, groups[i].colour_temperature);
    }
    const std::vector<Luminaire>& luminaires = checks.scene.luminaires;
    for (std::size_t i = 0; i < luminaires.size(); ++i) {
        if (!luminaires[i].group || find_control_group(checks.scene, luminaires[i].group)) continue;
        checks.about("luminaires", i, "luminaire", luminaires[i].name, luminaires[i].id)
            .error("group", "there is no such control group; choose another or none");
    }
}

void check_light_scenes(SceneChecks& checks) {
    const std::vector<LightScene>& scenes = checks.scene.light_scenes;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        ObjectFindings object = checks.about("light_scenes", i, "light scene", scenes[i].name, scenes[i].id);
        checks.check_id(object, scenes[i].id);
        if (scenes[i].levels.empty()) object.warn("levels", "it sets no control group; store the present levels in it");
        std::set<ObjectId> set;
        for (std::size_t k = 0; k < scenes[i].levels.size(); ++k) {
            const LightScene::Level& level = scenes[i].levels[k];
            const std::string field = "levels[" + std::to_string(k) + "]";
            object.within(field + ".dimming", level.dimming, 0.0, 1.0);
            if (!find_control_group(checks.scene, level.group))
                object.error(field + ".group", "there is no such control group; choose another");
            else if (!set.insert(level.group).second)
                object.error(field + ".group", "the control group has a level already; keep one");
        }
    }
}

struct LayoutCheck {
    ObjectFindings& object;

    void count(const char* field, int found, int most) const {
        if (found < 1 || found > most)
            object.error(std::string("layout.").append(field),
                         "found " + std::to_string(found) + ", allowed are 1 to " + std::to_string(most));
    }
    void operator()(const LineLayout& line) const {
        object.finite("layout.from", line.from);
        object.finite("layout.to", line.to);
        count("count", line.count, most_in_a_row);
    }
    void operator()(const FieldLayout& field) const {
        object.finite("layout.corner", field.corner);
        object.finite("layout.along", field.along);
        object.finite("layout.across", field.across);
        count("columns", field.columns, most_in_a_row);
        count("rows", field.rows, most_in_a_row);
    }
    void operator()(const CircleLayout& circle) const {
        object.finite("layout.middle", circle.middle);
        if (object.finite("layout.radius", {circle.radius}) && circle.radius < 0.0)
            object.error("layout.radius", "found " + figure(circle.radius) + " m, it must be 0 or more");
        object.finite("layout.first_angle_deg", {circle.first_angle});
        count("count", circle.count, most_in_a_row);
    }
};

void check_arrangements(SceneChecks& checks) {
    std::set<ObjectId> luminaires, arranged;
    for (const Luminaire& luminaire : checks.scene.luminaires) luminaires.insert(luminaire.id);
    const std::vector<Arrangement>& arrangements = checks.scene.arrangements;
    for (std::size_t i = 0; i < arrangements.size(); ++i) {
        const Arrangement& made = arrangements[i];
        ObjectFindings object = checks.about("arrangements", i, "arrangement", made.name, made.id);
        checks.check_id(object, made.id);
        object.finite("yaw_deg", {made.yaw});
        std::visit(LayoutCheck{object}, made.layout);
        if (made.luminaires.size() != place_count(made.layout))
            object.error("luminaires", "found " + std::to_string(made.luminaires.size()) + " for " +
                                           std::to_string(place_count(made.layout)) +
                                           " places of the layout; one a place is needed, null where it is empty");
        std::size_t present = 0;
        for (std::size_t k = 0; k < made.luminaires.size(); ++k) {
            const ObjectId id = made.luminaires[k];
            if (!id) continue;
            ++present;
            const std::string field = "luminaires[" + std::to_string(k) + "]";
            if (luminaires.count(id) == 0)
                object.error(field, "there is no such luminaire; name another, or null");
            else if (!arranged.insert(id).second)
                object.error(field, "the luminaire is in an arrangement already; it can be in one only");
        }
        if (present == 0) object.warn("luminaires", "it has no luminaire; dissolve it");
    }
}

}  // namespace

void check_lighting(SceneChecks& checks) {
    check_control_groups(checks);
    check_light_scenes(checks);
    check_arrangements(checks);
}

}  // namespace hanei
