/// A figure and by how much it may be off.
#pragma once

namespace hanei {

struct Estimate {
    double value = 0.0;
    double error = 0.0;  ///< 0: exact to rounding
};

}  // namespace hanei
