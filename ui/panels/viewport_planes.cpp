#include "engine/edit/luminaire_edits.h"
#include "engine/scene/intensity.h"
#include "engine/scene/placement.h"
#include "ui/panels/photometry_plot.h"
#include "ui/panels/photometry_rows.h"
#include "ui/panels/style.h"
#include "ui/panels/viewport.h"

#include <array>
#include <cmath>
#include <numbers>

namespace hanei {
namespace {

constexpr double ring_share = 0.165;  // of the picture's height: outside the arrows that move the luminaire
constexpr double body_share = 0.3;    // the peak's length
constexpr int ring_sides = 48;
constexpr int body_planes = 24;  // half planes, 15 degrees apart
constexpr int body_step = 5;     // degrees of gamma
constexpr ImU32 ring_ink = IM_COL32(0xFF, 0xFF, 0xFF, 0x70);
constexpr ImU32 body_ink = IM_COL32(0xFF, 0xF4, 0xDC, 0x90);

/// A direction of the file's own planes in the room: turned with the intensities and the luminaire.
Vec3 in_room(const Luminaire& luminaire, const Photometry& photometry, double plane_deg, double gamma_deg) {
    const double turned = plane_deg + 90.0 * photometry.quarter_turns;
    return placement(luminaire).direction(photometric_direction(PhotometricType::C, {turned, gamma_deg}));
}

void chip(ImVec2 middle, const char* text, ImU32 colour) {
    const float scale = style::scale();
    ImFont* font = style::fonts().small;
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e4F, 0.0F, text);
    const ImVec2 at{std::floor(middle.x - 0.5F * size.x), std::floor(middle.y - 0.5F * size.y)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({at.x - 4.0F * scale, at.y - 1.0F * scale},
                       {at.x + size.x + 4.0F * scale, at.y + size.y + 1.0F * scale}, style::card, 3.0F * scale);
    list.AddText(font, font->FontSize, at, colour, text);
}

/// A filled tip of the way from one place of the screen to another.
void tip(ImVec2 from, ImVec2 to, ImU32 colour) {
    const float length = std::hypot(to.x - from.x, to.y - from.y);
    const float scale = style::scale();
    if (length < 2.0F * scale) return;  // seen end on
    const ImVec2 along{(to.x - from.x) / length, (to.y - from.y) / length};
    const ImVec2 neck{to.x - 9.0F * scale * along.x, to.y - 9.0F * scale * along.y};
    const ImVec2 side{-4.0F * scale * along.y, 4.0F * scale * along.x};
    ImGui::GetWindowDrawList()->AddTriangleFilled(to, {neck.x + side.x, neck.y + side.y},
                                                  {neck.x - side.x, neck.y - side.y}, colour);
}

}  // namespace

void Viewport::draw_line(const Pane& pane, const std::vector<Vec3>& places, ImU32 colour, float width) const {
    for (const std::vector<ImVec2>& run : pane.on_screen(places)) {
        if (run.size() > 1)
            ImGui::GetWindowDrawList()->AddPolyline(run.data(), static_cast<int>(run.size()), colour, ImDrawFlags_None,
                                                    width * style::scale());
    }
}

/// A ring about the chosen luminaire with its planes C0 and C90, in the colours of their curves.
void Viewport::draw_planes(const Input& input, const Pane& pane, WidgetRegistry& widgets) const {
    const Luminaire* luminaire = find_luminaire(*input.scene, input.selection.primary());
    const Photometry* photometry = luminaire != nullptr ? photometry_of(*input.scene, *luminaire) : nullptr;
    if (photometry == nullptr) return;
    const double height = picture_height_at(pane.camera, luminaire->position);
    if (state.photometric_body && hangs_together(*photometry))
        draw_body(*luminaire, *photometry, body_share * height, pane);
    const double radius = ring_share * height;
    std::vector<Vec3> ring;
    for (int k = 0; k <= ring_sides; ++k) {
        ring.push_back(luminaire->position + radius * in_room(*luminaire, *photometry, 360.0 * k / ring_sides, 90.0));
    }
    draw_line(pane, ring, style::shade, 2.6F);
    draw_line(pane, ring, ring_ink, 1.2F);
    struct Mark {
        double plane_deg;
        const char* name;
        ImU32 colour;
    };
    const std::array marks{Mark{90.0, "C90", style::second}, Mark{0.0, "C0", style::accent}};
    for (const Mark& mark : marks) {
        const Vec3 along = in_room(*luminaire, *photometry, mark.plane_deg, 90.0);
        const auto from = pane.on_screen(luminaire->position + 0.86 * radius * along);
        const auto to = pane.on_screen(luminaire->position + 1.16 * radius * along);
        const auto label = pane.on_screen(luminaire->position + 1.36 * radius * along);
        if (!from || !to || !label) continue;
        ImGui::GetWindowDrawList()->AddLine(*from, *to, style::shade, 4.0F * style::scale());
        ImGui::GetWindowDrawList()->AddLine(*from, *to, mark.colour, 2.0F * style::scale());
        tip(*from, *to, mark.colour);
        chip(*label, mark.name, mark.colour);
        if (&pane == &state.panes.pane(0))
            widgets.note(std::string("plane.") + mark.name,
                         {label->x - 5.0F, label->y - 5.0F, label->x + 5.0F, label->y + 5.0F});
    }
}

/// The intensities as a body of wire: as far from the luminaire as they are great.
void Viewport::draw_body(const Luminaire& luminaire, const Photometry& photometry, double peak_length,
                         const Pane& pane) const {
    const double peak = peak_intensity(photometry).value;
    if (!(peak > 0.0)) return;
    const Mat3 rotation = placement(luminaire).rotation;
    const auto place = [&](double plane_deg, double gamma_deg) {
        const Vec3 direction = photometric_direction(PhotometricType::C, {plane_deg, gamma_deg});
        const double length = peak_length * intensity(photometry, direction).value / peak;
        return luminaire.position + length * (rotation * direction);
    };
    for (int gamma = 3 * body_step; gamma < 180; gamma += 3 * body_step) {
        std::vector<Vec3> ring;
        for (int k = 0; k <= 2 * body_planes; ++k) ring.push_back(place(180.0 * k / body_planes, gamma));
        draw_line(pane, ring, body_ink, 1.0F);
    }
    for (int k = 0; k < body_planes; ++k) {
        const int plane = 360 * k / body_planes;
        std::vector<Vec3> curve;
        for (int gamma = 0; gamma <= 180; gamma += body_step) curve.push_back(place(plane, gamma));
        const int own = (plane - 90 * photometry.quarter_turns + 360) % 180;  // as the file counts its planes
        const ImU32 colour = own == 0 ? ImU32(style::accent) : own == 90 ? ImU32(style::second) : body_ink;
        draw_line(pane, curve, colour, own % 90 == 0 ? 1.8F : 1.0F);
    }
}

}  // namespace hanei
