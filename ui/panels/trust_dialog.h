/// The answer on screen, checked by what must hold of any right one.
#pragma once

#include "engine/report/trust_report.h"
#include "ui/panels/background_work.h"
#include "ui/panels/widget_registry.h"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace hanei {

/// Holds one run at a time on a thread of its own; checks are shown as they are done.
class TrustDialog {
public:
    /// As BackgroundWork.
    TrustDialog(std::function<void()> wake, double patience);

    void open(SceneSnapshot scene, const Settings& settings);  ///< and begins at once
    bool is_open() const { return open_; }
    bool busy() const { return work_.busy(); }
    const std::optional<TrustReport>& report() const { return report_; }  ///< of the last whole run
    int done() const;                                                     ///< checks of the present run

    void draw(WidgetRegistry& widgets);  ///< once a frame

private:
    struct Board {
        std::mutex guard;
        std::optional<TrustReport> report;
    };
    void begin();
    void headline(WidgetRegistry& widgets);
    void buttons(WidgetRegistry& widgets);
    void close();

    std::function<void()> wake_;
    SceneSnapshot scene_;
    Settings settings_;
    std::shared_ptr<Board> board_ = std::make_shared<Board>();
    std::optional<TrustReport> report_;
    std::string fault_;
    bool open_ = false, opening_ = false, was_stopped_ = false;
    BackgroundWork work_;
};

}  // namespace hanei
