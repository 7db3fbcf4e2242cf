#include "ui/panels/key.h"

#include <array>
#include <cctype>
#include <utility>

namespace hanei {
namespace {

constexpr std::array names{
    std::pair{Key::space, "Space"},
    std::pair{Key::minus, "-"},
    std::pair{Key::comma, ","},
    std::pair{Key::slash, "/"},
    std::pair{Key::plus, "+"},
    std::pair{Key::keypad_minus, "Keypad -"},
    std::pair{Key::keypad_plus, "Keypad +"},
    std::pair{Key::escape, "Esc"},
    std::pair{Key::enter, "Enter"},
    std::pair{Key::tab, "Tab"},
    std::pair{Key::backspace, "Backspace"},
    std::pair{Key::insert, "Insert"},
    std::pair{Key::del, "Delete"},
    std::pair{Key::right, "Right"},
    std::pair{Key::left, "Left"},
    std::pair{Key::down, "Down"},
    std::pair{Key::up, "Up"},
    std::pair{Key::page_up, "Page Up"},
    std::pair{Key::page_down, "Page Down"},
    std::pair{Key::home, "Home"},
    std::pair{Key::end, "End"},
    std::pair{Key::f1, "F1"},
    std::pair{Key::f3, "F3"},
    std::pair{Key::keypad_0, "Keypad 0"},
    std::pair{Key::keypad_1, "Keypad 1"},
    std::pair{Key::keypad_2, "Keypad 2"},
    std::pair{Key::keypad_3, "Keypad 3"},
    std::pair{Key::keypad_4, "Keypad 4"},
    std::pair{Key::keypad_5, "Keypad 5"},
    std::pair{Key::keypad_6, "Keypad 6"},
    std::pair{Key::keypad_7, "Keypad 7"},
    std::pair{Key::keypad_8, "Keypad 8"},
    std::pair{Key::keypad_9, "Keypad 9"},
    std::pair{Key::keypad_decimal, "Keypad ."},
    std::pair{function_key(2), "F2"},
    std::pair{function_key(3), "F3"},
    std::pair{function_key(4), "F4"},
    std::pair{function_key(5), "F5"},
    std::pair{function_key(6), "F6"},
    std::pair{function_key(7), "F7"},
    std::pair{function_key(8), "F8"},
    std::pair{function_key(9), "F9"},
    std::pair{Key::left_shift, "Shift"},
    std::pair{Key::left_control, "Ctrl"},
    std::pair{Key::left_alt, "Alt"},
};

std::optional<Key> key_named(std::string_view name) {
    for (const auto& [key, text] : names) {
        if (name == text) return key;
    }
    if (name.size() != 1 || std::isalnum(static_cast<unsigned char>(name[0])) == 0) return std::nullopt;
    return key_of(static_cast<char>(std::toupper(static_cast<unsigned char>(name[0]))));
}

}  // namespace

std::string to_text(const Chord& chord) {
    if (chord.key == Key::none) return {};
    if (chord == Chord{Key::slash, false, true}) return "?";
    std::string text;
    if (chord.control) text += "Ctrl+";
    if (chord.shift) text += "Shift+";
    if (chord.alt) text += "Alt+";
    for (const auto& [key, name] : names) {
        if (key == chord.key) return text + name;
    }
    return text + static_cast<char>(chord.key);
}

std::optional<Chord> chord_of(std::string_view text) {
    if (text == "?") return Chord{Key::slash, false, true};
    Chord chord;
    for (;;) {
        const std::size_t plus = text.find('+');
        if (plus == std::string_view::npos || plus + 1 == text.size()) break;
        const std::string_view modifier = text.substr(0, plus);
        if (modifier == "Ctrl")
            chord.control = true;
        else if (modifier == "Shift")
            chord.shift = true;
        else if (modifier == "Alt")
            chord.alt = true;
        else
            return std::nullopt;
        text.remove_prefix(plus + 1);
    }
    const std::optional<Key> key = key_named(text);
    if (!key) return std::nullopt;
    chord.key = *key;
    return chord;
}

}  // namespace hanei
