/// Checks that luminaire files of every format have in common.
#pragma once

#include "engine/project/luminaire_findings.h"
#include "engine/scene/photometry.h"

#include <optional>
#include <vector>

namespace hanei {

/// The symmetry a list of horizontal angles stands for (LM-63: by its range). A circle that is not
/// closed is closed when the gap is a step, or a quarter at most (with a warning).
/// Returns   empty, with a fault at `line`, for a range that stands for none.
std::optional<PhotometricSymmetry> symmetry_of(PhotometricType type, const std::vector<double>& horizontal_deg,
                                               int line, LuminaireFindings& findings);

/// Figures to candela: times `factor`; negative ones become 0. Warns of them, of a table that is dark
/// and of planes 0 and 360 that differ; a figure above 1e15 cd is a fault.
void set_candela(Photometry& photometry, std::vector<double> figures, double factor, int line,
                 LuminaireFindings& findings);

/// Warns of an opening larger than any luminaire.
void check_opening(const MeasuredOpeningSize& opening, int line, LuminaireFindings& findings);

}  // namespace hanei
