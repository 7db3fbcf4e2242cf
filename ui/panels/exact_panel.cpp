#include "ui/panels/exact_panel.h"

#include "engine/base/stand_back.h"
#include "engine/base/tiles.h"
#include "ui/panels/language.h"
#include "ui/panels/style.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace hanei {
namespace {

constexpr int rays_at_edges = 16;
constexpr float screen_share = 0.8F;  // of the window's sides that the picture may take

bool panel_button(const char* label, const char* name, WidgetRegistry& widgets) {
    const bool pressed = ImGui::Button(tr(label), {110.0F * style::scale(), 0.0F});
    widgets.note(name);
    return pressed;
}

}  // namespace

void ExactPanel::start(SolutionSnapshot solution, PictureRequest request) {
    cancel();
    shown_.reset();
    solution_ = std::move(solution);
    request_ = std::move(request);
    progress_.enter(Stage::idle);
    const ExactRequest exact{request_.camera, request_.options, view_size(request_), rays_at_edges};
    const int threads = solution_->settings.threads > 0 ? solution_->settings.threads : hardware_threads();
    painting_ = std::jthread([this, exact, threads, painted = solution_](const std::stop_token& stop) {
        stand_back();
        std::shared_ptr<const ExactPicture> room;
        std::string failure;
        try {
            room = exact_room(painted, exact, {threads, stop, &progress_});
        } catch (const std::exception& fault) {
            failure = fault.what();
        }
        {
            const std::scoped_lock lock(guard_);
            room_ = std::move(room);
            failure_ = std::move(failure);
            done_ = true;
        }
        wake_();
    });
}

void ExactPanel::cancel() {
    if (!painting_.joinable()) return;
    painting_.request_stop();
    painting_.join();
    room_.reset();
    failure_.clear();
    done_ = false;
}

void ExactPanel::after_frame() {
    {
        const std::scoped_lock lock(guard_);
        if (!done_) return;
        done_ = false;
    }
    painting_.join();
    request_.exact = std::move(room_);
    shown_failure_ = std::exchange(failure_, {});
    if (!request_.exact) return;
    shown_ = render_picture(solution_, request_);
    request_.exact.reset();
    ++number_;
    wake_();  // it is seen from the next frame on
}

void ExactPanel::draw(const ViewPainter& paint, const std::function<void()>& save, WidgetRegistry& widgets) {
    if (shown_) draw_picture(paint, save, widgets);
}

Task ExactPanel::task() {
    const float fraction = progress_.fraction();
    return {"exact", tr("Exact picture"), fraction, left_.text(progress_.stage(), fraction), [this] { cancel(); }};
}

void ExactPanel::draw_picture(const ViewPainter& paint, const std::function<void()>& save, WidgetRegistry& widgets) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float width = static_cast<float>(shown_->width), height = static_cast<float>(shown_->height);
    const float size = std::min({1.0F, screen_share * screen.x / width, screen_share * screen.y / height});
    ImGui::SetNextWindowPos({0.5F * screen.x, 0.5F * screen.y}, ImGuiCond_Appearing, {0.5F, 0.5F});
    bool stays = true;
    const int plain =
        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
    if (ImGui::Begin(fmt::format("{}###exact picture", tr("Exact picture")).c_str(), &stays, plain)) {
        ViewRequest request;
        request.slot = ViewRequest::picture_slot;
        request.picture = &*shown_;
        request.picture_number = number_;
        if (void* const texture = paint(request)) ImGui::Image(texture, {size * width, size * height});
        widgets.note("exact.picture");
        if (panel_button("Save...", "exact.save", widgets)) save();
        ImGui::SameLine();
        if (panel_button("Close", "exact.close", widgets)) stays = false;
    }
    ImGui::End();
    if (!stays) shown_.reset();
}

}  // namespace hanei
