#include "engine/scene/intensity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

namespace hanei {
namespace {

/// Degrees by which rounding may carry a direction past the last angle of a table: without it the
/// horizon itself would be dark for a file that ends at 90.
constexpr double at_the_end = 1e-9;

/// Two neighbouring angles of a table and the weight of the second one.
struct Between {
    std::size_t first = 0;
    std::size_t second = 0;
    double weight = 0.0;
    bool outside = false;
};

Between between(const std::vector<double>& angles, double angle) {
    if (angle < angles.front() - at_the_end || angle > angles.back() + at_the_end) return {0, 0, 0.0, true};
    const auto next = std::upper_bound(angles.begin(), angles.end(), angle);
    if (next == angles.begin()) return {};
    const auto k = static_cast<std::size_t>(std::distance(angles.begin(), next)) - 1;
    if (next == angles.end()) return {k, k, 0.0, false};
    return {k, k + 1, (angle - angles[k]) / (angles[k + 1] - angles[k]), false};
}

/// `angle` counted from `start` upward, within a full circle.
double from(double start, double angle) {
    const double turned = std::fmod(angle - start, 360.0);
    return turned < 0.0 ? turned + 360.0 : turned;
}

/// Folds an angle into the half circle that begins at the mirror plane `start`.
double mirrored(double start, double angle) {
    const double turned = from(start, angle);
    return start + (turned > 180.0 ? 360.0 - turned : turned);
}

/// Planes that cover the full circle: the last one joins the first.
Between around(const std::vector<double>& planes, double plane) {
    const double turned = planes.front() + from(planes.front(), plane);
    if (turned <= planes.back()) return between(planes, turned);
    const double gap = planes.front() + 360.0 - planes.back();
    return {planes.size() - 1, 0, (turned - planes.back()) / gap, false};
}

Between plane_between(const Photometry& photometry, double plane) {
    const std::vector<double>& planes = photometry.horizontal_deg;
    // Files write 89.999 for 90: what is folded to the mirror plane itself must find the last plane.
    const auto folded_to = [&planes](double angle) {
        return between(planes, std::clamp(angle, planes.front(), planes.back()));
    };
    switch (photometry.symmetry) {
        case PhotometricSymmetry::rotational:
            return {};
        case PhotometricSymmetry::quadrant: {
            const double folded = mirrored(0.0, plane);
            return folded_to(folded > 90.0 ? 180.0 - folded : folded);
        }
        case PhotometricSymmetry::plane_0:
            if (photometry.type != PhotometricType::C) return between(planes, std::abs(plane));
            [[fallthrough]];
        case PhotometricSymmetry::plane_90:
            return folded_to(mirrored(planes.front(), plane));
        case PhotometricSymmetry::none:
            break;
    }
    return photometry.type == PhotometricType::C ? around(planes, plane) : between(planes, plane);
}

}  // namespace

Vec3 in_file_frame(const Photometry& photometry, const Vec3& direction) {
    switch (photometry.quarter_turns & 3) {
        case 1:
            return {direction.y, -direction.x, direction.z};
        case 2:
            return {-direction.x, -direction.y, direction.z};
        case 3:
            return {-direction.y, direction.x, direction.z};
        default:
            return direction;
    }
}

LuminousIntensity intensity(const Photometry& photometry, const Vec3& direction) {
    const PhotometricAngles angles = photometric_angles(photometry.type, in_file_frame(photometry, direction));
    const Between vertical = between(photometry.vertical_deg, angles.vertical_deg);
    if (vertical.outside) return {};
    const Between plane = plane_between(photometry, angles.horizontal_deg);
    if (plane.outside) return {};
    const auto in_plane = [&](std::size_t number) {
        const double* candela = photometry.candela.data() + number * photometry.vertical_deg.size();
        return candela[vertical.first] + vertical.weight * (candela[vertical.second] - candela[vertical.first]);
    };
    const double first = in_plane(plane.first);
    return {first + plane.weight * (in_plane(plane.second) - first)};
}

LuminousIntensity peak_intensity(const Photometry& photometry) {
    return {*std::max_element(photometry.candela.begin(), photometry.candela.end())};
}

PhotometricAngles peak_angles(const Photometry& photometry) {
    const auto peak = std::max_element(photometry.candela.begin(), photometry.candela.end());
    const auto place = static_cast<std::size_t>(std::distance(photometry.candela.begin(), peak));
    const std::size_t row = photometry.vertical_deg.size();
    return {photometry.horizontal_deg[place / row], photometry.vertical_deg[place % row]};
}

double lamp_tilt_factor(const Photometry& photometry, double tilt) {
    if (!photometry.tilt || photometry.tilt->geometry == 2) return 1.0;
    const LampTilt& lamp = *photometry.tilt;
    if (lamp.angle_deg.empty() || lamp.angle_deg.size() != lamp.factor.size()) return 1.0;
    const double angle = std::clamp(tilt * 180.0 / std::numbers::pi, lamp.angle_deg.front(), lamp.angle_deg.back());
    const Between place = between(lamp.angle_deg, angle);
    return lamp.factor[place.first] + place.weight * (lamp.factor[place.second] - lamp.factor[place.first]);
}

Photometry with_lamp_set(Photometry photometry, std::size_t set) {
    const double before = photometry.lamp_sets[photometry.lamp_set].lumens;
    const LampSet& lamps = photometry.lamp_sets[set];
    if (before > 0.0 && lamps.lumens > 0.0) {
        const double share = lamps.lumens / before;
        for (double& candela : photometry.candela) candela *= share;
        photometry.candela_per_figure *= share;
    }
    photometry.absolute = lamps.count < 0.0;
    photometry.lamps = static_cast<int>(std::clamp(std::abs(lamps.count), 0.0, 1e6));
    photometry.lamp_lumens = photometry.absolute ? 0.0 : lamps.lumens;
    photometry.input_watts = lamps.watts;
    photometry.lamp_set = set;
    return photometry;
}

}  // namespace hanei
