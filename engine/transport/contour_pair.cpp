#include "engine/transport/contour_pair.h"

#include "engine/geometry/polygon.h"

#include <array>
#include <cmath>
#include <numbers>

namespace hanei {

namespace {

/// x ln r - x + h atan(x / h) with r the length of (x, h): the primitive of ln r along a line at the
/// distance h.
double log_primitive(double x, double h) {
    const double square = x * x + h * h;
    if (square == 0.0) return 0.0;
    return 0.5 * x * std::log(square) - x + h * std::atan2(x, h);
}

/// Integral of ln(distance from `place` / unit) along every edge of `loop`, times the edge's
/// direction: a vector.
Vec3 log_distance_along(const Polygon& loop, const Vec3& place, double unit) {
    Vec3 sum(0.0);
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec3 edge = loop[(k + 1) % loop.size()] - loop[k];
        const double length = glm::length(edge);
        if (length == 0.0) continue;
        const Vec3 direction = edge / length;
        const Vec3 start = (loop[k] - place) / unit;
        const double x = glm::dot(start, direction);
        const double h = glm::length(start - x * direction);
        sum += (log_primitive(x + length / unit, h) - log_primitive(x, h)) * edge / (length / unit);
    }
    return sum;
}

struct KronrodPoint {
    double place, weight, gauss;  ///< Gauss weight 0 at the points that only Kronrod's rule has
};
// Gauss-Kronrod (7, 15) on [-1, 1], one half; Kronrod 1965.
constexpr std::array<KronrodPoint, 8> kronrod = {
    {{0.991455371120812639206854697526329, 0.022935322010529224963732008058970, 0.0},
     {0.949107912342758524526189684047851, 0.063092092629978553290700663189204, 0.129484966168869693270611432679082},
     {0.864864423359769072789712788640926, 0.104790010322250183839876322541518, 0.0},
     {0.741531185599394439863864773280788, 0.140653259715525918745189590510238, 0.279705391489276667901467771423780},
     {0.586087235467691130294144691693013, 0.169004726639267902826583426598550, 0.0},
     {0.405845151377397166906606412076961, 0.190350578064785409913256402421014, 0.381830050505118944950369775488975},
     {0.207784955007898467600689403773245, 0.204432940075298892414161999234649, 0.0},
     {0.0, 0.209482141084727828012999174891714, 0.417959183673469387755102040816327}}};

/// The outer integral over the part [low, high] of an edge, halved until both rules agree.
class OuterEdge {
public:
    OuterEdge(const Polygon& loop, const Vec3& from, const Vec3& to, double unit, double accuracy)
        : loop_(loop), from_(from), edge_(to - from), unit_(unit), accuracy_(accuracy) {}

    double integral(double low, double high, int depth) const {
        const double middle = 0.5 * (low + high);
        const double half = 0.5 * (high - low);
        double fine = 0.0;
        double coarse = 0.0;
        for (const KronrodPoint& point : kronrod) {
            const double value =
                point.place == 0.0 ? at(middle) : at(middle - half * point.place) + at(middle + half * point.place);
            fine += point.weight * value;
            coarse += point.gauss * value;
        }
        constexpr int deepest = 48;  // an interval of 1e-15 of the edge: ln r is integrable there
        if (std::abs(fine - coarse) * half <= accuracy_ || depth == deepest) return fine * half;
        return integral(low, middle, depth + 1) + integral(middle, high, depth + 1);
    }

private:
    double at(double t) const { return glm::dot(edge_, log_distance_along(loop_, from_ + t * edge_, unit_)); }

    const Polygon& loop_;
    Vec3 from_;
    Vec3 edge_;
    double unit_;
    double accuracy_;
};

}  // namespace

double contour_exchange(const Polygon& from, const Polygon& to) {
    // with distances near 1 the logarithms are small; their common part cancels around a loop
    const double apart = glm::length(centroid(from) - centroid(to));
    const double unit = apart > 0.0 ? apart : 1.0;
    const double accuracy = 1e-14 * glm::length(vector_area(from));
    double sum = 0.0;
    for (std::size_t k = 0; k < from.size(); ++k) {
        sum += OuterEdge(to, from[k], from[(k + 1) % from.size()], unit, accuracy).integral(0.0, 1.0, 0);
    }
    return sum / (2.0 * std::numbers::pi);
}

}  // namespace hanei
