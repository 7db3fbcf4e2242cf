#include "ui/panels/section.h"

#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

constexpr double plan_height = 1.2;   // m above the floor
constexpr double along_slack = 0.05;  // sine of 3 degrees: a ray nearer to the normal says nothing

/// Of the bounds along a direction.
std::pair<double, double> extent_along(const Vec3& direction, const Bounds& bounds) {
    const Vec3 middle = 0.5 * (bounds.low + bounds.high), half = 0.5 * (bounds.high - bounds.low);
    const double centre = glm::dot(middle, direction), reach = glm::dot(half, glm::abs(direction));
    return {centre - reach, centre + reach};
}

Axis axis_of(const Cut& cut) {
    const Vec3 size = glm::abs(cut.normal);
    return size.z >= std::max(size.x, size.y) ? Axis::z : size.y >= size.x ? Axis::y : Axis::x;
}

}  // namespace

Cut section_across(Axis axis, const Camera& camera, const Bounds& bounds) {
    const Vec3 normal = direction_of(axis);
    const auto [low, high] = extent_along(normal, bounds);
    double place = 0.5 * (low + high);
    if (axis == Axis::z && high - low > 1.5 * plan_height) place = low + plan_height;
    const Cut cut{normal, place};
    return glm::dot(camera.eye - camera.target, normal) < -1e-9 ? flipped(cut) : cut;
}

void toggle_section(Camera& camera, const Bounds& bounds) {
    if (camera.left_out.cut)
        camera.left_out.cut.reset();
    else
        camera.left_out.cut = section_across(Axis::z, camera, bounds);
}

Cut flipped(const Cut& cut) { return {-cut.normal, -cut.offset}; }

Vec3 handle_of(const Cut& cut, const Bounds& bounds) {
    const Vec3 middle = 0.5 * (bounds.low + bounds.high);
    return middle + (cut.offset - glm::dot(cut.normal, middle)) * cut.normal;
}

Cut moved_to(const Cut& cut, const Ray& ray, const Bounds& bounds, double raster) {
    const double cosine = glm::dot(ray.direction, cut.normal);
    const double sine_squared = 1.0 - cosine * cosine;
    if (!(sine_squared > along_slack * along_slack)) return cut;
    const Vec3 between = handle_of(cut, bounds) - ray.origin;
    const double by = (cosine * glm::dot(ray.direction, between) - glm::dot(cut.normal, between)) / sine_squared;
    if (!std::isfinite(by)) return cut;
    const auto [low, high] = extent_along(cut.normal, bounds);
    return {cut.normal, std::clamp(snapped(cut.offset + by, raster), low, high)};
}

void section_rows(Camera& camera, const Bounds& bounds, WidgetRegistry& widgets) {
    ImGui::MenuItem(tr("Without ceiling"), "U", &camera.left_out.ceiling);
    widgets.note("section.ceiling");
    tooltip(tr("Take the ceiling off, as of a doll's house; luminaires stay where they hang"));
    std::optional<Cut>& cut = camera.left_out.cut;
    if (ImGui::MenuItem(tr("Section plane"), "K", cut.has_value())) toggle_section(camera, bounds);
    widgets.note("section.on");
    tooltip(tr("Leave out what lies before a plane; its handle moves it in the picture"));
    if (!cut) return;
    constexpr std::array rows{std::pair{Axis::x, "x"}, std::pair{Axis::y, "y"}, std::pair{Axis::z, "z"}};
    ImGui::Indent();
    for (const auto& [axis, name] : rows) {
        if (ImGui::RadioButton(fmt::format("{}###{}", tr(name), name).c_str(), axis_of(*cut) == axis))
            cut = section_across(axis, camera, bounds);
        widgets.note(fmt::format("section.{}", name));
        tooltip(tr("Across this axis"));
        ImGui::SameLine();
    }
    if (ImGui::SmallButton(tr("Flip"))) cut = flipped(*cut);
    widgets.note("section.flip");
    tooltip(tr("Leave out the other side"));
    const auto [low, high] = extent_along(direction_of(axis_of(*cut)), bounds);
    const double side = glm::dot(cut->normal, direction_of(axis_of(*cut))) < 0.0 ? -1.0 : 1.0;
    auto place = static_cast<float>(side * cut->offset);
    ImGui::SetNextItemWidth(150.0F * style::scale());
    if (ImGui::SliderFloat("###place", &place, static_cast<float>(low), static_cast<float>(high), "%.2f m"))
        cut->offset = side * static_cast<double>(place);
    widgets.note("section.place");
    tooltip(tr("Where the plane is"));
    ImGui::Unindent();
}

}  // namespace hanei
