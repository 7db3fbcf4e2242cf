#include "engine/study/calibration.h"

namespace hanei {

// Measured on the computer room: some thirty solids, two panels, 400 points. Two threads of 2020.
const std::vector<CalibrationSample>& usual_samples() {
    static const std::vector<CalibrationSample> samples{
        {Method::paper, 300, 0, {1.5e4, 1.1e4, 220, 3.1, 80}, 0.8},
        {Method::paper, 880, 0, {6.7e3, 8.1e3, 55, 2.2, 33}, 0.7},
        {Method::paper_closed, 300, 0, {1.5e4, 1.2e4, 610, 2.9, 85}, 0.126},
        {Method::paper_closed, 880, 0, {6.7e3, 8.5e3, 140, 1.5, 31}, 0.077},
        {Method::patch, 300, 0, {1.5e4, 1.1e4, 123, 0.5, 78}, 0.081},
        {Method::patch, 420, 0, {1.1e4, 1.1e4, 95, 0.4, 60}, 0.039},
        {Method::patch, 880, 0, {6.6e3, 8.4e3, 41, 0.3, 31}, 0.015},
        {Method::patch, 2214, 0, {3.7e3, 4.0e3, 16, 0.3, 14}, 0.007},
        {Method::patch, 6398, 0, {2.5e3, 5.9e3, 7.1, 0.2, 9}, 0.003},
        {Method::linear, 1104, 0, {2.5e4, 5.2e5, 1060, 36, 1475}, 0.002},
        {Method::linear, 3520, 0, {4.7e4, 4.5e5, 255, 6.7, 794}, 0.001},
    };
    return samples;
}

}  // namespace hanei
