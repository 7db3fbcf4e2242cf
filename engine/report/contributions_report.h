/// Why it is as bright at a place as it is, as people and programs read it.
#pragma once

#include "engine/study/contributions.h"

#include <string>
#include <vector>

namespace hanei {

/// One line of a ranking.
struct ContributionRow {
    std::string name;  ///< "Panel 1", "Desk, top", "3 reflections"
    ObjectId object;   ///< what it is of; may be none
    double lux = 0.0;
    double direct = 0.0;         ///< of that straight from luminaires (groups)
    std::optional<Vec3> from{};  ///< where the light comes from
};

/// Ranked, the greatest first; reflections in their order. Faces of one piece of furniture that look the
/// same way are one row. Each adds up: luminaires to the direct light, groups to all of it, reflections
/// and surfaces to the interreflected light.
std::vector<ContributionRow> rows_by_luminaire(const Contributions& contributions);
std::vector<ContributionRow> rows_by_group(const Contributions& contributions);
std::vector<ContributionRow> rows_by_reflections(const Contributions& contributions);
std::vector<ContributionRow> rows_by_surface(const Contributions& contributions);

/// Tables of all four, with shares of the total.
std::string contributions_text(const Contributions& contributions);
std::string contributions_json(const Contributions& contributions);

}  // namespace hanei
