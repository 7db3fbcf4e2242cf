/// The figures of a luminaire file in words, as `hanei photometry` prints them. Rows need an open form.
#pragma once

#include "engine/report/photometry_figures.h"
#include "engine/scene/scene.h"
#include "ui/panels/form.h"

#include <string>

namespace hanei {

/// As many candela and angles as there are, and finite: what every figure rests on.
bool hangs_together(const Photometry& photometry);

std::string candela_text(double value);       ///< "1475", "52.3", "0.41"
std::string lamp_text(const LampSet& lamps);  ///< "2 × T5 49 W, 8900 lm, 109 W"
std::string opening_text(const Photometry& photometry);

/// Name and file, above everything else. True when another file is wished in its place.
bool photometry_title(const Photometry& photometry, WidgetRegistry& widgets);

/// Luminous flux of a measured luminaire: as measured, or set. True when its output was changed.
bool flux_rows(Luminaire& luminaire, const Photometry& photometry, Form& form);

/// Figures, and remarks with their lines. `figures` are of this photometry.
void figure_rows(const Photometry& photometry, const PhotometryFigures& figures, Form& form);

/// What the file says about itself, to unfold.
void keyword_rows(const Photometry& photometry, Form& form);

}  // namespace hanei
