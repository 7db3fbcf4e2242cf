#include "ui/panels/elided.h"
#include "ui/panels/language.h"
#include "ui/panels/panel_frame.h"
#include "ui/panels/results_panel.h"
#include "ui/panels/workbench.h"

#include <imgui.h>
#include <utility>

namespace hanei {
namespace {

constexpr float table_width = 600.0F, facts_width = 400.0F;  // that their words need, at scale 1

}  // namespace

void Workbench::bottom(const ScreenRect& area) {
    begin_panel("##bottom", area);
    movable_edge(Edge::top, area, preferences_.bottom_height, 90.0F, 460.0F);
    const SolutionSnapshot solution = study_.answer();  // results on the way have no values yet
    const bool measured = !how_.repeatable;
    if (begin_tabs("tables")) {
        if (begin_tab("Results", widgets_)) {
            const bool any = solution && (!solution->grids.empty() || !solution->points.empty());
            begin_wide("results", any ? table_width : 0.0F);
            if (!solution)
                quiet_words(tr("The first values are being computed."));
            else if (!any)
                quiet_words(tr("No calculation grid or point yet: Add > Calculation grid."));
            else if (const auto clicked = results_table(*solution, selection_.primary(), widgets_))
                selection_.choose(*clicked);
            end_wide();
            ImGui::EndTabItem();
        }
        readings_tabs();
        if (begin_tab("Effects", widgets_)) {
            begin_wide("effects", solution ? table_width : 0.0F);
            if (solution) {
                const EffectsPanel::Outcome wish =
                    readings_.effects.table(*solution, document_.settings(), measured, widgets_);
                if (wish.settings) document_.set_settings(*wish.settings);
                if (wish.clicked) selection_.choose(*wish.clicked);
                if (wish.starts) readings_.effects.start(document_.shown(), document_.settings());
            }
            end_wide();
            ImGui::EndTabItem();
        }
        if (begin_tab("Energy", widgets_)) {
            begin_wide("energy", solution ? facts_width : 0.0F);
            if (solution) energy_table(*solution, measured);
            end_wide();
            ImGui::EndTabItem();
        }
        const Diagnostics& checks = messages_panel_.checks_of(document_.shown(), study_.findings());
        const std::size_t found = checks.size() + messages_.entries().size();
        if (begin_tab("Messages", widgets_, found, std::exchange(opens_messages_, false))) {
            begin_wide("messages", table_width);
            if (const auto clicked = messages_panel_.draw(*document_.shown(), checks, messages_, measured, widgets_))
                selection_.choose(*clicked);
            end_wide();
            ImGui::EndTabItem();
        }
        end_tabs();
    }
    end_panel();
}

}  // namespace hanei
