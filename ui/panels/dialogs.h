/// Questions and notices in front of the window: one at a time.
#pragma once

#include "engine/base/diagnostic.h"
#include "ui/panels/widget_registry.h"

#include <functional>
#include <string>

namespace hanei {

class Dialogs {
public:
    enum class Kind { none, unsaved, findings, keys, about };

    /// Before changes are lost. `save` saves first and calls `proceed` itself when that worked.
    void ask_unsaved(std::string title, std::function<void()> save, std::function<void()> proceed);
    void show_findings(std::string title, Diagnostics findings);
    void show_keys() { show(Kind::keys); }
    void show_about() { show(Kind::about); }

    Kind kind() const { return kind_; }
    void draw(WidgetRegistry& widgets);

private:
    void show(Kind kind);
    void close();
    bool begin(const char* title, float width);
    void unsaved(WidgetRegistry& widgets);
    void findings(WidgetRegistry& widgets);
    void keys(WidgetRegistry& widgets);
    void about(WidgetRegistry& widgets);

    Kind kind_ = Kind::none;
    bool opening_ = false;
    std::string title_;
    Diagnostics findings_;
    std::function<void()> save_, proceed_;
};

std::string_view name_of(Dialogs::Kind kind);

}  // namespace hanei
