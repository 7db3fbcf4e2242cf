#include "ui/view/layers.h"
#include "ui/view/shadow_marks.h"

#include <shaders.h>

namespace hanei {

ShadowLayer::ShadowLayer() : program_(shaders::patch_class_vert, shaders::patch_class_frag) {
    patches_.layout(sizeof(SolidVertex), {{0, 3, offsetof(SolidVertex, position)},
                                          {1, 3, offsetof(SolidVertex, normal)},
                                          {2, 4, offsetof(SolidVertex, colour)}});
}

void ShadowLayer::set(SolutionSnapshot solution) {
    solution_ = solution != nullptr && solution->shadows != nullptr ? std::move(solution) : nullptr;
    patches_loaded_ = lines_loaded_ = false;
}

void ShadowLayer::choose(ObjectId of) {
    if (of == of_) return;
    of_ = of;
    patches_loaded_ = lines_loaded_ = false;
}

void ShadowLayer::draw_patches(const Pass& pass, ObjectId of) {
    choose(of);
    if (!patches_loaded_) patches_.fill(class_marks(*solution_, of_));
    patches_loaded_ = true;
    program_.use();
    program_.set("to_clip", pass.to_clip);
    program_.set("cuts", std::span<const glm::vec4>(pass.cuts));
    program_.set("spacing", static_cast<float>(hatching_px) * pass.pixel_scale);
    program_.set("hatching", hatching_colour);
    patches_.draw_triangles();
}

void ShadowLayer::draw_lines(const Pass& pass, ObjectId of, float lift) {
    choose(of);
    if (!lines_loaded_ || lines_scale_ != pass.pixel_scale) {
        lines_.set(shadow_lines(*solution_, of_), pass.pixel_scale);
        lines_scale_ = pass.pixel_scale;
    }
    lines_loaded_ = true;
    lines_.draw(pass, lift);
}

}  // namespace hanei
