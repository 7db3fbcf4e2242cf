/// The colour scale of every picture: the project's own, or fitted to the light while it has none.
#pragma once

#include "ui/view/view_options.h"

#include <optional>

namespace hanei {

class ProjectScale {
public:
    /// Before panels are drawn: the scale as the scene says. Without one the range is that of the first
    /// complete solution, or of the one last fitted to.
    void follow(ViewOptions& look, const Scene& scene, const Solution* solution);

    /// After panels were drawn: the scene with what they made of the scale, when they did.
    std::optional<Scene> wished(const Scene& scene, const ViewOptions& look) const;

    /// Fits to the solution: the scene with its own scale fitted; nothing when it has none, then the
    /// pictures follow by themselves.
    std::optional<Scene> fitted(const Scene& scene, const Solution& solution);

    void forget() { is_fitted_ = false; }  ///< another project

private:
    LuxRange range_;  ///< while the project has no scale
    bool is_fitted_ = false;
    ColourScale followed_;  ///< what the panels were given
};

/// Levels as a person writes them, "100, 300 500": in the unit, rising, each once.
/// Returns   nothing when a word is no figure above 0, or when there are more than a picture draws.
std::optional<std::vector<double>> levels_in(const std::string& text, IlluminanceUnit unit);
std::string levels_text(const std::vector<double>& lux, IlluminanceUnit unit);

}  // namespace hanei
