/// Light between the floor, the ceiling and level bands of the walls of a box, each of one exitance.
#pragma once

#include <vector>

namespace hanei {

/// Of two equal rectangles, parallel and straight above each other: the form factor from one to the
/// other (any table of configuration factors; 1 at no distance).
double parallel_form_factor(double length, double width, double distance);

class BoxBalance {
public:
    /// `borders` are the heights, m, between which the bands of the walls lie: from the floor's to the
    /// ceiling's, increasing.
    BoxBalance(double length, double width, std::vector<double> borders);

    std::size_t bands() const { return borders_.size() - 1; }
    double floor_area() const { return length_ * width_; }
    double band_area(std::size_t band) const;

    struct Reflectances {
        double floor = 0.2, ceiling = 0.7, walls = 0.5;
    };
    /// Direct flux, lm, on the floor, the ceiling and each band.
    struct Direct {
        double floor = 0.0, ceiling = 0.0;
        std::vector<double> bands;
    };

    /// lm that reach the level `height` from above by way of surfaces, after any number of reflections.
    /// `height` is one of the borders. Reflectances count as 0.99 at most.
    double reflected_through(double height, const Direct& direct, const Reflectances& reflectances) const;

private:
    double through(double distance) const;  ///< m2 exchanged between cross-sections this far apart
    double exchange(std::size_t one, std::size_t other) const;

    double length_, width_;
    std::vector<double> borders_;
};

}  // namespace hanei
