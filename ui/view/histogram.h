/// How much area has how much light.
#pragma once

#include "ui/view/view_options.h"

#include <optional>
#include <vector>

namespace hanei {

struct LightHistogram {
    struct Bin {
        double low = 0.0, high = 0.0;  ///< lx
        double area = 0.0;             ///< m2
    };
    std::vector<Bin> bins;  ///< equally wide on the scale's steps (in ratios on a logarithmic scale)
    double area = 0.0;      ///< m2, all of it, bins or not
    double mean = 0.0, least = 0.0, greatest = 0.0;  ///< lx

    struct Sample {
        double lux = 0.0, area = 0.0;
    };
    std::vector<Sample> samples;  ///< the darkest first

    double uniformity() const { return mean > 0.0 ? least / mean : 0.0; }
    double share_above(double lux) const;  ///< 0 to 1 of the area
};

/// Of the points of a grid, each for its cell, or without one of all that a picture shows. Empty bins and
/// no area where there are no values of the part.
LightHistogram histogram_of(const Solution& solution, ObjectId grid, const ViewOptions& options, int bins = 48);

}  // namespace hanei
