#include "engine/report/contributions_report.h"

#include "engine/report/numbers.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace hanei {
namespace {

using Json = nlohmann::ordered_json;

template <class Objects>
std::string name_in(const Objects& objects, ObjectId id, std::string_view kind) {
    for (const auto& object : objects)
        if (object.id == id && !object.name.empty()) return object.name;
    return fmt::format("{} {}", kind, id.value);
}

bool is_of_room(const Scene& scene, const SurfaceRef& surface) {
    return scene.room && surface.object == scene.room->id;
}

std::string surface_name(const Scene& scene, const Contributions::OfSurface& of) {
    const SurfaceRef& surface = of.surface;
    if (is_of_room(scene, surface)) {
        if (surface.face == Room::floor_face) return "Floor";
        if (surface.face == Room::ceiling_face) return "Ceiling";
        return fmt::format("Wall {}", surface.face - Room::wall_face(0) + 1);
    }
    const auto is_it = [&](const FreeSurface& free) { return free.id == surface.object; };
    if (std::any_of(scene.surfaces.begin(), scene.surfaces.end(), is_it))
        return name_in(scene.surfaces, surface.object, "surface");
    constexpr double level = 0.7;  // 45 degrees
    const char* side = of.normal.z > level ? "top" : of.normal.z < -level ? "underside" : "sides";
    return fmt::format("{}, {}", name_in(scene.furniture, surface.object, "furniture"), side);
}

std::string group_name(const Scene& scene, const Contributions::OfGroup& group) {
    if (group.luminaires.empty()) return "Shining surfaces";
    if (group.group) return name_in(scene.control_groups, group.group, "control group");
    if (group.luminaires.size() == 1) return name_in(scene.luminaires, group.luminaires.front(), "luminaire");
    return fmt::format("{} luminaires without a group", group.luminaires.size());
}

double share_of(double lux, double total) { return total > 0.0 ? 100.0 * lux / total : 0.0; }

void add_table(std::string& text, const char* title, const std::vector<ContributionRow>& rows, double total) {
    if (rows.empty()) return;
    text += fmt::format("\n{:<40} {:>9} {:>8}\n", title, "lx", "share");
    for (const ContributionRow& row : rows)
        text += fmt::format("{:<40} {:>9.2f} {:>6.1f} %\n", row.name, row.lux, share_of(row.lux, total));
}

Json json_of(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

Json json_of(const std::vector<ContributionRow>& rows, double total) {
    Json list = Json::array();
    for (const ContributionRow& row : rows) {
        Json entry{{"name", row.name}, {"lx", row.lux}, {"share_percent", share_of(row.lux, total)}};
        if (row.object) entry["id"] = row.object.value;
        if (row.from) entry["from_m"] = json_of(*row.from);
        list.push_back(std::move(entry));
    }
    return list;
}

}  // namespace

std::vector<ContributionRow> rows_by_luminaire(const Contributions& of) {
    std::vector<ContributionRow> rows;
    for (const Contributions::OfLuminaire& row : of.luminaires) {
        const std::vector<Luminaire>& luminaires = of.solution->scene->luminaires;
        const auto found = std::find_if(luminaires.begin(), luminaires.end(),
                                        [&](const Luminaire& luminaire) { return luminaire.id == row.luminaire; });
        rows.push_back(
            {name_in(luminaires, row.luminaire, "luminaire"), row.luminaire, row.direct, row.direct, found->position});
    }
    return rows;
}

std::vector<ContributionRow> rows_by_group(const Contributions& of) {
    std::vector<ContributionRow> rows;
    for (const Contributions::OfGroup& group : of.groups) {
        const ObjectId object = group.group                    ? group.group
                                : group.luminaires.size() == 1 ? group.luminaires.front()
                                                               : ObjectId{};
        rows.push_back({group_name(*of.solution->scene, group), object, group.total(), group.direct, {}});
    }
    return rows;
}

std::vector<ContributionRow> rows_by_reflections(const Contributions& of) {
    std::vector<ContributionRow> rows;
    for (const Contributions::OfBounce& bounce : of.bounces) {
        const std::string name = bounce.reflections == 0   ? "Straight from shining surfaces"
                                 : bounce.reflections == 1 ? "1 reflection"
                                                           : fmt::format("{} reflections", bounce.reflections);
        rows.push_back({name, {}, bounce.lux, 0.0, {}});
    }
    if (!of.bounces.empty())
        rows.push_back({fmt::format("{} and more", of.bounces.back().reflections + 1), {}, of.later_bounces, 0.0, {}});
    return rows;
}

std::vector<ContributionRow> rows_by_surface(const Contributions& of) {
    std::vector<ContributionRow> rows;
    for (const Contributions::OfSurface& surface : of.surfaces) {
        const std::string name = surface_name(*of.solution->scene, surface);
        const auto same = std::find_if(rows.begin(), rows.end(), [&](const ContributionRow& row) {
            return row.object == surface.surface.object && row.name == name;
        });
        if (same == rows.end()) {
            rows.push_back({name, surface.surface.object, surface.lux, 0.0, surface.from});
        } else {
            same->from = (same->lux * *same->from + surface.lux * surface.from) / (same->lux + surface.lux);
            same->lux += surface.lux;
        }
    }
    std::stable_sort(rows.begin(), rows.end(),
                     [](const ContributionRow& a, const ContributionRow& b) { return a.lux > b.lux; });
    return rows;
}

std::string contributions_text(const Contributions& of) {
    std::string text = fmt::format("at {:.3f}, {:.3f}, {:.3f} m, facing {:.3f}, {:.3f}, {:.3f}\n", of.position.x,
                                   of.position.y, of.position.z, of.normal.x, of.normal.y, of.normal.z);
    if (of.value.inside_solid) return text + "inside a solid: no light arrives\n";
    const double total = of.value.total().value, error = of.value.error.total();
    text += fmt::format("{:.2f} lx {}\n", total,
                        has_bound(error) ? fmt::format("± {:.2g}", error) : std::string("without a bound"));
    add_table(text, "all of it",
              {{"Direct", {}, of.value.direct.value, 0.0, {}},
               {"Interreflected", {}, of.value.interreflected.value, 0.0, {}}},
              total);
    add_table(text, "straight from luminaires", rows_by_luminaire(of), total);
    add_table(text, "direct and interreflected, by group", rows_by_group(of), total);
    add_table(text, "interreflected, by reflections", rows_by_reflections(of), total);
    add_table(text, "interreflected, by surface", rows_by_surface(of), total);
    return text;
}

std::string contributions_json(const Contributions& of) {
    Json json{{"position_m", json_of(of.position)}, {"normal", json_of(of.normal)}};
    if (of.value.inside_solid) {
        json["inside_solid"] = true;
        return json.dump(2) + '\n';
    }
    const double total = of.value.total().value;
    json["total_lx"] = total;
    json["direct_lx"] = of.value.direct.value;
    json["interreflected_lx"] = of.value.interreflected.value;
    json["error_lx"] = of.value.error.total();
    json["luminaires"] = json_of(rows_by_luminaire(of), total);
    Json groups = json_of(rows_by_group(of), total);
    for (std::size_t k = 0; k < groups.size(); ++k) {
        groups[k]["direct_lx"] = of.groups[k].direct;
        groups[k]["interreflected_lx"] = of.groups[k].interreflected;
    }
    json["groups"] = std::move(groups);
    json["reflections"] = json_of(rows_by_reflections(of), total);
    json["surfaces"] = json_of(rows_by_surface(of), total);
    return json.dump(2) + '\n';
}

}  // namespace hanei
