/// Classes of patches and outlines of shadows, kept while luminaires and bodies stand still.
#pragma once

#include "engine/solution/solution.h"
#include "engine/study/stage_cache.h"

#include <memory>
#include <vector>

namespace hanei {

class ShadowStage {
public:
    /// `occluders` may be null: nothing casts shadows.
    /// Returns   null when stopped.
    /// Cost      about 10 us a luminaire and patch, 50 us a luminaire, face and body near it.
    std::shared_ptr<const Shadows> get(const Scene& scene, const std::shared_ptr<const Mesh>& mesh,
                                       const std::shared_ptr<const OccluderSet>& occluders, const Work& work);

private:
    struct Key {
        std::shared_ptr<const Mesh> mesh;
        std::shared_ptr<const OccluderSet> occluders;
        std::vector<Luminaire> lights;
        std::vector<Photometry> photometries;
        bool operator==(const Key&) const = default;
    };
    StageCache<Key, std::shared_ptr<const Shadows>> cache_;
};

}  // namespace hanei
