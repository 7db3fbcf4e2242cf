#include "ui/panels/object_drag.h"

#include "engine/edit/luminaire_edits.h"
#include "ui/panels/units.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace hanei {
namespace {

constexpr double end_on = 0.05;  // sin 3 degrees: a plane seen flatter than this is seen end on
constexpr double turn_raster = 15.0 * std::numbers::pi / 180.0;
constexpr std::size_t longest_typed = 40;

bool is_turn(Grip grip) { return grip == Grip::turn || grip == Grip::tilt; }

void set_free(Grip grip, bool (&free)[3]) {
    free[0] = grip == Grip::x || grip == Grip::plane_xy || grip == Grip::plane_xz;
    free[1] = grip == Grip::y || grip == Grip::plane_xy || grip == Grip::plane_yz;
    free[2] = grip == Grip::z || grip == Grip::plane_xz || grip == Grip::plane_yz;
}

std::optional<Vec3> on_plane(const Ray& ray, const Vec3& through, const Vec3& normal, double reach) {
    const double against = glm::dot(ray.direction, normal);
    if (std::abs(against) < end_on) return std::nullopt;
    const double distance = glm::dot(through - ray.origin, normal) / against;
    if (distance < 0.0 || distance > reach) return std::nullopt;
    return ray.origin + distance * ray.direction;
}

bool is_typed(char letter) {
    return std::string_view("0123456789.+-*/() '\";cmftinrade°").find(letter) != std::string_view::npos;
}

Calculated figure_of(std::string_view text, bool turns) {
    const ShownUnit unit = shown_unit(turns ? "°" : "m");
    return calculated(text, unit.words, unit.bare);
}

}  // namespace

std::optional<ObjectDrag> ObjectDrag::begin(SceneSnapshot scene, ObjectIds chosen, Grip grip, const Ray& ray,
                                            double reach, const SnapSettings& snap) {
    const std::optional<Vec3> middle = middle_of(*scene, chosen);
    if (!middle) return std::nullopt;
    ObjectDrag drag;
    drag.start_ = drag.place_ = *middle;
    drag.grip_ = grip;
    drag.snap_ = snap;
    drag.reach_ = reach;
    set_free(grip, drag.free_);
    set_free(grip, drag.own_free_);
    drag.lines_ = snap_lines(*scene, objects_of(*scene, chosen), *middle, snap);
    if (const Luminaire* luminaire = find_luminaire(*scene, chosen.back())) drag.yaw_ = luminaire->yaw;
    drag.scene_ = std::move(scene);
    drag.chosen_ = std::move(chosen);
    if (is_turn(grip)) {
        const std::optional<double> angle = drag.angle_to(ray);
        if (!angle) return std::nullopt;
        drag.angle_at_ = *angle;
        return drag;
    }
    const std::optional<Vec3> met = drag.met(ray);
    if (!met) return std::nullopt;
    drag.grip_at_ = *met;
    return drag;
}

/// The place the pointer shows on what it may move along; z alone: on the vertical line.
std::optional<Vec3> ObjectDrag::met(const Ray& ray) const {
    const int count = free_count();
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
        const bool is_one = is_free(axis);
        if (count == 1 && is_one) {
            const std::optional<double> distance = along_axis(ray, start_, axis);
            if (!distance) return std::nullopt;
            return start_ + *distance * direction_of(axis);
        }
        if (count == 2 && !is_one) return on_plane(ray, start_, direction_of(axis), reach_);
    }
    return std::nullopt;
}

std::optional<double> ObjectDrag::angle_to(const Ray& ray) const {
    if (grip_ == Grip::turn) {
        const std::optional<Vec3> at = on_plane(ray, start_, {0.0, 0.0, 1.0}, reach_);
        if (!at) return std::nullopt;
        return std::atan2(at->y - start_.y, at->x - start_.x);
    }
    const Vec3 c0{std::cos(yaw_), std::sin(yaw_), 0.0};
    const std::optional<Vec3> at = on_plane(ray, start_, {-c0.y, c0.x, 0.0}, reach_);
    if (!at) return std::nullopt;
    return std::atan2(glm::dot(*at - start_, c0), start_.z - at->z);
}

void ObjectDrag::lock(Axis axis, const Ray& ray) {
    if (is_turn(grip_)) return;
    const bool locked_so = is_free(axis) && free_count() == 1;
    for (int k = 0; k < 3; ++k) free_[k] = locked_so ? own_free_[k] : k == static_cast<int>(axis);
    // From here on the pointer counts from where it is, so that nothing jumps.
    if (const std::optional<Vec3> at = met(ray)) grip_at_ = *at;
    place_ = start_;
}

