#include "ui/panels/project_scale.h"

#include "ui/view/isolux_labels.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace hanei {

void ProjectScale::follow(ViewOptions& look, const Scene& scene, const Solution* solution) {
    if (!is_fitted_ && solution != nullptr && solution->complete) {
        range_ = suggested_range(*solution);
        is_fitted_ = true;
    }
    ColourScale fitted;
    fitted.low = range_.low;
    fitted.high = range_.high;
    take_scale(look, scene.colour_scale.value_or(fitted));
    followed_ = scale_of(look);
}

std::optional<Scene> ProjectScale::wished(const Scene& scene, const ViewOptions& look) const {
    ColourScale shown = scale_of(look);
    if (shown == followed_) return std::nullopt;
    if (scene.colour_scale) shown.unknown = scene.colour_scale->unknown;
    Scene wished = scene;
    wished.colour_scale = std::move(shown);
    return wished;
}

std::optional<Scene> ProjectScale::fitted(const Scene& scene, const Solution& solution) {
    range_ = suggested_range(solution);
    is_fitted_ = true;
    if (!scene.colour_scale) return std::nullopt;
    Scene wished = scene;
    wished.colour_scale->low = range_.low;
    wished.colour_scale->high = range_.high;
    return wished;
}

std::optional<std::vector<double>> levels_in(const std::string& text, IlluminanceUnit unit) {
    constexpr std::size_t most_levels = 64;
    constexpr std::string_view between = " ,;\t";
    std::vector<double> levels;
    for (std::size_t at = text.find_first_not_of(between); at != std::string::npos;
         at = text.find_first_not_of(between, at)) {
        const std::size_t end = std::min(text.find_first_of(between, at), text.size());
        double level = 0.0;
        const auto [rest, fault] = std::from_chars(text.data() + at, text.data() + end, level);
        if (fault != std::errc() || rest != text.data() + end || !(level > 0.0) || !(level * lux_in(unit) <= 1e7))
            return std::nullopt;
        levels.push_back(level * lux_in(unit));
        at = end;
    }
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
    if (levels.size() > most_levels) return std::nullopt;
    return levels;
}

std::string levels_text(const std::vector<double>& lux, IlluminanceUnit unit) {
    std::string text;
    for (const double level : lux) {
        if (!text.empty()) text += "  ";
        text += lux_text(level, unit);
    }
    return text;
}

}  // namespace hanei
