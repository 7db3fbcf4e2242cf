#include "ui/panels/furniture_preview.h"

#include "engine/edit/material_palette.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/faces.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace hanei {
namespace {

/// A face as seen, in units of the piece's size.
struct Shade {
    std::vector<Vec2> outline;
    double depth = 0.0;
    double light = 0.0;  ///< 0 to 1
};

struct Picture {
    std::vector<Shade> faces;  ///< from back to front
    Vec2 low{0.0}, high{1.0};
};

const Vec3 right = glm::normalize(Vec3{0.85, 0.53, 0.0});
const Vec3 towards = glm::normalize(Vec3{0.48, -0.77, 0.55});  // the eye
const Vec3 up = glm::cross(towards, right);

double reflectance_of(const FurnitureKind& kind, int finish) {
    const PaletteEntry* const entry = find_in_palette(kind.finishes[static_cast<std::size_t>(finish)].material);
    return entry == nullptr ? 0.5 : entry->reflectance;
}

double lit(const Vec3& normal, double reflectance) {
    const double side = normal.z > 0.7 ? 1.0 : 0.62 + 0.2 * normal.x - 0.1 * normal.y;
    return std::clamp((0.16 + 0.84 * std::sqrt(reflectance)) * side, 0.0, 1.0);
}

Picture picture_of(const FurnitureKind& kind) {
    Picture picture;
    picture.low = Vec2{HUGE_VAL};
    picture.high = Vec2{-HUGE_VAL};
    for (const ModelPart& made : parts_of({std::string(kind.kind), {}})) {
        Scene alone;
        alone.furniture.emplace_back().parts = {made.part};
        for (const Face& face : faces_of(alone)) {
            if (glm::dot(face.normal, towards) <= 1e-6) continue;
            Shade shade;
            for (const Vec3& corner : face.region.outline) {
                shade.outline.emplace_back(glm::dot(corner, right), -glm::dot(corner, up));
                picture.low = glm::min(picture.low, shade.outline.back());
                picture.high = glm::max(picture.high, shade.outline.back());
            }
            shade.depth = glm::dot(centroid(face.region.outline), towards);
            shade.light = lit(face.normal, reflectance_of(kind, made.finish));
            picture.faces.push_back(std::move(shade));
        }
    }
    std::stable_sort(picture.faces.begin(), picture.faces.end(),
                     [](const Shade& a, const Shade& b) { return a.depth < b.depth; });
    return picture;
}

}  // namespace

void draw_furniture(const FurnitureKind& kind, ImVec2 low, ImVec2 high) {
    static std::map<std::string_view, Picture> pictures;  // of the one UI thread
    const auto [entry, is_new] = pictures.try_emplace(kind.kind);
    if (is_new) entry->second = picture_of(kind);
    const Picture& picture = entry->second;
    const Vec2 size = picture.high - picture.low;
    const double scale = std::min((high.x - low.x) / size.x, (high.y - low.y) / size.y);
    const Vec2 middle = 0.5 * (picture.low + picture.high);
    const Vec2 at{0.5 * (low.x + high.x), 0.5 * (low.y + high.y)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    std::vector<ImVec2> outline;
    for (const Shade& face : picture.faces) {
        outline.clear();
        for (const Vec2& corner : face.outline) {
            const Vec2 place = at + scale * (corner - middle);
            outline.emplace_back(static_cast<float>(place.x), static_cast<float>(place.y));
        }
        const auto tone = static_cast<int>(255.0 * face.light);
        const int count = static_cast<int>(outline.size());
        list.AddConvexPolyFilled(outline.data(), count, IM_COL32(tone, tone, std::min(255, tone + 4), 255));
        list.AddPolyline(outline.data(), count, IM_COL32(20, 22, 26, 110), ImDrawFlags_Closed, style::hairline());
    }
}

}  // namespace hanei
