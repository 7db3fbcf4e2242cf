#include "engine/study/calibration.h"

namespace hanei {

// Measured on the computer room: some thirty solids, two panels, 400 points. Two threads of 2026.
const std::vector<CalibrationSample>& usual_samples() {
    static const std::vector<CalibrationSample> samples{
        {Method::paper, 346, 0, {2.3e5, 6.4e3, 107, 2.3, 44}, 0.8},
        {Method::paper, 1938, 0, {4.6e4, 4.7e3, 18, 0.9, 12}, 0.7},
        {Method::paper_closed, 346, 0, {2.9e5, 7.6e3, 321, 2.6, 43}, 0.126},
        {Method::paper_closed, 1938, 0, {5.6e4, 4.7e3, 41, 0.7, 13}, 0.077},
        {Method::patch, 300, 0, {3.0e5, 5.0e3, 78, 0.8, 50}, 0.081},
        {Method::patch, 420, 0, {2.5e5, 6.0e3, 55, 0.5, 36}, 0.039},
        {Method::patch, 880, 0, {1.2e5, 4.0e3, 27, 0.3, 17}, 0.015},
        {Method::patch, 1938, 0, {4.7e4, 4.6e3, 14, 0.3, 12}, 0.007},
        {Method::patch, 6688, 0, {1.5e4, 3.4e3, 3.8, 0.1, 4.1}, 0.002},
        {Method::linear, 1168, 0, {3.0e5, 2.8e5, 350, 12, 555}, 0.002},
        {Method::linear, 2464, 0, {1.4e5, 8.8e4, 60, 2.5, 138}, 0.001},
    };
    return samples;
}

}  // namespace hanei
