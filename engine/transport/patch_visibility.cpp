#include "engine/base/tiles.h"
#include "engine/geometry/visible_part.h"
#include "engine/transport/factors.h"
#include "engine/transport/seen_face.h"
#include "engine/transport/shadow_cast.h"

#include <algorithm>

namespace hanei {

namespace {

constexpr std::size_t rows_a_tile = 16;

/// For a receiver in the plane of a face: what it sees of patches is a limit, worked out one by one.
float limit_share(const Patch& patch, const Receiver& receiver, const OccluderSet& occluders,
                  std::span<const BodyIndex> bodies) {
    const double whole = configuration_factor(patch.outline, receiver);
    if (!(whole > 0.0)) return 1.0F;  // weighs nothing either way
    const double visible = visible_configuration_factor(patch.outline, receiver, occluders, bodies);
    return static_cast<float>(std::clamp(visible / whole, 0.0, 1.0));
}

/// Bodies that may stand between receivers side by side and each face, found when first asked.
class BodiesBefore {
public:
    BodiesBefore(const OccluderSet& occluders, std::span<const Receiver> receivers, std::size_t faces)
        : occluders_(occluders), eyes_{receivers[0].position, receivers[0].position}, found_(faces) {
        for (const Receiver& receiver : receivers) eyes_.include(receiver.position);
    }
    std::span<const BodyIndex> of(std::size_t face, std::span<const Vec3> corners) {
        if (!found_[face]) occluders_.between(eyes_, corners, found_[face].emplace());
        return *found_[face];
    }

private:
    const OccluderSet& occluders_;
    Box eyes_;
    std::vector<std::optional<std::vector<BodyIndex>>> found_;
};

/// Rows of shares for receivers side by side, one after another.
class RowWriter {
public:
    RowWriter(const Mesh& mesh, const OccluderSet& occluders, std::span<const Receiver> receivers, std::size_t faces)
        : mesh_(mesh), occluders_(occluders), cast_(mesh, occluders), before_(occluders, receivers, faces) {}

    /// Needs     a row of ones.
    void write(std::span<const FaceLayout> layouts, const Receiver& receiver, float* row) {
        cast_.start(receiver);
        for (std::size_t face = 0; face < layouts.size(); ++face) {
            const FaceSeen seen = seen_from(layouts[face], receiver);
            if (seen != FaceSeen::hidden) write_face(layouts, face, seen, receiver, row);
        }
    }

    /// Only the faces that one of the changed bodies may hide, or may have hidden, part of.
    void rewrite(std::span<const FaceLayout> layouts, const Receiver& receiver, const OccluderSet& gone,
                 const OccluderSet& come, float* row) {
        cast_.start(receiver);
        for (std::size_t face = 0; face < layouts.size(); ++face) {
            const FaceLayout& layout = layouts[face];
            const FaceSeen seen = seen_from(layout, receiver);
            if (seen == FaceSeen::hidden) continue;
            bodies_.clear();
            gone.between(receiver.position, layout.corners, bodies_);
            come.between(receiver.position, layout.corners, bodies_);
            if (bodies_.empty()) continue;
            std::fill_n(row + layout.face->first_patch, layout.face->patch_count, 1.0F);
            write_face(layouts, face, seen, receiver, row);
        }
    }

private:
    void write_face(std::span<const FaceLayout> layouts, std::size_t face, FaceSeen seen, const Receiver& receiver,
                    float* row) {
        const FaceLayout& layout = layouts[face];
        bodies_.clear();
        occluders_.between(receiver.position, layout.corners, before_.of(face, layout.corners), bodies_);
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
    BodiesBefore before_;
    std::vector<BodyIndex> bodies_;
};

/// Runs `write(writer, layouts, receiver number, row)` for every receiver and drops rows of ones.
template <class Write>
std::optional<Visibility> with_rows(Visibility visibility, const Mesh& mesh, std::span<const Receiver> receivers,
                                    const OccluderSet& occluders, const Work& work, Write&& write) {
    DenseRows& share = visibility.share;
    if (visibility.all_visible) {
        share = {receivers.size(), mesh.patches.size(), {}};
        share.values.assign(share.rows * share.columns, 1.0F);
    }
    const std::vector<FaceLayout> layouts = layouts_of(mesh);
    const bool finished = for_each_tile(receivers.size(), rows_a_tile, work, [&](std::size_t begin, std::size_t end) {
        RowWriter writer(mesh, occluders, receivers.subspan(begin, end - begin), layouts.size());
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
    return with_rows(Visibility{}, mesh, receivers, occluders, work,
                     [&](RowWriter& writer, std::span<const FaceLayout> layouts, std::size_t k, float* row) {
                         writer.write(layouts, receivers[k], row);
                     });
}

std::optional<Visibility> updated_visibility(Visibility before, const Mesh& mesh, std::span<const Receiver> receivers,
                                             const OccluderSet& gone, const OccluderSet& come,
                                             const OccluderSet& occluders, const Work& work) {
    return with_rows(std::move(before), mesh, receivers, occluders, work,
                     [&](RowWriter& writer, std::span<const FaceLayout> layouts, std::size_t k, float* row) {
                         writer.rewrite(layouts, receivers[k], gone, come, row);
                     });
}

}  // namespace hanei
