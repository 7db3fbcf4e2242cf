#include "bare_desk.h"

#include "ui/panels/style.h"

#include <imgui.h>

namespace hanei {

BareDesk::BareDesk(ProjectContent content, ProjectDoor door, ImVec2 size, Workbench::Options how, float scale,
                   Language language)
    : context_(ImGui::CreateContext()) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.ConfigDragClickToInputText = true;
    io.DisplaySize = size;
    map_keys(io);
    style::apply(Theme::dark, scale, language);
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    workbench_ = std::make_unique<Workbench>(
        std::move(content), std::filesystem::path(), std::move(door), [] {}, how);
}

BareDesk::~BareDesk() {
    ImGui::SetCurrentContext(context_);
    workbench_.reset();
    ImGui::DestroyContext(context_);
}

void BareDesk::frame() {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = 1.0F / 60.0F;
    input_.feed(io);
    ImGui::NewFrame();
    if (auto files = input_.take_dropped(); !files.empty()) workbench_->drop(std::move(files));
    workbench_->draw([](const ViewRequest&) -> void* { return nullptr; });
    ImGui::Render();
}

void BareDesk::run_queue() {
    while (!input_.empty()) frame();
    frame();
}

}  // namespace hanei
