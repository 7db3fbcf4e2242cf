/// What a launch without a project begins with: a new room, a project, an example, work that was lost.
#pragma once

#include "ui/panels/widget_registry.h"

#include <filesystem>
#include <imgui.h>
#include <string>
#include <vector>

namespace hanei {

/// Stands over the start room, which is computed and shown meanwhile; whoever closes it goes on with that.
class StartPage {
public:
    enum class Wish { none, new_room, open, recover, project, example, gallery };
    struct Outcome {
        Wish wish = Wish::none;
        std::filesystem::path file{};  ///< of project and example; the folder of a gallery
    };

    /// Cost      a look at every file: wait for no sleeping disk with it, ask away from the frames.
    struct Row {
        Wish wish = Wish::none;
        std::filesystem::path file{};
        std::string name, note;
        bool possible = true;
    };
    static std::vector<Row> rows_of(const std::vector<std::filesystem::path>& files, Wish wish);

    void open(bool can_recover);
    /// For the folder of hard cases beside the examples, when there is one.
    static std::vector<Row> rows_of_gallery(const std::vector<std::filesystem::path>& examples);
    /// Projects or examples, as soon as they are looked at.
    void show(std::vector<Row> recent, std::vector<Row> examples);
    bool is_open() const { return open_ && !leaves_; }
    void leave() { leaves_ = open_; }  ///< with the next frame

    /// Once a frame. `at_start` is the preference to see it at every start.
    Outcome draw(bool& at_start, WidgetRegistry& widgets);

private:
    void column(std::size_t which, WidgetRegistry& widgets, Outcome& outcome);
    void row(std::size_t column, std::size_t k, WidgetRegistry& widgets, Outcome& outcome);
    void keys(Outcome& outcome);
    const Row* focus() const;

    std::vector<Row> columns_[2];  ///< to begin with, and what was there before
    std::size_t examples_from_ = 0;
    std::size_t column_ = 0, row_ = 0;
    bool moved_ = false;  ///< the focus, by a key: it scrolls into sight
    bool open_ = false, opening_ = false, leaves_ = false;
};

/// "2026-11-22 15:04", of the present time zone; empty when the file does not say.
std::string time_of_file(const std::filesystem::path& file);

/// "Computer room panels" of computer-room-panels.hanei.
std::string title_of_example(const std::filesystem::path& file);

/// The folder as the user knows it: "~/rooms".
std::string short_folder(const std::filesystem::path& file);

}  // namespace hanei
