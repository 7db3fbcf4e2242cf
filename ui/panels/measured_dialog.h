/// Our values beside those of a meter or another program.
#pragma once

#include "engine/report/measured_report.h"
#include "ui/panels/widget_registry.h"

#include <memory>
#include <vector>

namespace hanei {

/// A line a set, then every value, the furthest apart first.
class MeasuredDialog {
public:
    void open(std::shared_ptr<const MeasuredComparison> comparison);  ///< one without faults
    bool is_open() const { return open_; }
    const MeasuredComparison* comparison() const { return comparison_.get(); }

    void draw(WidgetRegistry& widgets);  ///< once a frame

private:
    void sets() const;
    void pairs() const;

    std::shared_ptr<const MeasuredComparison> comparison_;
    std::vector<std::size_t> order_;  ///< of the pairs
    bool open_ = false, opening_ = false;
};

}  // namespace hanei
