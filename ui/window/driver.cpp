#include "ui/window/driver.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glad/gl.h>
#include <thread>

namespace hanei {
namespace {

using Clock = std::chrono::steady_clock;

constexpr float frame_seconds = 1.0F / 60.0F;
constexpr int drag_steps = 12;
constexpr int settling_frames = 3;                               // as the window draws after input
constexpr std::chrono::milliseconds look_at_progress_every{50};  // as the window does while a study runs

ImVec2 middle(const ScreenRect& rect) { return {std::round(rect.x()), std::round(rect.y())}; }

}  // namespace

Driver::Driver(Setup setup) : size_(setup.size) {
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glGenRenderbuffers(1, &colour_);
    glBindRenderbuffer(GL_RENDERBUFFER, colour_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size_.width, size_.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
    const auto wake = [this] {
        const std::lock_guard lock(mutex_);
        woken_ = true;
        wakes_.notify_all();
    };
    desk_ = std::make_unique<Desk>(Desk::Setup{std::move(setup.content), std::move(setup.file), std::move(setup.door),
                                               wake, setup.scale, true, setup.patience});
    frames(settling_frames);
}

Driver::~Driver() {
    desk_.reset();
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(1, &colour_);
}

void Driver::frames(int count) {
    for (int k = 0; k < count; ++k) {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        const auto begun = Clock::now();
        desk_->frame(size_, frame_seconds);
        if (recorder_ == nullptr) continue;
        glFinish();
        const std::chrono::duration<double> passed = Clock::now() - begun;
        recorder_->note(passed.count(), workbench().study(), recorder_->wants_picture() ? picture() : Image{});
    }
}

void Driver::run_queue() {
    while (!desk_->input().empty()) frames(1);
    frames(settling_frames);
}

bool Driver::wait_settled(double seconds) {
    return wait_until([this] { return workbench().study().settled() && !workbench().document().in_gesture(); },
                      seconds);
}

bool Driver::wait_until(const std::function<bool()>& so, double seconds) {
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    frames(1);
    while (!so()) {
        std::unique_lock lock(mutex_);
        wakes_.wait_for(lock, look_at_progress_every, [&] { return woken_; });
        woken_ = false;
        lock.unlock();
        frames(1);
        if (Clock::now() > end) return false;
    }
    frames(settling_frames);
    return true;
}

void Driver::point_at(float x, float y) {
    desk_->input().mouse_move(x, y);
    run_queue();
}

void Driver::button(int which, bool down) {
    desk_->input().mouse_button(which, down);
    run_queue();
}

void Driver::wheel(float notches) {
    desk_->input().wheel(notches);
    run_queue();
}

Driver::Fault Driver::point_at(const std::string& widget) {
    const ScreenRect* rect = workbench().widgets().find(widget);
    if (rect == nullptr) return "there is no widget \"" + widget + "\" on the screen";
    const ImVec2 at = middle(*rect);
    point_at(at.x, at.y);
    return {};
}

void Driver::hold(Held held, bool down) {
    if (held.control) desk_->input().key(Key::left_control, down);
    if (held.shift) desk_->input().key(Key::left_shift, down);
    if (held.alt) desk_->input().key(Key::left_alt, down);
}

Driver::Fault Driver::click(const std::string& widget, int which, Held held) {
    if (Fault fault = point_at(widget); !fault.empty()) return fault;
    hold(held, true);
    button(which, true);
    button(which, false);
    hold(held, false);
    run_queue();
    return {};
}

Driver::Fault Driver::double_click(const std::string& widget) {
    if (Fault fault = point_at(widget); !fault.empty()) return fault;
    twice();
    return {};
}

void Driver::twice() {
    for (int k = 0; k < 2; ++k) {
        desk_->input().mouse_button(0, true);
        desk_->input().mouse_button(0, false);
    }
    run_queue();
}

/// In `drag_steps` frames, or paced by the clock when it is to last some seconds.
void Driver::drag_path(ImVec2 from, ImVec2 to, double seconds) {
    point_at(from.x, from.y);
    button(0, true);
    const auto begun = Clock::now();
    for (int k = 1;; ++k) {
        const double passed = std::chrono::duration<double>(Clock::now() - begun).count();
        const double share = std::min(1.0, seconds > 0.0 ? passed / seconds : static_cast<double>(k) / drag_steps);
        const auto along = static_cast<float>(share);
        desk_->input().mouse_move(from.x + along * (to.x - from.x), from.y + along * (to.y - from.y));
        frames(1);
        if (share >= 1.0) break;
        if (seconds <= 0.0) continue;
        const std::chrono::duration<double> next(k * static_cast<double>(frame_seconds));
        std::this_thread::sleep_until(begun + std::chrono::duration_cast<Clock::duration>(next));
    }
    button(0, false);
}

Driver::Fault Driver::drag(const std::string& widget, float dx, float dy) {
    const ScreenRect* rect = workbench().widgets().find(widget);
    if (rect == nullptr) return "there is no widget \"" + widget + "\" on the screen";
    const ImVec2 from = middle(*rect);
    drag_path(from, {from.x + dx, from.y + dy}, 0.0);
    return {};
}

Driver::Fault Driver::point_at_object(const std::string& object) {
    const auto at = object_on_screen(object);
    if (!at) return "there is no object \"" + object + "\" in the view, or others hide it";
    point_at(at->x, at->y);
    return {};
}

Driver::Fault Driver::click_object(const std::string& object, int which, Held held) {
    if (Fault fault = point_at_object(object); !fault.empty()) return fault;
    hold(held, true);
    button(which, true);
    button(which, false);
    hold(held, false);
    run_queue();
    return {};
}

Driver::Fault Driver::double_click_object(const std::string& object) {
    if (Fault fault = point_at_object(object); !fault.empty()) return fault;
    twice();
    return {};
}

void Driver::drag_over(ImVec2 from, ImVec2 to, Held held) {
    hold(held, true);
    drag_path(from, to, 0.0);
    hold(held, false);
    run_queue();
}

void Driver::move_by(float dx, float dy) {
    const ImVec2 at = ImGui::GetIO().MousePos;
    point_at(at.x + dx, at.y + dy);
}

void Driver::drop(std::vector<std::filesystem::path> files, float x, float y) {
    desk_->input().mouse_move(x, y);
    desk_->input().drop(std::move(files));
    run_queue();
}

Driver::Fault Driver::drop_on_object(std::vector<std::filesystem::path> files, const std::string& object) {
    const auto at = object_on_screen(object);
    if (!at) return "there is no object \"" + object + "\" in the view";
    drop(std::move(files), at->x, at->y);
    return {};
}

Driver::Fault Driver::press(std::string_view text, double seconds) {
    const std::optional<Chord> chord = chord_of(text);
    if (!chord) return "there is no key \"" + std::string(text) + "\"";
    InputQueue& input = desk_->input();
    const auto modifiers = [&](bool down) {
        if (chord->control) input.key(Key::left_control, down);
        if (chord->shift) input.key(Key::left_shift, down);
        if (chord->alt) input.key(Key::left_alt, down);
    };
    modifiers(true);
    input.key(chord->key, true);
    if (seconds > 0.0) {
        while (!input.empty()) frames(1);
        frames(static_cast<int>(std::lround(seconds / static_cast<double>(frame_seconds))) - 1);
    }
    input.key(chord->key, false);
    modifiers(false);
    run_queue();
    return {};
}

void Driver::type(std::string_view text) {
    desk_->input().text(text);
    run_queue();
}

Image Driver::picture() const {
    Image image{size_.width, size_.height, {}};
    const std::size_t row = 4 * static_cast<std::size_t>(size_.width);
    image.rgba.resize(row * static_cast<std::size_t>(size_.height));
    std::vector<std::uint8_t> upside_down(image.rgba.size());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size_.width, size_.height, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.data());
    for (std::size_t y = 0; y < static_cast<std::size_t>(size_.height); ++y) {
        const auto* from = upside_down.data() + (static_cast<std::size_t>(size_.height) - 1 - y) * row;
        std::copy(from, from + row, image.rgba.data() + y * row);
    }
    for (std::size_t k = 3; k < image.rgba.size(); k += 4) image.rgba[k] = 255;  // a window is opaque
    return image;
}

}  // namespace hanei
