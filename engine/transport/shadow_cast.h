/// The shadows of bodies on the patches of a face, seen from one receiver.
#pragma once

#include "engine/geometry/visible_pieces.h"
#include "engine/transport/body_shadows.h"
#include "engine/transport/flat_view.h"
#include "engine/transport/shaded_face.h"

#include <span>
#include <vector>

namespace hanei {

/// Casts shadows on one face after another. A shadow is convex, and on a face bounded by straight lines:
/// patches on the inner side of all of them are hidden, those beyond one of them are clear, and only
/// patches that a line crosses are cut.
///
/// Holds     its memory from one face to the next: keep one a thread. Shares of patches that are small
///           against their distance to 1e-5 (see FlatView), of the others to rounding.
class ShadowCast {
public:
    ShadowCast(const Mesh& mesh, const OccluderSet& occluders) : mesh_(mesh), shadows_(occluders) {}

    void start(std::span<const Receiver> side_by_side);

    /// Writes the visible shares of the face's patches that are not 1 to their columns of a row.
    ///
    /// Needs     a receiver (its number among those side by side) in front of the face, not in its plane;
    ///           all bodies that may stand between.
    /// Returns   false when nothing is hidden.
    bool write(const ShadedFace& face, std::size_t receiver, std::span<const BodyIndex> bodies, float* row);

    /// Patches of a face on which a shadow falls at least in part.
    struct ShadedPatches {
        std::vector<char> flags;  ///< one a patch
        FlatBox bounds;           ///< of all shadows
    };

    /// The same for some patches of the face, those that are 1 as well.
    void rewrite(const ShadedFace& face, std::size_t receiver, std::span<const BodyIndex> bodies,
                 const ShadedPatches& patches, float* row);

    /// Finds patches on which the shadow of one of the bodies, of any set, falls.
    /// Returns   false when there is none.
    bool find_shaded(const ShadedFace& face, std::size_t receiver, BodyShadows& shadows,
                     std::span<const BodyIndex> bodies, ShadedPatches& patches);

    /// Another face, or other bodies, follow.
    void next_face() {
        misses_.clear();
        likely_ = none;
    }

private:
    /// The part of a face in one body's shadow.
    enum class Shaded { nothing, everything, part };

    /// One shadow's border where it crosses the face: the same planes in space and in the face.
    struct Cast {
        std::vector<HalfSpace> planes;
        std::vector<FlatLine> lines;
        std::vector<FourLine> four;
    };
    struct Cut {
        std::uint32_t cast = 0;
        std::int32_t next = none;  ///< another cut of the same patch
        static constexpr std::int32_t none = -1;
    };

    void look_at(const ShadedFace& face, const Receiver& receiver);
    bool cast_all(const ShadedFace& face, std::size_t receiver, std::span<const BodyIndex> bodies);
    Shaded cast_on(const ShadedFace& face, const BodyShadows::Shadow& shadow, Cast& cast, std::size_t& misses) const;
    FlatLine line_of(const ShadedFace& face, const HalfSpace& plane) const;
    void mark_all(const ShadedFace& face, const FlatBox& within);
    void mark(std::size_t patch, bool crossed, std::uint32_t cast);
    float share_of(const ShadedFace& face, std::uint32_t patch);
    bool flat_share(const ShadedFace& face, std::uint32_t patch, float& share);
    double visible_weight(const FlatLoop& loop, bool split);
    void subtract(const FlatLoop& piece, const Cast& cast);
    float exact_share(const Patch& patch);
    double factor_of(std::span<const Vec3> loop);

    const Mesh& mesh_;
    BodyShadows shadows_;
    std::vector<Receiver> receivers_;
    Receiver receiver_;
    Vec3 to_face_{0.0};      ///< from the receiver to the face's origin
    double rounding_ = 0.0;  ///< of a height over a plane through the receiver, for a direction of size 1
    FlatView view_;
    std::vector<Cast> casts_;
    Cast cast_;
    std::size_t cast_count_ = 0;
    static constexpr std::size_t none = ~std::size_t{0};
    std::size_t likely_ = none;        ///< which of the bodies hid all of the face from a receiver before
    std::vector<std::size_t> misses_;  ///< by which plane each body's shadow last missed the face
    std::vector<char> hidden_;
    std::vector<std::int32_t> first_cut_;  ///< one a patch
    std::vector<Cut> cuts_;
    std::vector<const Cast*> cutting_;  ///< the patch in hand
    std::vector<const FlatLine*> crossing_;
    std::vector<FlatLoop> rest_, next_rest_;
    std::vector<Vec3> loop_, offsets_;
    VisiblePieces pieces_;
};

}  // namespace hanei
