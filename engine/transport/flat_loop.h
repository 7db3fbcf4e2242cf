/// Convex polygons in the coordinates of a face, cut by straight lines.
#pragma once

#include <array>
#include <cstddef>

namespace hanei {

/// The places with a u + b v + c < 0; (a, b) of length 1, c in metres.
struct FlatLine {
    double a = 0.0, b = 0.0, c = 0.0;
    double height(double u, double v) const { return a * u + b * v + c; }
};

/// Up to 48 corners, in place.
struct FlatLoop {
    static constexpr std::size_t most = 48;

    std::size_t count = 0;
    std::array<double, most> u, v;

    FlatLoop() = default;
    FlatLoop(const FlatLoop& other) { *this = other; }
    FlatLoop& operator=(const FlatLoop& other) {
        count = other.count;
        for (std::size_t k = 0; k < count; k += 2) {  // a few: no call of the library for them
            u[k] = other.u[k], u[k + 1] = other.u[k + 1];
            v[k] = other.v[k], v[k + 1] = other.v[k + 1];
        }
        return *this;
    }
    void add(double at_u, double at_v) {
        u[count] = at_u;
        v[count] = at_v;
        ++count;
    }
};

/// Parts of a convex loop on either side of a line; either may be empty.
/// Needs     room for one corner more in each part.
void split(const FlatLoop& loop, const FlatLine& line, FlatLoop& inside, FlatLoop& outside);

/// Keeps what is inside the line. Needs room for one corner more.
void clip(FlatLoop& loop, const FlatLine& line);

}  // namespace hanei
