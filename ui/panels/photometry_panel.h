/// What the chosen luminaire is measured to shine: its curves, its figures, and what can be done to it.
#pragma once

#include "engine/edit/luminaire_edits.h"
#include "engine/report/photometry_figures.h"
#include "ui/panels/form.h"
#include "ui/panels/photometry_curves.h"

#include <optional>
#include <string>
#include <vector>

namespace hanei {

/// The panel reads the scene, draws itself, and returns what it would rather have. It keeps how the
/// curves are looked at, and the figures of the photometry it showed last.
class PhotometryPanel {
public:
    struct Outcome {
        std::optional<SceneEdit> edit;
        bool replaces_file = false;  ///< another file is wished for the luminaire
    };

    Outcome draw(const Scene& scene, ObjectId luminaire, Form& form);

    /// The changes reach every luminaire of the same photometry, not only the chosen one.
    bool reaches_all() const { return all_; }
    const std::string& readout() const { return readout_; }  ///< under the pointer; empty when it is elsewhere

private:
    void look_at(const Photometry& photometry);
    void plot(Form& form);
    void plane_choices(Form& form);
    void actions(const Scene& scene, const Luminaire& luminaire, const Photometry& photometry, Form& form,
                 Outcome& outcome);

    bool cartesian_ = false;
    bool per_kilolumen_ = false;
    bool all_ = true;
    double plane_ = 0.0, other_ = 90.0;  ///< degrees: solid and dashed
    std::string readout_;

    // Of the photometry shown last, in the file's own planes: without its quarter turns.
    Photometry shown_;
    PhotometryFigures figures_;
    std::vector<double> planes_;
    std::vector<CurvePoint> curve_, other_curve_;
    double curve_plane_ = -1.0, other_curve_plane_ = -1.0;
    double factor_ = 0.0;  ///< cd to cd/klm
};

}  // namespace hanei
