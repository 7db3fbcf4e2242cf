#include "ui/panels/section.h"

#include "ui/panels/form.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"
#include "ui/panels/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <numbers>

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

namespace {

/// A length to slide, in the unit that lengths are shown in.
bool length_slider(const char* label, double& metres, double low, double high) {
    const ShownUnit unit = shown_unit("m");
    auto shown = static_cast<float>(metres / unit.worth);
    // Feet and inches are no figure that a slider could be typed into.
    const std::string format = unit.feet_inches
                                   ? with_unit(metres, "m", 2)
                                   : fmt::format("%.{}f {}", std::max(0, 2 - unit.fewer_decimals), unit.label);
    const bool moved =
        ImGui::SliderFloat(label, &shown, static_cast<float>(low / unit.worth), static_cast<float>(high / unit.worth),
                           format.c_str(), unit.feet_inches ? ImGuiSliderFlags_NoInput : ImGuiSliderFlags_AlwaysClamp);
    if (moved) metres = static_cast<double>(shown) * unit.worth;
    return moved;
}

void lens_row(Camera& camera, const std::string& name, WidgetRegistry& widgets) {
    if (camera.orthographic) return;
    constexpr double degree = std::numbers::pi / 180.0;
    auto degrees = static_cast<float>(camera.field_of_view / degree);
    ImGui::SetNextItemWidth(150.0F * style::scale());
    const std::string label = fmt::format("{}###lens", tr("Field of view"));
    if (ImGui::SliderFloat(label.c_str(), &degrees, static_cast<float>(least_field_of_view),
                           static_cast<float>(greatest_field_of_view), "%.0f°", ImGuiSliderFlags_AlwaysClamp))
        camera.field_of_view = static_cast<double>(degrees) * degree;
    widgets.note(name + ".field_of_view");
    tooltip(tr("Of the perspective, from the lower to the upper edge of the picture; the eye stays where it is"));
}

void place_rows(Cut& cut, const Camera& camera, const Bounds& bounds, const std::string& name,
                WidgetRegistry& widgets) {
    constexpr std::array rows{std::pair{Axis::x, "x"}, std::pair{Axis::y, "y"}, std::pair{Axis::z, "z"}};
    for (const auto& [axis, letter] : rows) {
        if (ImGui::RadioButton(fmt::format("{}###{}", tr(letter), letter).c_str(), axis_of(cut) == axis))
            cut = section_across(axis, camera, bounds);
        widgets.note(fmt::format("{}.{}", name, letter));
        tooltip(tr("Across this axis"));
        ImGui::SameLine();
    }
    if (ImGui::SmallButton(tr("Flip"))) cut = flipped(cut);
    widgets.note(name + ".flip");
    tooltip(tr("Leave out the other side"));
    const auto [low, high] = extent_along(direction_of(axis_of(cut)), bounds);
    const double side = glm::dot(cut.normal, direction_of(axis_of(cut))) < 0.0 ? -1.0 : 1.0;
    double place = side * cut.offset;
    ImGui::SetNextItemWidth(150.0F * style::scale());
    if (length_slider("###place", place, low, high)) cut.offset = side * place;
    widgets.note(name + ".place");
    tooltip(tr("Where the plane is"));
}

}  // namespace

bool section_rows(Camera& camera, const Bounds& bounds, const std::string& name, WidgetRegistry& widgets) {
    const Camera before = camera;
    lens_row(camera, name, widgets);
    ImGui::Checkbox(fmt::format("{}###ceiling", tr("Without ceiling")).c_str(), &camera.left_out.ceiling);
    widgets.note(name + ".ceiling");
    tooltip(tr("Take the ceiling off, as of a doll's house; luminaires stay where they hang"));
    std::optional<Cut>& cut = camera.left_out.cut;
    bool is_cut = cut.has_value();
    if (ImGui::Checkbox(fmt::format("{}###cut", tr("Section plane")).c_str(), &is_cut)) toggle_section(camera, bounds);
    widgets.note(name + ".on");
    tooltip(tr("Leave out what lies before a plane; its handle moves it in the picture"));
    if (cut) {
        ImGui::Indent();
        place_rows(*cut, camera, bounds, name, widgets);
        ImGui::Unindent();
    }
    return !(camera == before);
}

}  // namespace hanei
