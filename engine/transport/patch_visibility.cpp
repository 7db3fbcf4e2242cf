#include "engine/base/tiles.h"
#include "engine/transport/factors.h"
#include "engine/transport/spare.h"
#include "engine/transport/visible_shares.h"

#include <algorithm>

namespace hanei {

namespace {

constexpr std::size_t rows_a_tile = 16;

/// Runs `write(shares, receivers, rows)` for every tile and drops rows of ones.
template <class Write>
std::optional<Visibility> with_rows(Visibility visibility, const Mesh& mesh, std::span<const Receiver> receivers,
                                    const OccluderSet& occluders, const Work& work, Write&& write) {
    DenseRows& share = visibility.share;
    if (visibility.all_visible) {
        share = {receivers.size(), mesh.patches.size(), {}};
        share.values.assign(share.rows * share.columns, 1.0F);
    }
    Spare<VisibleShares> shares([&] { return VisibleShares(mesh, occluders); });
    const bool finished = for_each_tile(receivers.size(), rows_a_tile, work, [&](std::size_t begin, std::size_t end) {
        shares.with([&](VisibleShares& of) {
            write(of, receivers.subspan(begin, end - begin), share.values.data() + begin * share.columns);
        });
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
                     [](VisibleShares& shares, std::span<const Receiver> side_by_side, float* rows) {
                         shares.write(side_by_side, rows);
                     });
}

std::optional<Visibility> updated_visibility(Visibility before, const Mesh& mesh, std::span<const Receiver> receivers,
                                             const OccluderSet& gone, const OccluderSet& come,
                                             const OccluderSet& occluders, const Work& work) {
    std::vector<ConvexBody> bodies(gone.bodies().begin(), gone.bodies().end());
    bodies.insert(bodies.end(), come.bodies().begin(), come.bodies().end());
    const OccluderSet changed(std::move(bodies));
    return with_rows(std::move(before), mesh, receivers, occluders, work,
                     [&](VisibleShares& shares, std::span<const Receiver> side_by_side, float* rows) {
                         shares.rewrite(side_by_side, changed, rows);
                     });
}

}  // namespace hanei
