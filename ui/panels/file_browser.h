/// Choosing a file, in the window itself.
#pragma once

#include "ui/panels/widget_registry.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace hanei {

class FileBrowser {
public:
    struct Purpose {
        std::string title;                 ///< "Open a project"
        std::string action;                ///< "Open"
        std::vector<std::string> endings;  ///< shown files: ".hanei"; empty shows all
        bool writing = false;              ///< a name may be typed that does not exist yet
        std::filesystem::path folder;      ///< where to begin; empty: the working folder
        std::string name;                  ///< proposed
    };

    /// `done` is called with the chosen file, once; never when the user thinks better of it.
    void open(Purpose purpose, std::function<void(std::filesystem::path)> done);
    bool is_open() const { return open_; }

    /// Draws the dialog while it is open. Once a frame.
    void draw(WidgetRegistry& widgets);

private:
    struct Entry {
        std::string name;
        bool folder = false;
    };
    void enter(const std::filesystem::path& folder);
    void list(WidgetRegistry& widgets);
    void accept();
    std::filesystem::path chosen() const;

    Purpose purpose_;
    std::function<void(std::filesystem::path)> done_;
    std::filesystem::path folder_;
    std::vector<Entry> entries_;
    std::string fault_;
    bool open_ = false;
    bool just_opened_ = false;
};

}  // namespace hanei
