/// How bright every part of a scene can be at most, and what light that is left out could add anywhere.
#pragma once

#include "engine/plan/ceiling_cells.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hanei {

/// What leaves the cells at most: nowhere more than `exitance` (lm/m2, one a cell), and in all no more than
/// `flux` (lm).
struct LeavingLight {
    std::vector<double> exitance;
    double flux = 0.0;

    LeavingLight& operator+=(const LeavingLight& other);
};

/// Indices of what shines, the brightest first.
std::vector<std::size_t> brightest_first(std::span<const double> exitance);

/// All cells as they are seen from a place, or from anywhere in a cell.
class SeenCells {
public:
    template <class Place>
    SeenCells(const Place& place, std::span<const CeilingCell> cells) {
        seen_.reserve(cells.size());
        for (const CeilingCell& cell : cells) seen_.push_back(most_seen(place, cell));
        sort();
    }
    void hide(std::size_t cell) { seen_[cell] = {}; }

    /// lx at most, the less of two bounds. The hemisphere filled with the brightest, each as far as it can be
    /// seen; all flux in the cells that are nearest, each with no more than it can show.
    double arriving(const LeavingLight& light, std::span<const std::size_t> brightest) const;

private:
    void sort();
    std::vector<SeenSource> seen_;
    std::vector<std::uint32_t> nearest_;  ///< the greatest kernels first
};

/// Bounds of the exact solution from the scene alone, with nothing in the way of any light.
///
/// A place sees of each cell at most so much, and of all together at most the hemisphere: the most light
/// that this lets arrive (SeenCells) is a bound. With it the balance B = own + rho (direct + arriving B) is
/// iterated from above, where every step stays a bound.
///
/// Cost      some hundred cells, their pairs once (5 ms), and 0.1 ms a step.
class LightCeiling {
public:
    LightCeiling(const Scene& scene, std::span<const Face> faces);

    std::span<const CeilingCell> cells() const { return cells_; }
    bool is_bounded() const { return bounded_; }  ///< false: nothing can be said, every bound is infinite

    const LeavingLight& leaving() const { return leaving_; }  ///< all light, photometric

    /// What is missing at most when a piece of furniture reflects nothing: its own light,
    /// and what others reflect of it.
    LeavingLight without_reflection_of(ObjectId piece) const;

    /// ... when one band stands for the three: how far the luminance of what leaves may be off.
    LeavingLight without_colour() const;

    /// lx that light leaving the cells like this can bring at most to any place of a cell.
    double arriving(std::size_t cell, const LeavingLight& light) const;

private:
    LeavingLight reflected(const LeavingLight& light, std::span<const double> reflectance) const;
    LeavingLight settled(const LeavingLight& start, std::span<const double> reflectance, int reflections) const;
    LeavingLight unbounded() const;
    std::vector<double> reflectances(int band) const;

    std::vector<CeilingCell> cells_;
    std::vector<SeenCells> seen_;                   ///< from each cell
    std::vector<std::vector<double>> direct_;       ///< lx by band, at most in each cell
    std::vector<std::vector<double>> off_white_;    ///< ... of how far a band of it is from the photometric figure
    std::vector<std::vector<double>> illuminance_;  ///< lx by band, direct and interreflected
    LeavingLight leaving_;
    double emitted_ = 0.0, own_ = 0.0;  ///< lm, of luminaires in any band; of surfaces by themselves
    int bands_ = 1;
    bool bounded_ = true;
};

/// Exitances that skipped effects leave out at most, and what they could bring anywhere.
struct MissingLight {
    std::shared_ptr<const LightCeiling> ceiling;
    LeavingLight light;

    double at(const Vec3& position, const Vec3& normal) const;  ///< lx
    double anywhere() const;                                    ///< lx on any surface
};

}  // namespace hanei
