/// Direct light at scattered places, kept per luminaire at full output: dimming only weighs it anew, a
/// moved luminaire lights its own, a body that moved is looked at only where its shadow can fall.
#pragma once

#include "engine/direct/direct.h"
#include "engine/study/body_changes.h"
#include "engine/study/display_cells.h"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hanei {

class VertexLight {
public:
    /// The light that is asked for from here on; of what is kept, that which may be another is forgotten.
    /// Returns   false when everything is as it was, dimming and colours too.
    bool follow(const Scene& scene, const std::shared_ptr<const OccluderSet>& occluders, const Accuracy& accuracy,
                std::span<const Receiver> places);

    /// Lights those of the places that some luminaire of the scene has not lit yet.
    /// Returns   false when stopped.
    bool light(std::span<const Receiver> places, std::span<const std::uint32_t> which, const Work& work);
    /// The same at the vertices of a cut, sooner: where a luminaire's light hardly differs over the cell that a
    /// vertex was cut from, it is taken from the cell's corners. light() computes such light after all.
    bool light_roughly(std::span<const Receiver> places, const DisplayCut& cut, const Work& work);
    bool worked() const { return worked_; }  ///< light() computed something since follow()

    void forget(std::uint32_t place);  ///< another receiver stands there
    void clear();

    /// lx, as the scene sets its luminaires; and in the colour bands.
    /// Needs     a place that is lit.
    double total(std::uint32_t place) const;
    Vec3 bands(std::uint32_t place) const;

    double flux() const;  ///< lm, that all luminaires emit as the scene sets them

private:
    struct Kept {
        Luminaire light;
        std::optional<Photometry> photometry;
        std::optional<Emitter> emitter;
        std::shared_ptr<const OccluderSet> occluders;
        std::vector<float> lux;              ///< one a place; below 0: not known
        std::vector<std::uint32_t> guessed;  ///< places whose light was taken from others
    };
    struct Shining {
        Kept* kept = nullptr;
        double share = 1.0;
        Vec3 bands{1.0};
    };
    bool light_those(Kept& kept, std::span<const Receiver> places, std::span<const std::uint32_t> dark,
                     const Work& work);
    void guess(const Shining& shining, const DisplayCut& cut, std::size_t vertex,
               std::vector<std::uint32_t>& dark) const;
    void forget_shadowed(Kept& kept, std::span<const Receiver> places);

    std::map<ObjectId, Kept> kept_;
    std::vector<Shining> shining_;
    std::shared_ptr<const OccluderSet> occluders_;
    Accuracy accuracy_;
    LastBodyChanges changes_;
    bool worked_ = false;
};

}  // namespace hanei
