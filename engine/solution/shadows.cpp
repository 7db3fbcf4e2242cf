#include "engine/solution/shadows.h"

#include <algorithm>

namespace hanei {

bool holds(const Shadows& shadows, ObjectId luminaire) {
    return std::ranges::find(shadows.luminaires, luminaire, &LuminaireShadows::luminaire) != shadows.luminaires.end();
}

std::vector<LightClass> patch_classes(const Shadows& shadows, ObjectId of, std::size_t patches) {
    const bool one = holds(shadows, of);
    std::vector<LightClass> classes(patches, LightClass::away);
    for (const LuminaireShadows& luminaire : shadows.luminaires) {
        if (one && luminaire.luminaire != of) continue;
        for (std::size_t k = 0; k < std::min(patches, luminaire.classes.size()); ++k)
            classes[k] = together(classes[k], luminaire.classes[k]);
    }
    return classes;
}

std::array<ClassShare, 4> class_shares(const Mesh& mesh, const std::vector<LightClass>& classes) {
    std::array<ClassShare, 4> shares{};
    for (std::size_t k = 0; k < std::min(classes.size(), mesh.patches.size()); ++k) {
        ClassShare& share = shares[static_cast<std::size_t>(classes[k])];
        ++share.patches;
        share.area += mesh.patches[k].area;
    }
    return shares;
}

}  // namespace hanei
