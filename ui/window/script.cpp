#include "ui/window/script.h"

#include "ui/panels/state_text.h"

#include <charconv>
#include <cmath>
#include <memory>
#include <ostream>
#include <sstream>
#include <vector>

namespace hanei {
namespace {

using Words = std::vector<std::string>;
using Fault = Driver::Fault;

Words words_of(const std::string& line) {
    Words words;
    for (std::size_t at = 0; at < line.size();) {
        if (line[at] == ' ' || line[at] == '\t' || line[at] == '\r') {
            ++at;
        } else if (line[at] == '#') {
            break;
        } else if (line[at] == '"') {
            const std::size_t end = std::min(line.find('"', at + 1), line.size());
            words.push_back(line.substr(at + 1, end - at - 1));
            at = end + 1;
        } else {
            const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
            words.push_back(line.substr(at, end - at));
            at = end;
        }
    }
    return words;
}

std::optional<double> figure_of(const std::string& word) {
    double value = 0.0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (fault != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
}

class Player {
public:
    Player(Driver& driver, std::ostream& out) : driver_(driver), out_(out) {}
    ~Player() { driver_.record(nullptr); }
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    Fault play(const Words& words) {
        const std::string& verb = words[0];
        const auto is = [&](const char* name, std::size_t count) { return verb == name && words.size() == count; };
        if (verb == "click" || verb == "right" || verb == "double") return click(words);
        if (verb == "box") return box(words);
        if (verb == "hold") return hold(words);
        if (verb == "move") return move(words);
        if (is("release", 1)) return driver_.button(0, false), Fault{};
        if (verb == "point") return point(words);
        if (verb == "drag") return drag(words);
        if (verb == "drop") return drop(words);
        if (verb == "record") return record(words);
        if (is("report", 2) && words[1] == "latency") return report();
        if (is("key", 2)) return driver_.press(words[1]);
        if (is("key", 4) && words[2] == "for") return press_for(words);
        if (is("type", 2)) return driver_.type(words[1]), Fault{};
        if (is("wait", 2)) return wait(words[1]);
        if (is("shot", 2)) return write_png(driver_.picture(), words[1]), Fault{};
        if (is("print", 2)) return print(words[1]);
        if (is("remember", 2)) return remembered_[words[1]] = state(words[1]), Fault{};
        if (is("expect-changed", 2)) return compare(words[1], false);
        if (is("expect-same", 2)) return compare(words[1], true);
        if (verb == "expect") return expect(words);
        const auto notches = is("wheel", 2) ? figure_of(words[1]) : std::nullopt;
        if (notches) return driver_.wheel(static_cast<float>(*notches)), Fault{};
        return "\"" + verb + "\" with " + std::to_string(words.size() - 1) + " words after it means nothing";
    }

private:
    Fault point(const Words& words) {
        if (words.size() == 2) return driver_.point_at(words[1]);
        if (words.size() != 3) return "point wants a widget, an object or two figures";
        if (words[1] == "object") return driver_.point_at_object(words[2]);
        const auto x = figure_of(words[1]);
        const auto y = figure_of(words[2]);
        if (!x || !y) return "point wants a widget, an object or two figures";
        driver_.point_at(static_cast<float>(*x), static_cast<float>(*y));
        return {};
    }

    /// The keys held, when the words end with "with KEY"; takes those words away.
    static std::optional<Driver::Held> held_of(Words& words) {
        Driver::Held held;
        if (words.size() < 3 || words[words.size() - 2] != "with") return held;
        const std::string key = words.back();
        words.resize(words.size() - 2);
        held.shift = key == "Shift" || key == "Ctrl+Shift";
        held.control = key == "Ctrl" || key == "Ctrl+Shift";
        held.alt = key == "Alt";
        if (!held.shift && !held.control && !held.alt) return std::nullopt;
        return held;
    }

    Fault click(Words words) {
        const auto held = held_of(words);
        if (!held) return "with wants Shift, Ctrl or Alt";
        const bool object = words.size() == 3 && words[1] == "object";
        if (!object && words.size() != 2) return words[0] + " wants a widget or an object";
        const int button = words[0] == "right" ? 1 : 0;
        if (words[0] == "double")
            return object ? driver_.double_click_object(words[2]) : driver_.double_click(words[1]);
        return object ? driver_.click_object(words[2], button, *held) : driver_.click(words[1], button, *held);
    }

    Fault box(Words words) {
        const auto held = held_of(words);
        std::vector<float> figures;
        for (std::size_t k = 1; k < words.size(); ++k)
            if (const auto figure = figure_of(words[k])) figures.push_back(static_cast<float>(*figure));
        if (!held || words.size() != 5 || figures.size() != 4) return "box wants X Y X Y [with Shift or Ctrl]";
        if (Fault fault = driver_.press("B"); !fault.empty()) return fault;
        driver_.drag_over({figures[0], figures[1]}, {figures[2], figures[3]}, *held);
        return {};
    }

    Fault hold(const Words& words) {
        const bool object = words.size() == 3 && words[1] == "object";
        if (!object && words.size() != 2) return "hold wants a widget or an object";
        if (Fault fault = object ? driver_.point_at_object(words[2]) : driver_.point_at(words[1]); !fault.empty())
            return fault;
        driver_.button(0, true);
        return {};
    }

    Fault press_for(const Words& words) {
        const auto seconds = figure_of(words[3]);
        if (!seconds || !(*seconds > 0.0 && *seconds <= 600.0)) return "key wants CHORD for SECONDS, up to 600";
        return driver_.press(words[1], *seconds);
    }

    Fault move(const Words& words) {
        const auto dx = words.size() == 3 ? figure_of(words[1]) : std::nullopt;
        const auto dy = words.size() == 3 ? figure_of(words[2]) : std::nullopt;
        if (!dx || !dy) return "move wants DX DY";
        driver_.move_by(static_cast<float>(*dx), static_cast<float>(*dy));
        return {};
    }

    Fault drag(const Words& words) {
        const bool timed = words.size() == 9 && words[7] == "in";
        const bool object = (words.size() == 7 || timed) && words[1] == "object";
        const std::size_t by = object ? 3 : 2;
        const std::size_t end = by + (object ? 4 : 3);
        if (words.size() != end + (object && timed ? 2 : 0) || words[by] != "by")
            return "drag wants WIDGET by DX DY, or object NAME by DX DY DZ [in SECONDS]";
        Vec3 figures{0.0};
        for (std::size_t k = by + 1; k < end; ++k) {
            const auto figure = figure_of(words[k]);
            if (!figure) return "\"" + words[k] + "\" is no figure";
            figures[static_cast<int>(k - by - 1)] = *figure;
        }
        const auto seconds = timed ? figure_of(words.back()) : std::optional(0.0);
        if (!seconds || *seconds < 0.0) return "\"" + words.back() + "\" is no time in seconds";
        if (object) return driver_.drag_object(words[2], figures, *seconds);
        return driver_.drag(words[1], static_cast<float>(figures.x), static_cast<float>(figures.y));
    }

    Fault drop(const Words& words) {
        if (words.size() < 4) return "drop wants FILE... X Y, or FILE... object NAME";
        std::vector<std::filesystem::path> files(words.begin() + 1, words.end() - 2);
        const std::string& last = words.back();
        if (words[words.size() - 2] == "object") return driver_.drop_on_object(std::move(files), last);
        const auto x = figure_of(words[words.size() - 2]);
        const auto y = figure_of(last);
        if (!x || !y) return "drop wants FILE... X Y, or FILE... object NAME";
        driver_.drop(std::move(files), static_cast<float>(*x), static_cast<float>(*y));
        return {};
    }

    Fault record(const Words& words) {
        const auto every = words.size() == 4 && words[2] == "every" ? figure_of(words[3]) : std::nullopt;
        if (!every || *every < 1.0 || *every > 1e6) return "record wants FOLDER every N, N a number of frames";
        recorder_ = std::make_unique<Recorder>(words[1], static_cast<int>(*every));
        driver_.record(recorder_.get());
        return {};
    }

    Fault report() {
        if (!recorder_) return "nothing was recorded";
        driver_.record(nullptr);
        out_ << recorder_->report();
        recorder_->write();
        recorder_.reset();
        return {};
    }

    Fault wait(const std::string& what) {
        if (what == "exact")
            return driver_.wait_until([&] { return driver_.workbench().exact().shown() != nullptr; })
                       ? Fault{}
                       : "no exact picture within two minutes";
        if (what == "converged") return driver_.wait_settled() ? Fault{} : "no complete answer within two minutes";
        const auto count = figure_of(what);
        if (!count) return "wait wants \"converged\", \"exact\" or a number of frames";
        driver_.frames(static_cast<int>(*count));
        return {};
    }

    std::string state(const std::string& name) const {
        const auto all = state_of(driver_.workbench());
        const auto found = all.find(name);
        return found == all.end() ? std::string() : found->second;
    }

    Fault print(const std::string& what) {
        if (what == "state")
            out_ << state_json(driver_.workbench());
        else if (what == "widgets")
            for (const auto& [name, rect] : driver_.workbench().widgets().all()) out_ << name << '\n';
        else
            out_ << what << ": " << state(what) << '\n';
        out_ << std::flush;  // it is there, however the program ends
        return {};
    }

    Fault compare(const std::string& name, bool same) {
        const auto found = remembered_.find(name);
        if (found == remembered_.end()) return "\"" + name + "\" was not remembered";
        const std::string now = state(name);
        if ((now == found->second) == same) return {};
        return "\"" + name + "\" was " + found->second + (same ? ", and is " + now : ", and still is");
    }

    Fault expect(const Words& words) {
        if (words.size() != 3 && !(words.size() == 5 && words[3] == "within"))
            return "expect wants NAME VALUE [within TOLERANCE]";
        const std::string now = state(words[1]);
        const auto wanted = figure_of(words[2]);
        const auto got = figure_of(now);
        const auto tolerance = words.size() == 5 ? figure_of(words[4]) : std::optional(1e-9);
        const bool fits = wanted && got && tolerance ? std::abs(*wanted - *got) <= *tolerance : now == words[2];
        return fits ? Fault{} : "\"" + words[1] + "\" is \"" + now + "\", not \"" + words[2] + "\"";
    }

    Driver& driver_;
    std::ostream& out_;
    std::map<std::string, std::string> remembered_;
    std::unique_ptr<Recorder> recorder_;
};

}  // namespace

std::optional<Diagnostic> play_script(std::string_view text, const std::string& file, Driver& driver,
                                      std::ostream& out) {
    Player player(driver, out);
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        const Words words = words_of(line);
        if (words.empty()) continue;
        Fault fault;
        try {
            fault = player.play(words);
        } catch (const std::runtime_error& failure) {
            fault = failure.what();
        }
        if (fault.empty()) continue;
        Diagnostic finding;
        finding.place.file = file;
        finding.place.line = number;
        finding.place.field = words[0];
        finding.message = fault;
        return finding;
    }
    return std::nullopt;
}

}  // namespace hanei
