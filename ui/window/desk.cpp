#include "ui/window/desk.h"

#include "ui/panels/scene_letters.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <backends/imgui_impl_opengl3.h>
#include <glad/gl.h>
#include <imgui.h>
#include <stdexcept>

namespace hanei {

Desk::Desk(Setup setup) : context_(ImGui::CreateContext()), screen_scale_(setup.scale) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;               // the layout is the workbench's own
    io.ConfigInputTextCursorBlink = false;  // a blinking cursor would keep an idle window drawing
    io.ConfigDragClickToInputText = true;   // a click on a figure types, a drag slides it
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    map_keys(io);
    if (!ImGui_ImplOpenGL3_Init("#version 330"))
        throw std::runtime_error("The window's OpenGL drawing does not start.");
    textures_ = std::make_unique<ViewTextures>();
    workbench_ =
        std::make_unique<Workbench>(std::move(setup.content), std::move(setup.file), std::move(setup.door),
                                    std::move(setup.wake), Workbench::Options{setup.repeatable, setup.patience});
    const Preferences& wished = workbench_->preferences();
    style::apply(wished.theme, wished.scale > 0.0 ? static_cast<float>(wished.scale) : screen_scale_, wished.language);
}

Desk::~Desk() {
    ImGui::SetCurrentContext(context_);
    workbench_.reset();
    textures_.reset();
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(context_);
}

bool Desk::wants_text() const { return ImGui::GetIO().WantTextInput; }

void Desk::frame(PixelSize size, float seconds) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
    io.DeltaTime = std::max(seconds, 1e-4F);  // ImGui refuses frames without duration
    if (style::follow(workbench_->preferences(), screen_scale_)) {
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
    }
    input_.feed(io);
    for (const ImWchar typed : io.InputQueueCharacters) style::needs(typed);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    if (auto files = input_.take_dropped(); !files.empty()) workbench_->drop(std::move(files));
    workbench_->draw([this](const ViewRequest& request) { return textures_->paint(request); });
    if (const SceneSnapshot& scene = workbench_->document().shown(); scene != lettered_)
        need_letters_of(*(lettered_ = scene));
    style::needs(workbench_->title());
    style::needs(workbench_->message());
    ImGui::Render();
    glViewport(0, 0, size.width, size.height);
    glDisable(GL_SCISSOR_TEST);
    const ImVec4 ground = style::colour(style::ground);
    glClearColor(ground.x, ground.y, ground.z, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    workbench_->after_frame();
}

}  // namespace hanei
