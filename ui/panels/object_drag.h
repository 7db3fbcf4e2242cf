/// One drag of what is chosen, from press to release: along axes, in planes, about the vertical.
#pragma once

#include "ui/panels/drag.h"
#include "ui/panels/snapping.h"

#include <string>
#include <vector>

namespace hanei {

/// What of the handles is held. Objects themselves are held in the horizontal plane.
enum class Grip { plane_xy, plane_xz, plane_yz, x, y, z, turn, tilt };

/// While it lasts: X, Y or Z keeps it to that axis (again: frees it), a typed figure says how far it
/// goes ("1.25", "0.6; 1.2" in x and y, degrees for turns), Enter ends it, Escape takes it back.
///
/// Holds     the scene as it was at the press; every frame is made from that one.
class ObjectDrag {
public:
    struct Keys {
        std::optional<Axis> axis;
        std::string letters;  ///< typed
        bool erases = false;  ///< Backspace
        bool frees = false;   ///< held: the raster and the lines do the opposite of what is set
    };

    /// Empty when it cannot be dragged from here: nothing chosen has a place, or the plane or axis is
    /// seen end on. `reach` (m) is how far a place may lie from the eye.
    static std::optional<ObjectDrag> begin(SceneSnapshot scene, ObjectIds chosen, Grip grip, const Ray& ray,
                                           double reach, const SnapSettings& snap);

    /// The scene for the pointer at this ray; lines catch within `catching` metres.
    Scene at(const Ray& ray, const Keys& keys, double catching);

    Grip grip() const { return grip_; }
    const ObjectIds& chosen() const { return chosen_; }
    const Vec3& start() const { return start_; }
    const Vec3& place() const { return place_; }  ///< where what is held is
    bool is_free(Axis axis) const { return free_[static_cast<int>(axis)]; }
    const std::vector<SnapLine>& caught() const { return caught_; }
    std::string step() const;     ///< "Move 4 luminaires"
    std::string readout() const;  ///< "+1.25  -0.30 m", "45.0°", what is typed
    std::string fault() const;    ///< why what is typed means nothing; empty when it does not or does

private:
    int free_count() const { return int{free_[0]} + int{free_[1]} + int{free_[2]}; }
    std::optional<Vec3> met(const Ray& ray) const;
    std::optional<double> angle_to(const Ray& ray) const;
    void lock(Axis axis, const Ray& ray);
    void type(const Keys& keys);
    Scene turned_by(double angle) const;
    Vec3 typed_move(const Vec3& along) const;

    SceneSnapshot scene_;
    ObjectIds chosen_;
    Grip grip_ = Grip::plane_xy;
    bool free_[3] = {true, true, false};
    bool own_free_[3] = {true, true, false};  ///< without a lock
    SnapSettings snap_;
    std::vector<SnapLine> lines_, caught_;
    Vec3 start_{0.0}, place_{0.0};
    Vec3 grip_at_{0.0};      ///< where plane or axis was first met
    double angle_at_ = 0.0;  ///< rad, of the pointer at first
    double angle_ = 0.0;     ///< rad, turned by
    double yaw_ = 0.0;       ///< of the luminaire that is tilted
    double reach_ = 100.0;
    std::string typed_;
};

}  // namespace hanei
