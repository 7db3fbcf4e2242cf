#include "engine/direct/light_class.h"

#include "engine/base/tiles.h"
#include "engine/direct/facing_parts.h"
#include "engine/direct/shadow_proof.h"
#include "engine/direct/sight_hull.h"

#include <algorithm>

namespace hanei {

namespace {

/// The facing parts and the bodies that may stand between them.
class Case {
public:
    Case(const FacingParts& facing, const OccluderSet& occluders, std::vector<BodyIndex>& found)
        : question_{facing.patch, facing.opening, occluders, {}}, found_(found), hull_(facing.patch, facing.opening) {}

    /// Leaves in `found` the bodies that stand in some sight line, or a few more.
    LightClass kind(int halvings) {
        question_.among = found_;
        if (is_hidden_by_one(question_)) return LightClass::umbra;
        const double touching = question_.occluders.same_place();
        std::erase_if(found_,
                      [&](BodyIndex body) { return hull_.is_soon_clear_of(shape(body), vertices(body), touching); });
        // One body surely in the way decides; those after it are not worth the whole test.
        while (!found_.empty() && hull_.edges_separate(shape(found_.back()), vertices(found_.back()), touching))
            found_.pop_back();
        if (found_.empty()) return LightClass::lit;
        if (halvings == ClassEffort::single_bodies) return LightClass::partly;
        question_.among = found_;
        return is_hidden_by_several(question_, halvings) ? LightClass::umbra : LightClass::partly;
    }

private:
    const BodyShape& shape(BodyIndex body) const { return question_.occluders.shape(body); }
    std::span<const Vec3> vertices(BodyIndex body) const { return question_.occluders.bodies()[body].vertices; }

    SightQuestion question_;
    std::vector<BodyIndex>& found_;
    SightHull hull_;
};

}  // namespace

LightClass classify(const ReceivingPolygon& patch, const Emitter& emitter, const OccluderSet* occluders,
                    const std::optional<std::span<const BodyIndex>>& among, std::vector<BodyIndex>& between,
                    const ClassEffort& effort) {
    between.clear();
    LightClass whole = LightClass::away;
    if (patch.outline.size() < 3) return whole;
    std::vector<BodyIndex> found;
    const std::uint32_t own_body = emitter.luminaire().value;
    for (const LuminousPiece& piece : emitter.pieces()) {
        const std::optional<FacingParts> facing = facing_parts(patch, piece);
        if (!facing) continue;
        LightClass kind = LightClass::lit;
        if (occluders) {
            found.clear();
            if (among)
                found.assign(among->begin(), among->end());
            else
                occluders->between(facing->patch, facing->opening, found);
            std::erase_if(found, [&](BodyIndex body) { return occluders->bodies()[body].owner == own_body; });
            kind = Case(*facing, *occluders, found).kind(effort.halvings);
            between.insert(between.end(), found.begin(), found.end());
        }
        whole = together(whole, kind);
    }
    if (whole != LightClass::partly) between.clear();
    std::ranges::sort(between);
    between.erase(std::unique(between.begin(), between.end()), between.end());
    return whole;
}

std::optional<std::vector<LightClass>> light_classes(std::span<const ReceivingPolygon> patches, const Emitter& emitter,
                                                     const OccluderSet* occluders, const Work& work) {
    std::vector<LightClass> classes(patches.size());
    const bool finished = for_each_tile(patches.size(), 16, work, [&](std::size_t begin, std::size_t end) {
        std::vector<BodyIndex> between;
        for (std::size_t k = begin; k < end; ++k)
            classes[k] = classify(patches[k], emitter, occluders, std::nullopt, between, {3});
    });
    if (!finished) return std::nullopt;
    return classes;
}

}  // namespace hanei
