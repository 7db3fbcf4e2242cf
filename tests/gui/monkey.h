/// Somebody who presses everything: random events at the widgets and in the view.
#pragma once

#include "bare_desk.h"

#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace hanei {

/// A room with furniture and luminaires of all kinds, another for each seed; fit to be solved.
ProjectContent random_room(unsigned seed);

class Monkey {
public:
    /// Every event is written to `log` before it happens, so that a crash tells what led to it.
    /// `files` are what it drops on the window.
    Monkey(unsigned seed, const std::filesystem::path& log, std::vector<std::filesystem::path> files);

    /// One event of a person: a click, a drag, a key, a typed text, a file dropped.
    void act(BareDesk& desk);

private:
    struct Place {
        float x = 0.0F, y = 0.0F;
    };
    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
    Place some_widget(const BareDesk& desk);
    Place somewhere(const BareDesk& desk);
    void note(const std::string& event);

    void click(BareDesk& desk, Place at, int button, int times);
    void drag(BareDesk& desk, Place from, Place to, int button);
    void press(BareDesk& desk, const Chord& chord);
    void type(BareDesk& desk);
    void with_modifier(BareDesk& desk, bool down, Key key);

    std::mt19937 random_;
    std::ofstream log_;
    std::vector<std::filesystem::path> files_;
};

}  // namespace hanei
