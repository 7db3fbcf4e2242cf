/// Why it is as bright here as it is: the light at one place, divided by where it came from.
#pragma once

#include "engine/base/progress.h"
#include "engine/solution/solution.h"

#include <optional>
#include <vector>

namespace hanei {

/// The same illuminance divided in four ways. Each way adds up to the value; all figures are lx as the
/// scene is dimmed, ranked with the greatest first.
struct Contributions {
    SolutionSnapshot solution;  ///< what was asked about
    Vec3 position{0.0};
    Vec3 normal{0.0, 0.0, 1.0};
    PointValue value;  ///< with its error bar; inside a solid there is nothing to divide

    /// Straight from each luminaire.
    struct OfLuminaire {
        ObjectId luminaire;
        ObjectId group;  ///< the ControlGroup that dims it; may be none
        double direct = 0.0;
    };
    std::vector<OfLuminaire> luminaires;

    /// Straight, and by way of surfaces, from luminaires that are dimmed together. Luminaires without a
    /// group are alone where that is known of them, else together.
    struct OfGroup {
        ObjectId group;                    ///< none: of no ControlGroup
        std::vector<ObjectId> luminaires;  ///< none: the surfaces that shine by themselves
        double direct = 0.0;
        double interreflected = 0.0;
        double total() const { return direct + interreflected; }
    };
    std::vector<OfGroup> groups;

    /// By how often it was reflected on its way; not ranked.
    struct OfBounce {
        int reflections = 1;  ///< 0: straight from surfaces that shine by themselves
        double lux = 0.0;
    };
    std::vector<OfBounce> bounces;
    double later_bounces = 0.0;  ///< of all after those

    /// What arrives from each face of the room, of furniture and of free surfaces, reflected or its own.
    struct OfSurface {
        SurfaceRef surface;
        double lux = 0.0;
        Vec3 from{0.0};    ///< the middle of what shines here
        Vec3 normal{0.0};  ///< of the face
    };
    std::vector<OfSurface> surfaces;
};

}  // namespace hanei
