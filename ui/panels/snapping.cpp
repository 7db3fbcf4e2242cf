#include "ui/panels/snapping.h"

#include "engine/edit/hanging.h"
#include "ui/panels/drag.h"
#include "ui/panels/language.h"
#include "ui/panels/units.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace hanei {
namespace {

constexpr double same_line = 1e-6;  // m: places closer than this are in line already

bool holds(std::span<const ObjectId> ids, ObjectId id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); }

class Lines {
public:
    Lines(const Scene& scene, std::span<const ObjectId> moving, const Vec3& place)
        : scene_(scene), moving_(moving), place_(place) {}

    /// Its bounds touch a wall that runs along x or y.
    void walls() {
        const std::optional<Bounds> bounds = bounds_of_objects(scene_, moving_);
        if (!scene_.room || !bounds) return;
        const std::vector<Vec2>& plan = scene_.room->plan;
        for (std::size_t k = 0; k < plan.size(); ++k) {
            const Vec2 a = plan[k], b = plan[(k + 1) % plan.size()];
            for (int axis = 0; axis < 2; ++axis) {
                if (std::abs(a[axis] - b[axis]) > same_line) continue;
                const bool room_is_above = (axis == 0) == (b[1 - axis] < a[1 - axis]);  // plans run counter-clockwise
                const double edge = room_is_above ? bounds->low[axis] : bounds->high[axis];
                lines.push_back({axis, a[axis] + place_[axis] - edge, SnapKind::wall, a[axis]});
                if (is_luminaire()) half_spacing(axis, a[axis]);
            }
        }
    }

    void centre() {
        if (!scene_.room || scene_.room->plan.empty()) return;
        const Vec2 middle = bounds_of_plan(scene_).middle();
        for (int axis = 0; axis < 2; ++axis) lines.push_back({axis, middle[axis], SnapKind::centre, middle[axis]});
    }

    void objects() {
        const auto in_line = [&](const auto& list) {
            for (const auto& object : list) {
                if (holds(moving_, object.id)) continue;
                const std::optional<Vec3> at = place_of(scene_, object.id);
                for (int axis = 0; axis < 2; ++axis)
                    lines.push_back({axis, (*at)[axis], SnapKind::object, (*at)[1 - axis]});
            }
        };
        if (is_luminaire())
            in_line(scene_.luminaires);
        else
            in_line(scene_.furniture);
    }

    std::vector<SnapLine> lines;

private:
    bool is_luminaire() const { return !moving_.empty() && kind_of(scene_, moving_.front()) == ObjectKind::luminaire; }

    /// Half as far from the wall as from the next luminaire: rows that light evenly hang so.
    void half_spacing(int axis, double wall) {
        std::optional<double> next;
        for (const Luminaire& luminaire : scene_.luminaires) {
            const double at = luminaire.position[axis];
            if (holds(moving_, luminaire.id) || std::abs(at - wall) < same_line) continue;
            if (!next || std::abs(at - wall) < std::abs(*next - wall)) next = at;
        }
        if (next) lines.push_back({axis, wall + (*next - wall) / 3.0, SnapKind::half_spacing, wall});
    }

    const Scene& scene_;
    std::span<const ObjectId> moving_;
    Vec3 place_;
};

}  // namespace

std::vector<SnapLine> snap_lines(const Scene& scene, std::span<const ObjectId> moving, const Vec3& place,
                                 const SnapSettings& settings) {
    Lines found(scene, moving, place);
    if (settings.to_objects) found.objects();
    if (settings.to_walls) found.walls();
    if (settings.to_centre) found.centre();
    return std::move(found.lines);
}

Snapped snapped(const Vec3& wished, std::span<const SnapLine> lines, const SnapSettings& settings, double reach,
                const bool (&free)[3]) {
    Snapped result{wished, {}};
    for (int axis = 0; axis < 3; ++axis) {
        if (!free[axis]) continue;
        const SnapLine* nearest = nullptr;
        for (const SnapLine& line : lines) {
            const double away = std::abs(line.value - wished[axis]);
            if (line.axis != axis || axis == 2 || away > reach) continue;
            if (nearest == nullptr || away < std::abs(nearest->value - wished[axis])) nearest = &line;
        }
        if (nearest != nullptr) {
            result.place[axis] = nearest->value;
            result.caught.push_back(*nearest);
        } else if (settings.to_raster) {
            result.place[axis] = snapped(wished[axis], settings.raster);
        }
    }
    return result;
}

std::string text_of(const SnapSettings& settings) {
    if (!settings.on) return tr("Free");
    if (!settings.to_raster) return tr("Snap to lines");
    return fmt::format("{} {}", tr("Snap"), with_unit(settings.raster, "m", settings.raster < 0.1 ? 2 : 1));
}

}  // namespace hanei
