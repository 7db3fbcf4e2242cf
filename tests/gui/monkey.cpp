#include "monkey.h"

#include "engine/edit/edit.h"

#include <array>
#include <fmt/format.h>
#include <string_view>

namespace hanei {
namespace {

/// What would only make the solver slow (the window is on trial here) or ends the program.
bool is_left_alone(std::string_view widget) {
    return widget.starts_with("settings.max-patch") || widget.starts_with("settings.memory") ||
           widget.starts_with("settings.threads") || widget == "file.quit";
}

constexpr std::array texts{
    "1.25",
    "-3",
    "0",
    "1e9",
    "1e999",
    "nan",
    "2*0.6+0.05",
    "5'-3 1/2\"",
    "1/0",
    "((((",
    "50 cm",
    "300 lx",
    "12 fc",
    "abc",
    "",
    " ",
    "%s%n%d",
    "照度",
    "\xff\xfe",
    "a name that is much longer than any field on the screen has room for",
    "0.3m",
    "-0",
    "1e-12",
    "100000",
    "../../etc/passwd",
    "0,0 6,0 6,4 0,4",
};

}  // namespace

ProjectContent random_room(unsigned seed) {
    std::mt19937 random(seed);
    const auto number = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto count = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
    Scene scene = empty_room();
    const double width = number(2.0, 12.0);
    const double depth = number(2.0, 12.0);
    scene.room->plan = {{0.0, 0.0}, {width, 0.0}, {width, depth}, {0.0, depth}};
    if (count(1) == 1) {  // an L
        scene.room->plan = {{0.0, 0.0},           {width, 0.0}, {width, 0.5 * depth}, {0.5 * width, 0.5 * depth},
                            {0.5 * width, depth}, {0.0, depth}};
        scene.room->wall_materials.assign(6, scene.room->wall_materials.front());
    }
    const auto place = [&](Added added) {
        const Vec3 from = *place_of(added.scene, added.object);
        const Vec3 to{number(0.3, 0.45 * width), number(0.3, 0.45 * depth), from.z};
        scene = moved(std::move(added.scene), added.object, to - from);
    };
    for (int k = count(3); k > 0; --k) place(with_box(scene));
    for (int k = 1 + count(2); k > 0; --k) place(with_panel_luminaire(scene));
    if (count(1) == 1) place(with_line_luminaire(scene));
    if (count(1) == 1) place(with_point_luminaire(scene));
    if (count(1) == 1) scene = with_grid(scene).scene;
    if (count(1) == 1) scene = with_calculation_point(scene).scene;
    ProjectContent content{std::move(scene), {}};
    content.settings.max_patch = 5.0;  // the window is on trial, not the solver
    content.settings.threads = 1;
    return content;
}

Monkey::Monkey(unsigned seed, const std::filesystem::path& log, std::vector<std::filesystem::path> files)
    : random_(seed), log_(log), files_(std::move(files)) {}

void Monkey::note(const std::string& event) { log_ << event << std::endl; }

Monkey::Place Monkey::somewhere(const BareDesk&) {
    return {static_cast<float>(below(1280)), static_cast<float>(below(800))};
}

Monkey::Place Monkey::some_widget(const BareDesk& desk) {
    const auto& all = desk.workbench().widgets().all();
    if (all.empty()) return somewhere(desk);
    auto chosen = all.begin();
    std::advance(chosen, below(static_cast<int>(all.size())));
    if (is_left_alone(chosen->first)) return somewhere(desk);
    note("at " + chosen->first);
    return {chosen->second.x(), chosen->second.y()};
}

void Monkey::click(BareDesk& desk, Place at, int button, int times) {
    note(fmt::format("click {} {} button {} x{}", at.x, at.y, button, times));
    desk.input().mouse_move(at.x, at.y);
    for (int k = 0; k < times; ++k) {
        desk.input().mouse_button(button, true);
        desk.input().mouse_button(button, false);
    }
    desk.run_queue();
}

void Monkey::drag(BareDesk& desk, Place from, Place to, int button) {
    note(fmt::format("drag {} {} to {} {} button {}", from.x, from.y, to.x, to.y, button));
    desk.input().mouse_move(from.x, from.y);
    desk.run_queue();
    desk.input().mouse_button(button, true);
    desk.run_queue();
    for (const float share : {0.3F, 0.7F, 1.0F}) {
        desk.input().mouse_move(from.x + share * (to.x - from.x), from.y + share * (to.y - from.y));
        desk.run_queue();
    }
    desk.input().mouse_button(button, false);
    desk.run_queue();
}

void Monkey::with_modifier(BareDesk& desk, bool down, Key key) {
    if (key != Key::none) desk.input().key(key, down);
}

void Monkey::press(BareDesk& desk, const Chord& chord) {
    if (chord.key == Key::none || chord == command(CommandId::quit).chord) return;
    note("key " + to_text(chord));
    const auto modifiers = [&](bool down) {
        if (chord.control) desk.input().key(Key::left_control, down);
        if (chord.shift) desk.input().key(Key::left_shift, down);
        if (chord.alt) desk.input().key(Key::left_alt, down);
    };
    modifiers(true);
    desk.input().key(chord.key, true);
    desk.input().key(chord.key, false);
    modifiers(false);
    desk.run_queue();
}

void Monkey::type(BareDesk& desk) {
    const std::string text = texts[static_cast<std::size_t>(below(static_cast<int>(texts.size())))];
    note("type " + text);
    desk.input().text(text);
    desk.run_queue();
    press(desk, {below(3) == 0 ? Key::escape : below(2) == 0 ? Key::tab : Key::enter});
}

void Monkey::act(BareDesk& desk) {
    constexpr std::array modifiers{Key::none, Key::none, Key::none, Key::left_shift, Key::left_control, Key::left_alt};
    const Key modifier = modifiers[static_cast<std::size_t>(below(static_cast<int>(modifiers.size())))];
    const int dice = below(100);
    if (dice < 45) {
        const Place at = some_widget(desk);
        with_modifier(desk, true, modifier);
        click(desk, at, below(12) == 0 ? 1 : 0, 1 + (below(8) == 0 ? 1 : 0));
        with_modifier(desk, false, modifier);
        if (below(3) == 0) type(desk);
    } else if (dice < 65) {
        const Place from = below(2) == 0 ? some_widget(desk) : somewhere(desk);
        with_modifier(desk, true, modifier);
        drag(desk, from, somewhere(desk), below(4) == 0 ? 1 + below(2) : 0);
        with_modifier(desk, false, modifier);
    } else if (dice < 75) {
        click(desk, somewhere(desk), below(6) == 0 ? 1 : 0, 1);
    } else if (dice < 88) {
        const auto all = commands();
        press(desk, all[static_cast<std::size_t>(below(static_cast<int>(all.size())))].chord);
    } else if (dice < 92) {
        press(desk, {static_cast<Key>(below(key_count)), below(3) == 0, below(3) == 0, below(6) == 0});
    } else if (dice < 96) {
        type(desk);
    } else if (dice < 99) {
        note("wheel");
        desk.input().wheel(static_cast<float>(below(7) - 3));
        desk.run_queue();
    } else if (!files_.empty()) {
        const std::filesystem::path& file = files_[static_cast<std::size_t>(below(static_cast<int>(files_.size())))];
        note("drop " + file.string());
        desk.input().drop({file});
        desk.run_queue();
    }
    desk.run_queue();
}

}  // namespace hanei
