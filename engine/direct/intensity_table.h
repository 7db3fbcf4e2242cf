/// A photometric table made ready for very many questions.
#pragma once

#include "engine/base/vector.h"
#include "engine/scene/photometry.h"

#include <cstdint>
#include <vector>

namespace hanei {

/// The same bilinear figures as intensity() of the scene, to rounding: symmetry is unfolded into
/// planes all around, and a table of even steps says where among the angles to begin.
///
/// Needs     a table that hangs together (intensity.h).
/// Holds     its own copy. Types A and B, and planes outside the range of their symmetry, are asked of
///           intensity() itself.
/// Cost      two arc tangents; one for a rotational table.
class IntensityTable {
public:
    explicit IntensityTable(Photometry photometry);

    /// Candela towards a direction of any length in the luminaire's frame.
    double candela(const Vec3& direction) const;

    const Photometry& photometry() const { return photometry_; }
    double peak() const { return peak_; }  ///< candela

private:
    /// Increasing angles with the place to begin at for every step of the way.
    class Angles {
    public:
        Angles() = default;
        explicit Angles(std::vector<double> angles);

        struct Place {
            std::size_t first = 0;
            double weight = 0.0;  ///< of the next one
        };
        /// Needs     at least two angles. An angle past either end gives that end.
        Place place_of(double angle) const;
        double front() const { return angles_.front(); }
        double back() const { return angles_.back(); }

    private:
        Place search(double angle, std::size_t step) const;

        std::vector<double> angles_, inverse_width_;
        std::vector<std::uint32_t> begin_;
        double steps_a_degree_ = 0.0;
        bool even_ = false;  ///< every step is one interval
    };

    bool unfold();
    void add_plane(std::vector<double>& planes, double angle, std::size_t stored);
    double in_plane(std::size_t plane, const Angles::Place& vertical) const;

    Photometry photometry_;
    Angles vertical_, planes_;
    std::vector<std::size_t> row_of_;  ///< of unfolded planes: where their candela begin
    double peak_ = 0.0;
    bool prepared_ = false;
};

}  // namespace hanei
