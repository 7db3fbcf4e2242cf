/// The room with direct light exact at every pixel (the paper's step 8), without OpenGL.
///
/// Every pixel has one ray through its centre; where the ray meets a surface, direct light is
/// computed at the place itself, and interreflected light is interpolated in its cell (equation 6).
/// A pixel that differs from one of its eight neighbours, by more than the eye would see or because
/// another face begins there, gets more rays in a fixed pattern and shows their mean: edges of
/// objects and of shadows are smooth, and the penumbra, which is computed and not sampled, has no
/// noise.
#pragma once

#include "engine/base/progress.h"
#include "ui/view/camera.h"
#include "ui/view/image.h"
#include "ui/view/picture_size.h"
#include "ui/view/value_buffer.h"
#include "ui/view/view_options.h"

#include <functional>
#include <optional>
#include <span>

namespace hanei {

/// Writes the direct illuminance, lx, of every receiver. Called from several threads at once, with
/// receivers of one face that lie side by side. For the part without shadows it must leave them out.
using DirectLight = std::function<void(std::span<const Receiver> receivers, std::span<double> lux)>;

struct ExactRequest {
    Camera camera;
    ViewOptions options;
    PixelSize size;    ///< of the view of the room: no legend, no caption
    int samples = 16;  ///< rays a pixel where neighbours differ; 1: one everywhere
};

struct ExactPicture {
    Image room;               ///< surfaces and isolux lines alone; transparent where nothing is seen
    ValueBuffer values;       ///< at the pixels' centres
    std::size_t refined = 0;  ///< pixels with more than one ray
};

/// Needs     a solution with a mesh and a display mesh that holds the part (has_part); threads >= 1.
/// Returns   empty when stopped. The same bits on any number of threads.
/// Cost      a ray 0.5 us, and a place of a surface what direct light costs there.
std::optional<ExactPicture> exact_picture(const Solution& solution, const DirectLight& direct,
                                          const ExactRequest& request, const Work& work);

}  // namespace hanei
