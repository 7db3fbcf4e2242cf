/// Keys and key chords, known by neither ImGui's nor the window's names.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hanei {

/// Letters and digits are their ASCII capitals; the others follow the window library's numbers, so
/// that no table stands between them (window.cpp asserts it). All are below 512, ImGui's limit.
enum class Key : int {
    none = 0,
    space = 32,
    comma = ',',
    minus = '-',
    slash = '/',
    plus = '=',  ///< where the plus stands on a US keyboard
    escape = 256,
    enter,
    tab,
    backspace,
    insert,
    del,
    right,
    left,
    down,
    up,
    page_up,
    page_down,
    home,
    end,
    f1 = 290,
    f3 = 292,
    keypad_0 = 320,  ///< to keypad_9
    keypad_1,
    keypad_2,
    keypad_3,
    keypad_4,
    keypad_5,
    keypad_6,
    keypad_7,
    keypad_8,
    keypad_9,
    keypad_decimal,
    keypad_minus = 333,
    keypad_plus = 334,
    keypad_enter = 335,
    left_shift = 340,
    left_control,
    left_alt,
    left_super,
    right_shift,
    right_control,
    right_alt,
    right_super,
};
inline constexpr int key_count = 512;

constexpr Key key_of(char capital) { return static_cast<Key>(capital); }

/// F1 to F9.
constexpr Key function_key(int number) { return static_cast<Key>(static_cast<int>(Key::f1) + number - 1); }

/// A key with the modifiers that must be held with it, and no others.
struct Chord {
    Key key = Key::none;
    bool control = false;
    bool shift = false;
    bool alt = false;
    bool operator==(const Chord&) const = default;
};

/// A letter or digit by itself, and with Ctrl.
constexpr Chord plain(char capital) { return {key_of(capital)}; }
constexpr Chord control(char capital, bool shift = false) { return {key_of(capital), true, shift}; }

/// "Ctrl+Shift+Z", "Delete", "F1"; empty for no key.
std::string to_text(const Chord& chord);

/// The chord of such a text; empty when it names none.
std::optional<Chord> chord_of(std::string_view text);

}  // namespace hanei
