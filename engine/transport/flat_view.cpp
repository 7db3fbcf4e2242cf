#include "engine/transport/flat_view.h"

#include "engine/geometry/four.h"

namespace hanei {

namespace {

// Radon's seven points of a triangle, in shares of two of its sides, and their weights: the middle, three
// towards the corners, three towards the sides. The eighth adds nothing.
constexpr float in = 0.10128650732F, out = 0.79742698535F;
constexpr float low = 0.05971587179F, high = 0.47014206410F, third = 0.33333333333F;
constexpr float corner = 0.06296959027F, side = 0.066197076394F, middle_one = 0.1125F;
constexpr Four along_first[2] = {{third, in, out, in}, {high, low, high, third}};
constexpr Four along_second[2] = {{third, in, in, out}, {high, high, low, third}};
constexpr Four weights[2] = {{middle_one, corner, corner, corner}, {side, side, side, 0.0F}};

struct Corner {
    double u, v;
};

Corner middle(Corner a, Corner b) { return {0.5 * (a.u + b.u), 0.5 * (a.v + b.v)}; }

/// In single precision, places seen from the eye's foot.
class Triangles {
public:
    explicit Triangles(const FlatView& view) : view_(view) {
        rise_ = static_cast<float>(view.rise_at(view.eye_u, view.eye_v));
        rise_u_ = static_cast<float>(view.rise_u);
        rise_v_ = static_cast<float>(view.rise_v);
        square_ = static_cast<float>(view.height * view.height);
    }

    double weight(Corner a, Corner b, Corner c) const {
        const double bu = b.u - a.u, bv = b.v - a.v, cu = c.u - a.u, cv = c.v - a.v;
        const auto from_u = static_cast<float>(a.u - view_.eye_u), from_v = static_cast<float>(a.v - view_.eye_v);
        Four sum{};
        for (int half = 0; half < 2; ++half) {
            const Four first = along_first[half], second = along_second[half];
            const Four u = first * static_cast<float>(bu) + second * static_cast<float>(cu) + from_u;
            const Four v = first * static_cast<float>(bv) + second * static_cast<float>(cv) + from_v;
            const Four square = u * u + v * v + square_;
            const Four rise = u * rise_u_ + v * rise_v_ + rise_;
            sum += weights[half] * (rise > 0.0F ? rise : Four{}) / (square * square);
        }
        return (bu * cv - bv * cu) * static_cast<double>((sum[0] + sum[2]) + (sum[1] + sum[3]));
    }

    double weight_in_four(Corner a, Corner b, Corner c) const {
        const Corner ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        return (weight(a, ab, ca) + weight(ab, b, bc)) + (weight(ca, bc, c) + weight(ab, bc, ca));
    }

private:
    const FlatView& view_;
    float rise_, rise_u_, rise_v_, square_;
};

}  // namespace

double FlatView::weight(const FlatLoop& loop, bool split) const {
    const Triangles triangles(*this);
    double sum = 0.0;
    for (std::size_t k = 2; k < loop.count; ++k) {
        const Corner a{loop.u[0], loop.v[0]}, b{loop.u[k - 1], loop.v[k - 1]}, c{loop.u[k], loop.v[k]};
        sum += split ? triangles.weight_in_four(a, b, c) : triangles.weight(a, b, c);
    }
    return sum;
}

}  // namespace hanei
