/// How much of each patch a receiver sees past the bodies that stand in the room.
#pragma once

#include "engine/mesh/mesh.h"
#include "engine/transport/seen_face.h"
#include "engine/transport/shadow_cast.h"

#include <memory>
#include <span>
#include <vector>

namespace hanei {

/// Shares (0 to 1) of the form factors of patches that no body hides: 1 for a patch in full view, 0 for
/// one in umbra, between them by the exact visible part where a shadow's border crosses the patch.
/// A patch whose factor is 0 anyway keeps 1 or gets 0: its share says nothing.
///
/// Needs     receivers that lie side by side, about 16 of a face: what may hide a face is looked up for
///           all of them at once. Any others are answered as well, later.
/// Holds     the mesh and the occluders by reference, and its memory from one use to the next: keep one
///           a thread. A receiver's shares do not depend on the others asked with it.
class VisibleShares {
public:
    VisibleShares(const Mesh& mesh, const OccluderSet& occluders);

    /// Needs     rows of ones, a row a receiver, a share a patch.
    /// Returns   false when nothing is hidden from any of the receivers.
    bool write(std::span<const Receiver> side_by_side, float* shares);

    /// After bodies came, went or moved: works out anew only patches on which the shadow of one of them,
    /// as it was or as it is, falls at least in part.
    ///
    /// Needs     rows as they were before; `changed`: bodies that went and bodies that came, and no others,
    ///           the occluders are those of now.
    /// Returns   false when the rows are as they were; else the same bits as `write`.
    bool rewrite(std::span<const Receiver> side_by_side, const OccluderSet& changed, float* shares);

private:
    /// Receivers of one face, side by side.
    struct Run {
        std::span<const Receiver> receivers;
        float* shares;
    };

    template <class WriteFace>
    bool for_each_run(std::span<const Receiver> side_by_side, float* shares, WriteFace&& write_face);
    bool look_at(const Run& run, const FaceLayout& layout);
    bool write_face(const Run& run, std::size_t face);
    bool rewrite_face(const Run& run, std::size_t face, const OccluderSet& changed, BodyShadows& shadows);
    bool write_limits(const FaceLayout& layout, const Receiver& receiver, float* row);
    bool hidden_from_all(const FaceLayout& layout, const Run& run);
    float* row(const Run& run, std::size_t receiver) const;

    const Mesh& mesh_;
    const OccluderSet& occluders_;
    std::vector<FaceLayout> layouts_;
    std::vector<ShadedFace> faces_;
    ShadowCast cast_;
    std::vector<FaceSeen> seen_;     // one a receiver of the run
    std::vector<BodyIndex> before_;  // bodies that may stand between the run and a face
    std::vector<BodyIndex> likely_;  // the body that last hid a face from all of a run, one a face
    std::vector<BodyIndex> bodies_;
    std::vector<BodyIndex> changed_;  // bodies that may stand, or have stood, between the run and a face
    ShadowCast::ShadedPatches shaded_;
};

}  // namespace hanei
