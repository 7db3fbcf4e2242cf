/// The near field by its definition, summed over a fine lattice: slow, and written without the engine.
#pragma once

#include "engine/scene/intensity.h"
#include "engine/scene/opening_shape.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace hanei::testing {

/// Where a receiver is in the luminaire's frame.
struct LocalReceiver {
    Vec3 position{0.0};
    Vec3 normal{0.0, 0.0, 1.0};
};

/// True when a place of the opening is hidden.
using Hidden = std::function<bool(const Vec3& place)>;

/// Visits the middles of a lattice of n x n cells over the parallelogram centre +- u +- v.
template <class Visit>
void over_parallelogram(const Vec3& centre, const Vec3& u, const Vec3& v, int n, Visit&& visit) {
    const double area = 4.0 * glm::length(glm::cross(u, v)) / (n * n);
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < n; ++k)
            visit(centre + u * ((2.0 * i + 1.0) / n - 1.0) + v * ((2.0 * k + 1.0) / n - 1.0), area);
    }
}

/// Visits about n x n cells of a convex polygon, in triangles about its first corner's fan.
template <class Visit>
void over_polygon(const Polygon& polygon, int n, Visit&& visit) {
    Vec3 middle{0.0};
    for (const Vec3& corner : polygon) middle += corner / static_cast<double>(polygon.size());
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec3 a = polygon[k] - middle, b = polygon[(k + 1) % polygon.size()] - middle;
        const double area = 0.5 * glm::length(glm::cross(a, b)) / (n * n);
        for (int i = 0; i < n; ++i) {
            for (int j = 0; j < n; ++j) {
                const double s = std::sqrt((i + 0.5) / n), t = (j + 0.5) / n;
                visit(middle + s * ((1.0 - t) * a + t * b), area);
            }
        }
    }
}

/// I cos / r2 of an element, nothing above the receiver's horizon.
inline double arriving(const Photometry& photometry, const LocalReceiver& at, const Vec3& place) {
    const Vec3 away = at.position - place;
    const double distance = glm::length(away), height = -glm::dot(away, at.normal);
    if (!(height > 0.0)) return 0.0;
    return intensity(photometry, away / distance).value * height / (distance * distance * distance);
}

/// A flat opening: every element has its share in the area.
inline double flat_sum(const Photometry& photometry, const Polygon& opening, const LocalReceiver& at, int n,
                       const Hidden& hidden = nullptr) {
    double sum = 0.0, all = 0.0;
    over_polygon(opening, n, [&](const Vec3& place, double area) {
        all += area;
        if (!hidden || !hidden(place)) sum += area * arriving(photometry, at, place);
    });
    return sum / all;
}

/// One luminous face of a solid, `front` its outward normal: every element that faces the receiver has
/// its share in the projected area.
inline double face_share(const Photometry& photometry, const OpeningSolid& solid, const LocalReceiver& at,
                         const Vec3& place, const Vec3& front) {
    const Vec3 away = glm::normalize(at.position - place);
    const double facing = glm::dot(front, away);
    return facing > 0.0 ? facing / solid.projected_area(away) * arriving(photometry, at, place) : 0.0;
}

inline double box_sum(const Photometry& photometry, const OpeningSolid& box, const LocalReceiver& at, int n,
                      const Hidden& hidden = nullptr) {
    double sum = 0.0;
    const auto face = [&](const Vec3& centre, const Vec3& u, const Vec3& v, const Vec3& front) {
        over_parallelogram(centre, u, v, n, [&](const Vec3& place, double area) {
            if (!hidden || !hidden(place)) sum += area * face_share(photometry, box, at, place, front);
        });
    };
    const Vec3 h = box.half;
    face({0, 0, -h.z}, {h.x, 0, 0}, {0, h.y, 0}, {0, 0, -1});
    face({0, 0, h.z}, {h.x, 0, 0}, {0, h.y, 0}, {0, 0, 1});
    for (int side = 0; side < 4; ++side) {
        const double sign = side < 2 ? 1.0 : -1.0, up = 0.5 * box.sides[static_cast<std::size_t>(side)];
        const Vec3 front = side % 2 == 0 ? Vec3{sign, 0, 0} : Vec3{0, sign, 0};
        const Vec3 along = side % 2 == 0 ? Vec3{0, h.y, 0} : Vec3{h.x, 0, 0};
        face(front * h + Vec3{0, 0, up - h.z}, along, {0, 0, up}, front);
    }
    return sum;
}

/// Cylinders (elliptic, any axis) and ellipsoids by their own parameters.
inline double round_sum(const Photometry& photometry, const OpeningSolid& solid, const LocalReceiver& at, int n,
                        const Hidden& hidden = nullptr) {
    using std::numbers::pi;
    double sum = 0.0;
    const auto element = [&](const Vec3& place, const Vec3& vector_area) {
        if (hidden && hidden(place)) return;
        const double area = glm::length(vector_area);
        sum += area * face_share(photometry, solid, at, place, vector_area / area);
    };
    const int around = 4 * n;
    if (solid.kind == OpeningSolid::Kind::ellipsoid) {
        for (int i = 0; i < 2 * n; ++i) {
            for (int k = 0; k < around; ++k) {
                const double z = (i + 0.5) / n - 1.0, turn = 2.0 * pi * (k + 0.5) / around,
                             level = std::sqrt(1.0 - z * z);
                const Vec3 unit{level * std::cos(turn), level * std::sin(turn), z}, h = solid.half;
                element(unit * h, unit * Vec3{h.y * h.z, h.x * h.z, h.x * h.y} * (4.0 * pi / (2.0 * n * around)));
            }
        }
        return sum;
    }
    const int c = solid.axis, a = (c + 1) % 3, b = (c + 2) % 3;
    const auto local = [&](double x, double y, double z) {
        Vec3 v;
        v[a] = x, v[b] = y, v[c] = z;
        return v;
    };
    for (int k = 0; k < around; ++k) {
        const double turn = 2.0 * pi * (k + 0.5) / around, x = std::cos(turn), y = std::sin(turn);
        const double ha = solid.half[a], hb = solid.half[b], hc = solid.half[c];
        for (int i = 0; i < n; ++i) {
            const double z = (2.0 * i + 1.0) / n - 1.0;
            element(local(ha * x, hb * y, hc * z), local(hb * x, ha * y, 0) * (2.0 * pi / around * 2.0 * hc / n));
            const double out = std::sqrt((i + 0.5) / n), cap = pi * ha * hb / (around * n);
            element(local(out * ha * x, out * hb * y, -hc), local(0, 0, -cap));
            element(local(out * ha * x, out * hb * y, hc), local(0, 0, cap));
        }
    }
    return sum;
}

/// Whatever opening the file states; a point by the inverse square law.
inline double opening_sum(const Photometry& photometry, const LocalReceiver& at, int n,
                          const Hidden& hidden = nullptr) {
    if (is_solid(photometry.opening)) {
        const OpeningSolid solid = solid_opening(photometry.opening);
        return solid.kind == OpeningSolid::Kind::box ? box_sum(photometry, solid, at, n, hidden)
                                                     : round_sum(photometry, solid, at, n, hidden);
    }
    const Polygon flat = flat_opening(photometry.opening);
    if (flat.empty()) return hidden && hidden(Vec3{0.0}) ? 0.0 : arriving(photometry, at, Vec3{0.0});
    return flat_sum(photometry, flat, at, flat.size() > 4 ? (n + 1) / 2 : n, hidden);
}

}  // namespace hanei::testing
