#include "engine/base/tiles.h"
#include "engine/geometry/hidden_region.h"
#include "engine/geometry/visible_part.h"
#include "engine/transport/factors.h"
#include "engine/transport/seen_face.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hanei {

namespace {

constexpr std::size_t rows_a_tile = 8;

/// What each body hides from one receiver, worked out when first asked.
class Shadows {
public:
    explicit Shadows(const OccluderSet& occluders) : occluders_(occluders), known_(occluders.bodies().size()) {}

    struct Shadow {
        Hides hides = Hides::nothing;
        std::vector<HalfSpace> planes;
        std::size_t made_for = 0;
    };

    void start(const Receiver& receiver) {
        receiver_ = receiver;
        ++number_;
    }
    const Shadow& of(BodyIndex body) {
        Shadow& shadow = known_[body];
        if (shadow.made_for != number_) {
            shadow.hides = hidden_region(occluders_.shape(body), receiver_.position, receiver_.inward,
                                         occluders_.same_place(), shadow.planes);
            shadow.made_for = number_;
        }
        return shadow;
    }

private:
    const OccluderSet& occluders_;
    Receiver receiver_;
    std::size_t number_ = 0;
    std::vector<Shadow> known_;
};

/// The visible shares of one face's patches from one receiver after another.
class FaceShares {
public:
    explicit FaceShares(const Mesh& mesh, const OccluderSet& occluders)
        : mesh_(mesh), occluders_(occluders), shadows_(occluders) {}

    void start(const Receiver& receiver) {
        receiver_ = receiver;
        shadows_.start(receiver);
    }

    /// Writes shares that differ from 1 to their columns of a row.
    void write(const FaceLayout& layout, FaceSeen seen, float* row) {
        candidates_.clear();
        occluders_.between(receiver_.position, layout.corners, candidates_);
        if (candidates_.empty()) return;
        const MeshFace& face = *layout.face;
        if (seen == FaceSeen::touching) {
            for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p) {
                row[p] = exact_share(mesh_.patches[p], candidates_);
            }
            return;
        }
        begin_face(layout);
        for (const BodyIndex body : candidates_) {
            if (!cast(layout, body)) {
                std::fill_n(row + face.first_patch, face.patch_count, 0.0F);
                return;
            }
        }
        for (std::uint32_t p = 0; p < face.patch_count; ++p) {
            if (hidden_[p]) {
                row[face.first_patch + p] = 0.0F;
            } else if (!cutting_[p].empty()) {
                row[face.first_patch + p] = exact_share(mesh_.patches[face.first_patch + p], cutting_[p]);
            }
        }
    }

private:
    void begin_face(const FaceLayout& layout) {
        const std::size_t patches = layout.face->patch_count;
        hidden_.assign(patches, 0);
        if (cutting_.size() < patches) cutting_.resize(patches);
        for (std::size_t p = 0; p < patches; ++p) cutting_[p].clear();
        seen_.resize(layout.vertices.size());
        farthest_ = 0.0;
        for (std::size_t k = 0; k < seen_.size(); ++k) {
            seen_[k] = layout.vertices[k] - receiver_.position;
            farthest_ = std::max({farthest_, std::abs(seen_[k].x), std::abs(seen_[k].y), std::abs(seen_[k].z)});
        }
        corners_.clear();
        for (const Vec3& corner : layout.corners) corners_.push_back(corner - receiver_.position);
    }

    /// Below this a height over a plane through the receiver is rounding.
    double slack_of(const HalfSpace& plane) const {
        constexpr double relative_rounding = 1e-14;  // a hundred times that of a height
        const Vec3 size = glm::abs(plane.outward);
        return std::max(plane.slack, relative_rounding * farthest_ * (size.x + size.y + size.z));
    }

    /// Enters one body's shadow into the face. False when it hides all of it.
    bool cast(const FaceLayout& layout, BodyIndex body) {
        const Shadows::Shadow& shadow = shadows_.of(body);
        if (shadow.hides == Hides::everything) return false;
        if (shadow.hides == Hides::nothing) return true;
        crossing_.clear();
        for (const HalfSpace& plane : shadow.planes) {
            const double slack = slack_of(plane);
            double lowest = std::numeric_limits<double>::infinity();
            double highest = -lowest;
            for (const Vec3& corner : corners_) {
                const double height = glm::dot(plane.outward, corner) - plane.reach;
                lowest = std::min(lowest, height);
                highest = std::max(highest, height);
            }
            if (lowest >= -slack) return true;                 // the whole face is outside
            if (highest > slack) crossing_.push_back(&plane);  // else the whole face is inside of it
        }
        if (crossing_.empty()) return false;
        mark_vertices();
        mark_patches(layout, body);
        return true;
    }

