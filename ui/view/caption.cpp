#include "ui/view/isolux_labels.h"
#include "ui/view/language.h"
#include "ui/view/legend.h"

#include <algorithm>
#include <fmt/format.h>

namespace hanei {
namespace {

std::string lux(double value) { return fmt::format("{:.2g} lx", value); }

/// The greatest error bar of what is reported, by its parts.
ErrorBar greatest_error(const Solution& solution) {
    ErrorBar greatest;
    const auto take = [&](const PointValue& value) {
        if (!value.inside_solid && value.error.total() > greatest.total()) greatest = value.error;
    };
    for (const PointResult& point : solution.points) take(point.value);
    for (const GridResult& grid : solution.grids) {
        for (const PointResult& point : grid.points) take(point.value);
    }
    return greatest;
}

bool reports_points(const Solution& solution) {
    return !solution.points.empty() || std::any_of(solution.grids.begin(), solution.grids.end(),
                                                   [](const GridResult& g) { return !g.points.empty(); });
}

std::string error_text(const Solution& solution) {
    std::string text = say("iteration ≤ {}", lux(solution.iteration_bound));
    if (reports_points(solution)) text += say(", points ± {} at most", lux(greatest_error(solution).total()));
    const double skipped = solution.plan.skipped_lux;
    if (skipped > 0.0) text += say(", left out ≤ {}", lux(skipped));
    return text;
}

}  // namespace

std::string heading_of(LightPart part) {
    switch (part) {
        case LightPart::total:
            return tr("Total illuminance");
        case LightPart::direct:
            return tr("Direct light only");
        case LightPart::interreflected:
            return tr("Interreflected light only");
        case LightPart::unshadowed:
            return tr("Total without shadows");
    }
    return "";
}

Caption caption_of(const Solution& solution, const ViewOptions& look) {
    Caption caption;
    const std::string title = solution.scene != nullptr ? solution.scene->title : std::string();
    const std::string kind = look.shadow_classes
                                 ? say("Shadow classes, {}", shadows_of_text(*solution.scene, look.shadows_of))
                             : look.scale == Scale::photo ? say("photo view, {}", tr(name_of(look.part)))
                             : look.difference            ? say("Difference: {}", heading_of(look.part))
                                                          : heading_of(look.part);
    caption.title = title.empty() ? kind : title + " – " + kind;
    if (look.shadow_outlines && !look.shadow_classes)
        caption.title += say(", shadows of {}", shadows_of_text(*solution.scene, look.shadows_of));
    const std::size_t patches = solution.mesh != nullptr ? solution.mesh->patches.size() : 0;
    caption.detail = say("Method {}, {} patches of {:.3g} m at most, {} interreflections{}. Error: {}.",
                         name_of(solution.settings.method), patches, solution.patch_width, solution.bounces,
                         solution.complete ? "" : tr(" so far"), error_text(solution));
    if (!solution.refusal.empty())
        caption.detail = say(
            "Method {}, {} patches of {:.3g} m at most. Direct light and its first reflection: interreflection has no "
            "end here.",
            name_of(solution.settings.method), patches, solution.patch_width);
    if (look.shadow_classes)
        caption.detail = say("{} patches of {:.3g} m at most. Lit, umbra and away are proved; partly lit is the rest.",
                             patches, solution.patch_width);
    if (look.shadow_outlines) caption.detail = std::string(outline_text()) + ". " + caption.detail;
    return caption;
}

}  // namespace hanei
