#include "engine/study/contribution_stage.h"

#include "engine/study/study.h"
#include "engine/study/value_stage.h"

#include <algorithm>
#include <map>

namespace hanei {
namespace {

constexpr std::size_t told_reflections = 5;  // one by one; all later ones together
constexpr std::size_t columns_at_once = 64;  // a pass over the row each

/// A row of the place, and what arrives by it from many exitances.
class Gathering {
public:
    Gathering(const StoredRows& row, const Work& work) : row_(row), work_(work) {}

    /// lx from each exitance at the nodes; empty when stopped.
    std::optional<std::vector<double>> from(std::span<const std::vector<double>> exitances) const {
        std::vector<double> lux;
        for (std::size_t first = 0; first < exitances.size(); first += columns_at_once) {
            const std::size_t some = std::min(columns_at_once, exitances.size() - first);
            std::vector<double> leaving(row_.columns() * some), arriving(some);
            for (std::size_t s = 0; s < some; ++s)
                for (std::size_t j = 0; j < row_.columns(); ++j) leaving[j * some + s] = exitances[first + s][j];
            if (!row_.multiply(leaving, arriving, some, work_)) return std::nullopt;
            lux.insert(lux.end(), arriving.begin(), arriving.end());
        }
        return lux;
    }

private:
    const StoredRows& row_;
    const Work& work_;
};

void divide_direct(Contributions& made, const LevelInput& input) {
    const Receiver receiver = locate(*made.solution->mesh, made.position, made.normal).receiver;
    double sum = 0.0;
    for (const WeightedEmitter& weighted : emitters_of(*input.scene)) {
        const double lux = weighted.share * weighted.emitter.estimate(receiver, input.occluders.get()).value;
        const ObjectId id = weighted.emitter.luminaire();
        const auto luminaire = std::find_if(input.scene->luminaires.begin(), input.scene->luminaires.end(),
                                            [&](const Luminaire& candidate) { return candidate.id == id; });
        made.luminaires.push_back({id, luminaire->group, lux});
        sum += lux;
    }
    made.value.direct = {sum};
}

double direct_of(const Contributions& made, const std::vector<ObjectId>& luminaires) {
    double sum = 0.0;
    for (const Contributions::OfLuminaire& of : made.luminaires)
        if (std::find(luminaires.begin(), luminaires.end(), of.luminaire) != luminaires.end()) sum += of.direct;
    return sum;
}

/// Every group that shines, with the numbers of its parts in the answer: one a colour band.
struct GroupParts {
    Contributions::OfGroup group;
    std::size_t first = 0, count = 0;
};
std::vector<GroupParts> groups_in(const LevelAnswer& answer, const Scene& scene) {
    int bands = 1;
    for (const MixPart& part : answer.parts) bands = std::max(bands, part.band + 1);
    std::vector<GroupParts> groups;
    std::size_t next = 0;
    for (const LightGroup& group : light_groups(scene)) {
        GroupParts made;
        for (const LightGroup::Member& member : group.members) made.group.luminaires.push_back(member.luminaire->id);
        const bool surfaces = group.members.empty();
        if (!surfaces) made.group.group = group.members.front().luminaire->group;
        const bool shines = surfaces ? next < answer.parts.size() : group.level > 0.0;
        if (!answer.parts.empty() && shines) {
            made.first = next;
            made.count = static_cast<std::size_t>(bands);
            next += made.count;
        }
        if (!surfaces || made.count > 0) groups.push_back(std::move(made));
    }
    return groups;
}

bool divide_by_group(Contributions& made, const Level& level, const LevelAnswer& answer, const LevelInput& input,
                     const Gathering& gathering) {
    std::vector<std::vector<double>> exitances;
    for (const MixPart& part : answer.parts) exitances.push_back(level.node_values(part.light->exitance));
    const auto lux = gathering.from(exitances);
    if (!lux) return false;
    double sum = 0.0;
    for (GroupParts& group : groups_in(answer, *input.scene)) {
        group.group.direct = direct_of(made, group.group.luminaires);
        for (std::size_t k = group.first; k < group.first + group.count; ++k)
            group.group.interreflected += answer.parts[k].level * answer.parts[k].band_weight * (*lux)[k];
        sum += group.group.interreflected;
        made.groups.push_back(std::move(group.group));
    }
    made.value.interreflected = {sum};
    return true;
}

bool divide_by_bounce(Contributions& made, const Level& level, const LevelAnswer& answer, const LevelInput& input,
                      const Gathering& gathering, const Work& work) {
    // a limit of reflections, as the paper has, ends the sum there; refused rows leave the first alone
    const std::size_t limit = answer.refusal.empty() ? static_cast<std::size_t>(input.settings->bounces) + 1 : 1;
    const std::size_t count = std::min(told_reflections + 1, limit);
    std::vector<double> by_reflections(count + 1, 0.0);
    for (const MixPart& part : answer.parts) {
        const auto exitances = level.reflections(part, input, count, work);
        if (!exitances) return false;
        const auto lux = gathering.from(*exitances);
        if (!lux) return false;
        for (std::size_t n = 0; n < lux->size(); ++n)
            by_reflections[n + (part.of_surfaces ? 0 : 1)] += part.level * part.band_weight * (*lux)[n];
    }
    made.later_bounces = made.value.interreflected.value;
    for (std::size_t n = 0; n < std::min(told_reflections + 1, by_reflections.size()); ++n) {
        if (n == 0 && by_reflections[n] <= 0.0) continue;
        made.bounces.push_back({static_cast<int>(n), by_reflections[n]});
        made.later_bounces -= by_reflections[n];
    }
    return true;
}

bool divide_by_surface(Contributions& made, const Level& level, const LevelAnswer& answer, const Gathering& gathering) {
    const Mesh& mesh = *level.now().mesh;
    const std::vector<double> whole = level.node_values(mixed(answer.parts, &SideLight::exitance));
    const std::size_t a_patch = level.now().nodes->per_patch;
    const Vec3 origin = made.position;  // so that places are told by small figures
    for (std::size_t first = 0; first < mesh.faces.size(); first += columns_at_once / 4) {
        const std::size_t end = std::min(mesh.faces.size(), first + columns_at_once / 4);
        std::vector<std::vector<double>> columns(4 * (end - first), std::vector<double>(whole.size(), 0.0));
        for (std::size_t f = first; f < end; ++f) {
            const MeshFace& face = mesh.faces[f];
            for (std::size_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p) {
                const Vec3 place = mesh.patches[p].centre - origin;
                for (std::size_t j = p * a_patch; j < (p + 1) * a_patch; ++j) {
                    columns[4 * (f - first)][j] = whole[j];
                    for (int k = 0; k < 3; ++k)
                        columns[4 * (f - first) + 1 + static_cast<std::size_t>(k)][j] = place[k] * whole[j];
                }
            }
        }
        const auto lux = gathering.from(columns);
        if (!lux) return false;
        for (std::size_t f = first; f < end; ++f) {
            const double* const sums = lux->data() + 4 * (f - first);
            if (!(sums[0] > 0.0)) continue;
            const Vec3 from = origin + Vec3(sums[1], sums[2], sums[3]) / sums[0];
            made.surfaces.push_back({mesh.faces[f].face.ref, sums[0], from, mesh.faces[f].face.normal});
        }
    }
    return true;
}

void rank(Contributions& made) {
    const auto by = [](auto figure) {
        return [figure](const auto& a, const auto& b) { return figure(a) > figure(b); };
    };
    std::stable_sort(made.luminaires.begin(), made.luminaires.end(), by([](const auto& row) { return row.direct; }));
    std::stable_sort(made.groups.begin(), made.groups.end(), by([](const auto& row) { return row.total(); }));
    std::stable_sort(made.surfaces.begin(), made.surfaces.end(), by([](const auto& row) { return row.lux; }));
}

}  // namespace

std::optional<Contributions> contributions_at(const SolutionSnapshot& solution, const Level& level,
                                              const LevelAnswer& answer, const LevelInput& input,
                                              const AskedPlace& place, const Work& work) {
    Contributions made;
    made.solution = solution;
    made.position = place.position;
    made.normal = place.normal;
    made.value = value_at(*solution, place.position, place.normal);
    if (made.value.inside_solid) return made;
    divide_direct(made, input);
    if (work.stop.stop_requested()) return std::nullopt;
    made.value.interreflected = {0.0};
    const Receiver receiver = locate(*level.now().mesh, place.position, place.normal).receiver;
    std::optional<StoredRows> row;
    if (!answer.parts.empty() && input.plan->simulates(Effect::interreflection)) {
        row = level.rows_to(std::span(&receiver, 1), input, work);
        if (!row) return std::nullopt;
    }
    if (row) {
        const Gathering gathering(*row, work);
        if (!divide_by_group(made, level, answer, input, gathering) ||
            !divide_by_bounce(made, level, answer, input, gathering, work) ||
            !divide_by_surface(made, level, answer, gathering))
            return std::nullopt;
    } else {
        for (GroupParts& group : groups_in(answer, *input.scene)) {
            group.group.direct = direct_of(made, group.group.luminaires);
            made.groups.push_back(std::move(group.group));
        }
    }
    rank(made);
    return made;
}

}  // namespace hanei
