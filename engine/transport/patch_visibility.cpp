#include "engine/base/tiles.h"
#include "engine/geometry/visible_part.h"
#include "engine/transport/factors.h"
#include "engine/transport/seen_face.h"
#include "engine/transport/shadow_cast.h"

#include <algorithm>

namespace hanei {

namespace {

constexpr std::size_t rows_a_tile = 8;

/// For a receiver in the plane of a face: what it sees of patches is a limit, worked out one by one.
float limit_share(const Patch& patch, const Receiver& receiver, const OccluderSet& occluders,
                  std::span<const BodyIndex> bodies) {
    const double whole = configuration_factor(patch.outline, receiver);
    if (!(whole > 0.0)) return 1.0F;  // weighs nothing either way
    const double visible = visible_configuration_factor(patch.outline, receiver, occluders, bodies);
    return static_cast<float>(std::clamp(visible / whole, 0.0, 1.0));
}

/// Rows of shares, one receiver after another.
class RowWriter {
public:
    RowWriter(const Mesh& mesh, const OccluderSet& occluders)
        : mesh_(mesh), occluders_(occluders), cast_(mesh, occluders) {}

    /// Needs     a row of ones.
    void write(std::span<const FaceLayout> layouts, const Receiver& receiver, float* row) {
        cast_.start(receiver);
        for (const FaceLayout& layout : layouts) {
            const FaceSeen seen = seen_from(layout, receiver);
            if (seen != FaceSeen::hidden) write_face(layout, seen, receiver, row);
        }
    }

    /// Only the faces that one of the changed bodies may hide, or may have hidden, part of.
    void rewrite(std::span<const FaceLayout> layouts, const Receiver& receiver, const OccluderSet& gone,
                 const OccluderSet& come, float* row) {
        cast_.start(receiver);
        for (const FaceLayout& layout : layouts) {
            const FaceSeen seen = seen_from(layout, receiver);
            if (seen == FaceSeen::hidden) continue;
            bodies_.clear();
            gone.between(receiver.position, layout.corners, bodies_);
            come.between(receiver.position, layout.corners, bodies_);
            if (bodies_.empty()) continue;
            std::fill_n(row + layout.face->first_patch, layout.face->patch_count, 1.0F);
            write_face(layout, seen, receiver, row);
        }
    }

private:
    void write_face(const FaceLayout& layout, FaceSeen seen, const Receiver& receiver, float* row) {
        bodies_.clear();
        occluders_.between(receiver.position, layout.corners, bodies_);
        if (bodies_.empty()) return;
        if (seen == FaceSeen::touching) {
            write_limits(*layout.face, receiver, row);
        } else {
            cast_.write(layout, bodies_, row);
        }
    }

    void write_limits(const MeshFace& face, const Receiver& receiver, float* row) const {
        for (std::uint32_t p = face.first_patch; p < face.first_patch + face.patch_count; ++p) {
            row[p] = limit_share(mesh_.patches[p], receiver, occluders_, bodies_);
        }
    }

    const Mesh& mesh_;
    const OccluderSet& occluders_;
    ShadowCast cast_;
    std::vector<BodyIndex> bodies_;
};

/// Runs `write(writer, layouts, receiver number, row)` for every receiver and drops rows of ones.
template <class Write>
std::optional<Visibility> with_rows(Visibility visibility, const Mesh& mesh, std::size_t receivers,
                                    const OccluderSet& occluders, const Work& work, Write&& write) {
    DenseRows& share = visibility.share;
    if (visibility.all_visible) {
        share = {receivers, mesh.patches.size(), {}};
        share.values.assign(share.rows * share.columns, 1.0F);
    }
    const std::vector<FaceLayout> layouts = layouts_of(mesh);
    const bool finished = for_each_tile(receivers, rows_a_tile, work, [&](std::size_t begin, std::size_t end) {
        RowWriter writer(mesh, occluders);
        for (std::size_t k = begin; k < end; ++k) write(writer, layouts, k, share.values.data() + k * share.columns);
    });
    if (!finished) return std::nullopt;
    visibility.all_visible = std::all_of(share.values.begin(), share.values.end(), [](float s) { return s == 1.0F; });
    if (visibility.all_visible) share = {};
    return visibility;
}

}  // namespace

std::optional<Visibility> patch_visibility(const Mesh& mesh, std::span<const Receiver> receivers,
                                           const OccluderSet& occluders, const Work& work) {
    if (occluders.empty()) return Visibility{};
    return with_rows(Visibility{}, mesh, receivers.size(), occluders, work,
                     [&](RowWriter& writer, std::span<const FaceLayout> layouts, std::size_t k, float* row) {
                         writer.write(layouts, receivers[k], row);
                     });
}

std::optional<Visibility> updated_visibility(Visibility before, const Mesh& mesh, std::span<const Receiver> receivers,
                                             const OccluderSet& gone, const OccluderSet& come,
                                             const OccluderSet& occluders, const Work& work) {
    return with_rows(std::move(before), mesh, receivers.size(), occluders, work,
                     [&](RowWriter& writer, std::span<const FaceLayout> layouts, std::size_t k, float* row) {
                         writer.rewrite(layouts, receivers[k], gone, come, row);
                     });
}

}  // namespace hanei
