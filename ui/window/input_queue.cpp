#include "ui/window/input_queue.h"

#include <algorithm>
#include <cfloat>
#include <imgui.h>
#include <utility>

namespace hanei {
namespace {

/// Takes events into ImGui's state; `apply` says no when an event has to wait for the next frame.
struct Frame {
    ImGuiIO& io;
    bool changed = false;  ///< a button, key or wheel changed in this frame
    bool typed = false;

    template <class Change>
    bool once(Change change) {
        if (changed || typed) return false;
        change();
        changed = true;
        return true;
    }
    void set_key(Key key, bool down) {
        io.KeysDown[static_cast<int>(key)] = down;
        const auto held = [&](Key left, Key right) {
            return io.KeysDown[static_cast<int>(left)] || io.KeysDown[static_cast<int>(right)];
        };
        io.KeyCtrl = held(Key::left_control, Key::right_control);
        io.KeyShift = held(Key::left_shift, Key::right_shift);
        io.KeyAlt = held(Key::left_alt, Key::right_alt);
        io.KeySuper = held(Key::left_super, Key::right_super);
    }
    void release_all() {
        for (int k = 0; k < key_count; ++k) set_key(static_cast<Key>(k), false);
        std::fill(std::begin(io.MouseDown), std::end(io.MouseDown), false);
    }
};

}  // namespace

void InputQueue::mouse_move(float x, float y) {
    if (!events_.empty()) {
        if (Move* last = std::get_if<Move>(&events_.back())) {
            *last = {x, y};
            return;
        }
    }
    events_.push_back(Move{x, y});
}

void InputQueue::mouse_leave() { events_.push_back(Move{-FLT_MAX, -FLT_MAX}); }
void InputQueue::mouse_button(int button, bool down) {
    if (button >= 0 && button < 3) events_.push_back(Button{button, down});
}
void InputQueue::wheel(float notches) { events_.push_back(Wheel{notches}); }
void InputQueue::key(Key key, bool down) {
    if (static_cast<int>(key) > 0 && static_cast<int>(key) < key_count) events_.push_back(KeyChange{key, down});
}
void InputQueue::character(char32_t code) { events_.push_back(Character{code}); }
void InputQueue::focus(bool gained) { events_.push_back(Focus{gained}); }

void InputQueue::drop(std::vector<std::filesystem::path> files) {
    if (!files.empty()) events_.push_back(Drop{std::move(files)});
}

std::vector<std::filesystem::path> InputQueue::take_dropped() { return std::exchange(dropped_, {}); }

void InputQueue::text(std::string_view utf8) {
    for (std::size_t i = 0; i < utf8.size();) {
        const auto lead = static_cast<unsigned char>(utf8[i]);
        const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
        char32_t code = length == 1 ? lead : lead & (0xFFU >> (length + 1));
        for (std::size_t k = 1; k < length && i + k < utf8.size(); ++k) {
            code = (code << 6) | (static_cast<unsigned char>(utf8[i + k]) & 0x3FU);
        }
        character(code);
        i += length;
    }
}

void InputQueue::feed(ImGuiIO& io) {
    Frame frame{io};
    struct Apply {
        Frame& frame;
        std::vector<std::filesystem::path>& dropped;
        bool operator()(const Move& event) const {
            if (frame.changed) return false;
            frame.io.MousePos = ImVec2(event.x, event.y);
            return true;
        }
        bool operator()(const Button& event) const {
            return frame.once([&] { frame.io.MouseDown[event.button] = event.down; });
        }
        bool operator()(const Wheel& event) const {
            return frame.once([&] { frame.io.MouseWheel += event.notches; });
        }
        bool operator()(const KeyChange& event) const {
            return frame.once([&] { frame.set_key(event.key, event.down); });
        }
        bool operator()(const Character& event) const {
            // A key and the text it writes belong together: the text follows in the same frame.
            frame.io.AddInputCharacter(static_cast<unsigned>(event.code));
            frame.typed = true;
            return true;
        }
        bool operator()(const Focus& event) const {
            if (!event.gained) frame.release_all();  // the keys' release goes to another window
            frame.io.AddFocusEvent(event.gained);
            return true;
        }
        bool operator()(const Drop& event) const {
            return frame.once([&] { dropped = event.files; });
        }
    };
    while (!events_.empty() && std::visit(Apply{frame, dropped_}, events_.front())) events_.pop_front();
}

void map_keys(ImGuiIO& io) {
    const auto map = [&](ImGuiKey theirs, Key ours) { io.KeyMap[theirs] = static_cast<int>(ours); };
    map(ImGuiKey_Tab, Key::tab);
    map(ImGuiKey_LeftArrow, Key::left);
    map(ImGuiKey_RightArrow, Key::right);
    map(ImGuiKey_UpArrow, Key::up);
    map(ImGuiKey_DownArrow, Key::down);
    map(ImGuiKey_PageUp, Key::page_up);
    map(ImGuiKey_PageDown, Key::page_down);
    map(ImGuiKey_Home, Key::home);
    map(ImGuiKey_End, Key::end);
    map(ImGuiKey_Insert, Key::insert);
    map(ImGuiKey_Delete, Key::del);
    map(ImGuiKey_Backspace, Key::backspace);
    map(ImGuiKey_Space, Key::space);
    map(ImGuiKey_Enter, Key::enter);
    map(ImGuiKey_KeyPadEnter, Key::keypad_enter);
    map(ImGuiKey_Escape, Key::escape);
    map(ImGuiKey_A, key_of('A'));
    map(ImGuiKey_C, key_of('C'));
    map(ImGuiKey_V, key_of('V'));
    map(ImGuiKey_X, key_of('X'));
    map(ImGuiKey_Y, key_of('Y'));
    map(ImGuiKey_Z, key_of('Z'));
}

}  // namespace hanei
