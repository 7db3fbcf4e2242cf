/// The light under the mouse.
#pragma once

#include "engine/solution/solution.h"
#include "ui/view/camera.h"

#include <optional>
#include <string>

namespace hanei {

struct Probe {
    Vec3 position{0.0};
    PointValue value;
    std::string surface;  ///< "Floor", "Desk 3"
    Vec3 normal{0.0, 0.0, 1.0};

    std::string text() const;  ///< "412 lx ± 3 (iteration 1, mesh 2) · direct 300 · interreflected 112 · Floor"
};

/// The parts of an error bar that matter, greatest first: "mesh 2, iteration 1". Empty where there is
/// no error or no bound.
std::string causes(const ErrorBar& error);

/// What the room calls a face.
std::string surface_name(const Scene& scene, const SurfaceRef& surface);

/// Gathered at the place itself, with its error bar. Empty where the ray meets nothing.
std::optional<Probe> probe_at(const Solution& solution, const Ray& ray);

/// A figure with the digits its size deserves: 3 significant ones, none after the point from 100.
std::string short_figure(double value);

}  // namespace hanei
