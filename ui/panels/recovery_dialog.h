/// Offers what a crash left behind.
#pragma once

#include "ui/panels/recovery_door.h"
#include "ui/panels/widget_registry.h"

namespace hanei {

class RecoveryDialog {
public:
    /// One piece of unsaved work, as it is offered.
    struct Offer {
        LostWork work;
        std::string name;     ///< of the project
        std::string differs;  ///< from the project's file
    };
    void open(std::vector<Offer> offers);
    bool is_open() const { return open_; }
    const std::vector<Offer>& offers() const { return offers_; }

    enum class Wish { none, recover, discard };
    struct Outcome {
        Wish wish = Wish::none;
        LostWork work;
    };
    /// Once a frame. What is recovered or discarded is offered no more.
    Outcome draw(WidgetRegistry& widgets);

private:
    void list(WidgetRegistry& widgets);

    std::vector<Offer> offers_;
    std::size_t chosen_ = 0;
    bool open_ = false, opening_ = false;
};

}  // namespace hanei
