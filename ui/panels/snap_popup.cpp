#include "ui/panels/snap_popup.h"

#include "ui/panels/language.h"
#include "ui/panels/panel_frame.h"
#include "ui/panels/style.h"

#include <imgui.h>

namespace hanei {

void SnapPopup::draw(SnapSettings& settings, Form& form) {
    const float scale = style::scale();
    if (opening_) ImGui::OpenPopup("###snap");
    opening_ = false;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x - 20.0F * scale, screen.y - 40.0F * scale}, ImGuiCond_Always, {1.0F, 1.0F});
    ImGui::SetNextWindowSize({300.0F * scale, 0.0F});
    if (!ImGui::BeginPopup("###snap")) return;
    headline(tr("Snapping"), "");
    form.begin("snap");
    form.toggle("snap.on", "Snap", "Moved objects catch at what is set below; Ctrl while dragging does the opposite",
                settings.on);
    form.toggle("snap.to_raster", "To the raster", "Places keep to multiples of the raster", settings.to_raster);
    form.number({"snap.raster", "Raster", "m", "Distance of the places that objects keep to", 0.01, 1.0, 0.01, 2},
                settings.raster);
    form.toggle("snap.to_walls", "To walls",
                "Touching a wall; luminaires also at half their spacing from it, as even rows hang", settings.to_walls);
    form.toggle("snap.to_centre", "To the centre", "The middle of the room's plan", settings.to_centre);
    form.toggle("snap.to_objects", "In line", "In line with others of its kind", settings.to_objects);
    form.end();
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)) && !ImGui::GetIO().WantTextInput)
        ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace hanei
