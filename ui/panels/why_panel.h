/// "Why is it bright here": the light at one place, ranked by where it came from.
#pragma once

#include "engine/report/contributions_report.h"
#include "ui/panels/live_study.h"
#include "ui/panels/view_tool.h"

namespace hanei {

/// Of the chosen calculation point, or of the place asked about last.
class WhyPanel : public ViewOverlay {
public:
    void ask(const Vec3& position, const Vec3& normal, std::string name);
    void forget();  ///< another project

    /// Once a frame, before anything is drawn.
    void follow(const Scene& scene, ObjectId chosen, LiveStudy& study);

    /// The content of its tab. Returns what was clicked.
    std::optional<ObjectId> table(const Scene& scene, WidgetRegistry& widgets);

    /// The line from what the pointer is at in the table, or from the greatest contributor.
    void draw(const PaneSight& sight, WidgetRegistry& widgets) override;

    /// Null while there are none of the place.
    const std::shared_ptr<const Contributions>& contributions() const { return made_; }

private:
    struct Place {
        Vec3 position{0.0};
        Vec3 normal{0.0, 0.0, 1.0};
        std::string name;
        bool operator==(const Place&) const = default;
    };
    struct Table {
        const char* title;
        const char* help;
        std::vector<ContributionRow> rows;
    };
    void take(std::shared_ptr<const Contributions> made);
    std::optional<ObjectId> draw_table(const Table& table, int number, WidgetRegistry& widgets);

    std::optional<Place> asked_, place_;
    std::shared_ptr<const Contributions> made_;
    std::vector<Table> tables_;
    std::optional<ContributionRow> pointed_;  ///< in the table, last frame
    bool is_open_ = false;                    ///< the tab was drawn in the last frame
};

}  // namespace hanei