    /// One bit a plane: is the vertex outside of it (or on it), and is it beyond doubt outside.
    void mark_vertices() {
        outside_.assign(seen_.size(), 0);
        beyond_.assign(seen_.size(), 0);
        constexpr std::size_t bits = 32;
        for (std::size_t k = 0; k < crossing_.size(); ++k) {
            const HalfSpace& plane = *crossing_[k];
            const double slack = slack_of(plane);
            // past the 32nd plane of a body of many faces, beyond_ bits are shared: patches are then
            // cut exactly where they might have been proved hidden or clear
            const std::uint32_t bit = 1U << std::min(k, bits - 1);
            const bool shared = k >= bits - 1 && crossing_.size() > bits;
            for (std::size_t v = 0; v < seen_.size(); ++v) {
                const double height = glm::dot(plane.outward, seen_[v]) - plane.reach;
                outside_[v] |= height >= -slack && !shared ? bit : 0U;
                beyond_[v] |= height > slack ? bit : 0U;
            }
        }
    }

    void mark_patches(const FaceLayout& layout, BodyIndex body) {
        for (std::uint32_t p = 0; p < layout.face->patch_count; ++p) {
            if (hidden_[p]) continue;
            std::uint32_t all_outside = ~0U;
            std::uint32_t any_beyond = 0;
            for (std::uint32_t k = layout.first_edge[p]; k < layout.first_edge[p + 1]; ++k) {
                const std::int32_t edge = layout.edges_of[k];
                const FaceLayout::Edge& ends = layout.edges[static_cast<std::size_t>(std::abs(edge) - 1)];
                const std::uint32_t corner = edge > 0 ? ends.from : ends.to;
                all_outside &= outside_[corner];
                any_beyond |= beyond_[corner];
            }
            if (all_outside != 0) continue;
            if (any_beyond == 0) {
                hidden_[p] = 1;
            } else {
                cutting_[p].push_back(body);
            }
        }
    }

    float exact_share(const Patch& patch, std::span<const BodyIndex> bodies) const {
        const double whole = configuration_factor(patch.outline, receiver_);
        if (!(whole > 0.0)) return 1.0F;  // weighs nothing either way
        const double visible = visible_configuration_factor(patch.outline, receiver_, occluders_, bodies);
        return static_cast<float>(std::clamp(visible / whole, 0.0, 1.0));
    }

    const Mesh& mesh_;
    const OccluderSet& occluders_;
    Shadows shadows_;
    Receiver receiver_;
    std::vector<BodyIndex> candidates_;
    std::vector<Vec3> seen_, corners_;
    double farthest_ = 0.0;
    std::vector<const HalfSpace*> crossing_;
    std::vector<std::uint32_t> outside_, beyond_;
    std::vector<char> hidden_;
    std::vector<std::vector<BodyIndex>> cutting_;
};

}  // namespace

std::optional<Visibility> patch_visibility(const Mesh& mesh, std::span<const Receiver> receivers,
                                           const OccluderSet& occluders, const Work& work) {
    Visibility visibility;
    if (occluders.empty()) return visibility;
    DenseRows& share = visibility.share;
    share = {receivers.size(), mesh.patches.size(), {}};
    share.values.assign(share.rows * share.columns, 1.0F);
    const std::vector<FaceLayout> layouts = layouts_of(mesh);
    const bool finished = for_each_tile(receivers.size(), rows_a_tile, work, [&](std::size_t begin, std::size_t end) {
        FaceShares shares(mesh, occluders);
        for (std::size_t k = begin; k < end; ++k) {
            shares.start(receivers[k]);
            for (const FaceLayout& layout : layouts) {
                const FaceSeen seen = seen_from(layout, receivers[k]);
                if (seen != FaceSeen::hidden) shares.write(layout, seen, share.values.data() + k * share.columns);
            }
        }
    });
    if (!finished) return std::nullopt;
    visibility.all_visible = std::all_of(share.values.begin(), share.values.end(), [](float s) { return s == 1.0F; });
    if (visibility.all_visible) share = {};
    return visibility;
}

}  // namespace hanei
