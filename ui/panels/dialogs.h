/// Questions and notices in front of the window: one at a time.
#pragma once

#include "engine/base/diagnostic.h"
#include "ui/panels/widget_registry.h"

#include <functional>
#include <string>
#include <vector>

namespace hanei {

class Dialogs {
public:
    enum class Kind { none, unsaved, findings, choice, keys, about };

    /// Before changes are lost. `save` saves first and calls `proceed` itself when that worked.
    void ask_unsaved(std::string title, std::function<void()> save, std::function<void()> proceed);
    void show_findings(std::string title, Diagnostics findings);
    /// One of several: `chosen` gets its number. Never called when the user thinks better of it.
    void ask_choice(std::string title, std::string text, std::vector<std::string> entries,
                    std::function<void(std::size_t)> chosen);
    void show_keys() { show(Kind::keys); }
    void show_about() { show(Kind::about); }

    Kind kind() const { return kind_; }
    const Diagnostics& shown_findings() const { return findings_; }  ///< those shown last
    void draw(WidgetRegistry& widgets);

private:
    void show(Kind kind);
    void close();
    bool begin(const char* title, float width);
    void unsaved(WidgetRegistry& widgets);
    void findings(WidgetRegistry& widgets);
    void choice(WidgetRegistry& widgets);
    void keys(WidgetRegistry& widgets);
    void about(WidgetRegistry& widgets);

    Kind kind_ = Kind::none;
    bool opening_ = false;
    std::string title_, text_;
    Diagnostics findings_;
    std::vector<std::string> entries_;
    std::function<void(std::size_t)> chosen_;
    std::function<void()> save_, proceed_;
};

std::string_view name_of(Dialogs::Kind kind);

}  // namespace hanei
