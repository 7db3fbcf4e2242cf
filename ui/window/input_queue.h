/// What the user did, handed to ImGui at the pace of its frames.
///
/// ImGui reads input as a state once a frame, so that a click shorter than a frame would be lost.
/// The queue lets at most one button or key change into a frame ("trickling"); movements before it
/// melt into one. Windows, scripts and tests feed the same queue.
#pragma once

#include "ui/panels/key.h"

#include <deque>
#include <filesystem>
#include <string_view>
#include <variant>
#include <vector>

struct ImGuiIO;

namespace hanei {

class InputQueue {
public:
    void mouse_move(float x, float y);
    void mouse_leave();
    void mouse_button(int button, bool down);  ///< 0 left, 1 right, 2 middle
    void wheel(float notches);
    void key(Key key, bool down);  ///< Ctrl, Shift and Alt are keys as well
    void character(char32_t code);
    void text(std::string_view utf8);
    void focus(bool gained);
    void drop(std::vector<std::filesystem::path> files);  ///< where the pointer is

    bool empty() const { return events_.empty(); }

    /// Hands this frame's share to ImGui. Call before ImGui::NewFrame.
    void feed(ImGuiIO& io);

    /// The files whose turn came with the last feed(), once: ImGui has no place for them.
    std::vector<std::filesystem::path> take_dropped();

private:
    struct Move {
        float x, y;
    };
    struct Button {
        int button;
        bool down;
    };
    struct Wheel {
        float notches;
    };
    struct KeyChange {
        Key key;
        bool down;
    };
    struct Character {
        char32_t code;
    };
    struct Focus {
        bool gained;
    };
    struct Drop {
        std::vector<std::filesystem::path> files;
    };
    using Event = std::variant<Move, Button, Wheel, KeyChange, Character, Focus, Drop>;

    std::deque<Event> events_;
    std::vector<std::filesystem::path> dropped_;
};

/// Names our keys to the present ImGui context. Once after it is made.
void map_keys(ImGuiIO& io);

}  // namespace hanei