void ObjectDrag::type(const Keys& keys) {
    if (keys.erases && !typed_.empty()) typed_.pop_back();
    for (const char letter : keys.letters)
        if (is_typed(letter) && typed_.size() < longest_typed) typed_ += letter;
}

/// One figure goes along the free axis, or the way the pointer has gone; two are x and y.
Vec3 ObjectDrag::typed_move(const Vec3& along) const {
    const std::size_t border = typed_.find(';');
    const Calculated first = figure_of(std::string_view(typed_).substr(0, border), false);
    if (border != std::string::npos) {
        const Calculated second = figure_of(std::string_view(typed_).substr(border + 1), false);
        return {free_[0] ? first.value.value_or(0.0) : 0.0, free_[1] ? second.value.value_or(0.0) : 0.0, 0.0};
    }
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
        const bool alone = is_free(axis) && free_count() == 1;
        if (alone) return first.value.value_or(0.0) * direction_of(axis);
    }
    const double length = glm::length(along);
    const Axis usual = free_[0] ? Axis::x : Axis::y;
    return first.value.value_or(0.0) * (length > 1e-9 ? along / length : direction_of(usual));
}

Scene ObjectDrag::turned_by(double angle) const {
    if (grip_ == Grip::turn) return turned(*scene_, chosen_, start_, angle);
    Scene scene = *scene_;
    const ObjectIds objects = objects_of(scene, chosen_);
    for (Luminaire& luminaire : scene.luminaires)
        if (std::find(objects.begin(), objects.end(), luminaire.id) != objects.end())
            luminaire.tilt = std::remainder(luminaire.tilt + angle, 2.0 * std::numbers::pi);
    return scene;
}

Scene ObjectDrag::at(const Ray& ray, const Keys& keys, double catching) {
    if (keys.axis) lock(*keys.axis, ray);
    type(keys);
    const bool snaps = snap_.on != keys.frees;
    caught_.clear();
    if (is_turn(grip_)) {
        const std::optional<double> now = angle_to(ray);
        if (now) angle_ = std::remainder(*now - angle_at_, 2.0 * std::numbers::pi);
        if (snaps) angle_ = snapped(angle_, turn_raster);
        if (!typed_.empty()) angle_ = figure_of(typed_, true).value.value_or(0.0) * std::numbers::pi / 180.0;
        return turned_by(angle_);
    }
    const std::optional<Vec3> now = met(ray);
    if (now) {
        Vec3 wished = start_ + (*now - grip_at_);
        for (int k = 0; k < 3; ++k)
            if (!free_[k]) wished[k] = start_[k];  // to the last digit
        const Snapped caught = snaps ? snapped(wished, lines_, snap_, catching, free_) : Snapped{wished, {}};
        place_ = caught.place;
        caught_ = caught.caught;
    }
    if (!typed_.empty()) {
        place_ = start_ + typed_move(place_ - start_);
        caught_.clear();
    }
    return moved(*scene_, chosen_, place_ - start_);
}

std::string ObjectDrag::step() const {
    const char* const verb = grip_ == Grip::turn ? "Turn " : grip_ == Grip::tilt ? "Tilt " : "Move ";
    return verb + words_for(*scene_, chosen_);
}

std::string ObjectDrag::fault() const {
    if (typed_.empty()) return {};
    const std::size_t border = typed_.find(';');
    const Calculated first = figure_of(std::string_view(typed_).substr(0, border), is_turn(grip_));
    if (!first.value || border == std::string::npos) return first.fault;
    return figure_of(std::string_view(typed_).substr(border + 1), false).fault;
}

std::string ObjectDrag::readout() const {
    if (is_turn(grip_)) {
        const std::string angle = fmt::format("{:+.1f}°", angle_ * 180.0 / std::numbers::pi);
        return typed_.empty() ? angle : fmt::format("{}▏  {}", typed_, angle);
    }
    const Vec3 by = place_ - start_;
    std::string text;
    constexpr const char* names[] = {"x", "y", "z"};
    for (int k = 0; k < 3; ++k) {
        if (!free_[k]) continue;
        const std::string sign = by[k] < 0.0 ? "" : "+";
        text += fmt::format("{}{} {}{}", text.empty() ? "" : "   ", names[k], sign, with_unit(by[k], "m", 2));
    }
    return typed_.empty() ? text : fmt::format("{}▏  {}", typed_, text);
}

}  // namespace hanei
