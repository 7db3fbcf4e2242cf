/// The reference cases that come with the program, computed here and now: a table that is signed.
#pragma once

#include "engine/report/validation_report.h"
#include "ui/panels/background_work.h"
#include "ui/panels/widget_registry.h"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace hanei {

/// The program's own cases: each row is handed out from the calling thread as it is done.
/// Returns nothing when stopped. Throws when there are none.
using RunValidation =
    std::function<std::optional<Validation>(const Work&, const std::function<void(const ValidationRow&)>&)>;

/// Holds one run at a time on a thread of its own; rows are shown as they come.
class ValidationDialog {
public:
    /// As BackgroundWork.
    ValidationDialog(std::function<void()> wake, double patience);

    void open(RunValidation run);  ///< and begins at once
    bool is_open() const { return open_; }
    bool busy() const { return work_.busy(); }
    const std::optional<Validation>& validation() const { return validation_; }  ///< the last whole run
    std::size_t rows() const;                                                    ///< done so far

    void draw(WidgetRegistry& widgets);  ///< once a frame

private:
    struct Board {
        std::mutex guard;
        std::vector<ValidationRow> rows;
    };
    void begin();
    void headline(WidgetRegistry& widgets);
    void buttons(WidgetRegistry& widgets);
    void close();

    std::function<void()> wake_;
    RunValidation run_;
    std::shared_ptr<Board> board_ = std::make_shared<Board>();
    std::optional<Validation> validation_;
    std::string fault_;
    bool open_ = false, opening_ = false, was_stopped_ = false;
    BackgroundWork work_;
};

}  // namespace hanei
