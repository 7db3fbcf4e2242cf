/// The shadows of bodies on the patches of a face, seen from one receiver.
#pragma once

#include "engine/geometry/hidden_region.h"
#include "engine/geometry/occluders.h"
#include "engine/geometry/visible_pieces.h"
#include "engine/transport/seen_face.h"

#include <span>
#include <vector>

namespace hanei {

/// What each body hides from one receiver, worked out when first asked.
class BodyShadows {
public:
    struct Shadow {
        Hides hides = Hides::nothing;
        std::vector<HalfSpace> planes;
        std::size_t made_for = 0;
    };

    explicit BodyShadows(const OccluderSet& occluders) : occluders_(occluders), known_(occluders.bodies().size()) {}
    void start(const Receiver& receiver);
    const Shadow& of(BodyIndex body);

private:
    const OccluderSet& occluders_;
    Receiver receiver_;
    std::size_t number_ = 0;
    std::vector<Shadow> known_;
};

/// The part of a face in one body's shadow.
enum class Shaded { nothing, everything, part };

/// Casts shadows on one face after another. A shadow is convex: a patch with all corners inside is
/// hidden, one whose corners all lie beyond one of its planes is clear, and only patches on its
/// border are cut.
///
/// Holds     its memory from one face to the next: keep one a thread.
class ShadowCast {
public:
    ShadowCast(const Mesh& mesh, const OccluderSet& occluders) : mesh_(mesh), shadows_(occluders) {}

    void start(const Receiver& receiver);

    /// Writes the visible shares of the face's patches that are not 1 to their columns of a row.
    ///
    /// Needs     a receiver in front of the face, not in its plane; all bodies that may stand between.
    void write(const FaceLayout& layout, std::span<const BodyIndex> bodies, float* row);

private:
    Shaded region_on(const BodyShadows::Shadow& shadow, std::vector<HalfSpace>& crossing);
    void mark_patches(const FaceLayout& layout, std::uint32_t cast);
    void mark_patch(std::uint32_t patch, const Polygon& outline, std::uint32_t cast);
    double slack_of(const HalfSpace& plane) const;
    void clip(const HalfSpace& plane);
    float share_of(const Patch& patch, std::span<const std::uint32_t> casts);
    double factor_of(std::span<const Vec3> loop);

    const Mesh& mesh_;
    BodyShadows shadows_;
    Receiver receiver_;
    double farthest_ = 0.0;
    std::vector<Vec3> corners_;                  // of the face, seen from the receiver
    std::vector<std::vector<HalfSpace>> casts_;  // planes of each shadow that cross the face
    std::vector<char> hidden_;
    std::vector<std::vector<std::uint32_t>> cutting_;  // casts that cut a patch
    std::vector<Vec3> loop_, clipped_, offsets_;
    std::vector<double> heights_;
    VisiblePieces pieces_;
};

}  // namespace hanei
