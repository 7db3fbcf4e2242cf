#include "engine/study/shadow_stage.h"

#include "engine/base/tiles.h"
#include "engine/direct/light_class.h"
#include "engine/direct/shadow_outline.h"
#include "engine/mesh/contact.h"
#include "engine/study/direct_stage.h"
#include "engine/study/display_stage.h"
#include "engine/study/stage_keys.h"

namespace hanei {

namespace {

std::vector<ReceivingPolygon> polygons_of(const Mesh& mesh) {
    std::vector<ReceivingPolygon> polygons;
    polygons.reserve(mesh.patches.size());
    for (const Patch& patch : mesh.patches) polygons.push_back({patch.outline, mesh.faces[patch.face].face.normal});
    return polygons;
}

void append_lines(std::vector<ShadowLine>& lines, std::vector<Polygon> places, std::size_t face, bool umbra) {
    for (Polygon& line : places) lines.push_back({std::move(line), static_cast<std::uint32_t>(face), umbra});
}

/// Outlines on every face, each face's own, in order; empty when stopped.
std::optional<std::vector<ShadowLine>> lines_of(const Emitter& emitter, const Mesh& mesh,
                                                const std::vector<std::vector<Polygon>>& covers,
                                                const OccluderSet& occluders, const Work& work) {
    std::vector<FaceShadows> of_faces(mesh.faces.size());
    const bool finished = for_each_tile(mesh.faces.size(), 1, work, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            of_faces[f] = shadows_on(mesh.faces[f].face, covers[f], emitter, occluders);
    });
    if (!finished) return std::nullopt;
    std::vector<ShadowLine> lines;
    for (std::size_t f = 0; f < of_faces.size(); ++f) {
        append_lines(lines, std::move(of_faces[f].penumbra_lines), f, false);
        append_lines(lines, std::move(of_faces[f].umbra_lines), f, true);
    }
    return lines;
}

std::shared_ptr<const Shadows> make_shadows(const Scene& scene, const Mesh& mesh, const OccluderSet* occluders,
                                            const Work& work) {
    const Contacts contacts(scene);
    std::vector<std::vector<Polygon>> covers;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) covers.push_back(contacts.covers_of(f));
    const std::vector<ReceivingPolygon> polygons = polygons_of(mesh);
    auto shadows = std::make_shared<Shadows>();
    for (const WeightedEmitter& weighted : emitters_of(scene)) {
        LuminaireShadows& of = shadows->luminaires.emplace_back();
        of.luminaire = weighted.emitter.luminaire();
        auto classes = light_classes(polygons, weighted.emitter, occluders, work);
        if (!classes) return nullptr;
        of.classes = std::move(*classes);
        if (!occluders) continue;
        auto lines = lines_of(weighted.emitter, mesh, covers, *occluders, work);
        if (!lines) return nullptr;
        of.lines = std::move(*lines);
    }
    return shadows;
}

}  // namespace

std::shared_ptr<const Shadows> ShadowStage::get(const Scene& scene, const std::shared_ptr<const Mesh>& mesh,
                                                const std::shared_ptr<const OccluderSet>& occluders, const Work& work) {
    Key key{mesh, occluders, {}, scene.photometries};
    for (const Luminaire& luminaire : scene.luminaires) {
        if (output_share(scene, luminaire) > 0.0) key.lights.push_back(light_of(luminaire));
    }
    const auto* shadows = cache_.get(key, [&]() -> std::optional<std::shared_ptr<const Shadows>> {
        auto made = make_shadows(scene, *mesh, occluders.get(), work);
        return made ? std::optional(std::move(made)) : std::nullopt;
    });
    return shadows ? *shadows : nullptr;
}

}  // namespace hanei
