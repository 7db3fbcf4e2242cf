/// How each luminaire's light meets the patches and where its shadows end: for pictures.
#pragma once

#include "engine/mesh/light_class.h"
#include "engine/mesh/mesh.h"
#include "engine/scene/object_id.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hanei {

/// A piece of the boundary of a shadow on a face.
struct ShadowLine {
    Polygon places;          ///< one after another; closed only when the last is the first again
    std::uint32_t face = 0;  ///< into Mesh::faces
    bool umbra = false;      ///< of single bodies' umbrae; else of the penumbra
};

struct LuminaireShadows {
    ObjectId luminaire;
    std::vector<LightClass> classes;  ///< one a patch
    std::vector<ShadowLine> lines;
};

/// Of every luminaire that is not dimmed to nothing.
struct Shadows {
    std::vector<LuminaireShadows> luminaires;
};

/// Classes towards one luminaire; towards all together when the id names none that shines.
std::vector<LightClass> patch_classes(const Shadows& shadows, ObjectId of, std::size_t patches);

/// Whether the id names a luminaire that has shadows of its own here.
bool holds(const Shadows& shadows, ObjectId luminaire);

/// Patches of a class and their area, m2.
struct ClassShare {
    std::size_t patches = 0;
    double area = 0.0;
};
/// In the order of LightClass.
std::array<ClassShare, 4> class_shares(const Mesh& mesh, const std::vector<LightClass>& classes);

}  // namespace hanei
