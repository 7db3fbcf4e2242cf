/// Luminaires that shine from the opening of a photometric file, and from how far they are points.
#pragma once

#include "engine/scene/point_certificate.h"
#include "engine/scene/scene.h"

#include <optional>
#include <string>

namespace hanei {

/// The opening with extent that a luminaire shines from by a photometric file.
struct MeasuredForm {
    const Photometry* photometry;  ///< of the scene
    OpeningForm form;
};
std::optional<MeasuredForm> measured_opening_of(const Scene& scene, const Luminaire& luminaire);

struct MeasuredOpenings {
    int luminaires = 0;  ///< that give light from an opening with extent by a photometric file
    std::string why;     ///< one sentence: from where on each kind is a point, and what that costs at most
};

/// Cost      1 ms a photometric file in use.
MeasuredOpenings measured_openings(const Scene& scene);

}  // namespace hanei
