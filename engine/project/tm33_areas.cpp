#include "engine/project/tm33_areas.h"

#include "engine/project/number_text.h"
#include "engine/project/xml_elements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <string>
#include <utility>

namespace hanei {
namespace {

using Face = Tm33Area::Face;

constexpr std::array<std::pair<const char*, Face>, 6> faces{{{"Top", Face::top},
                                                             {"Bottom", Face::bottom},
                                                             {"C0", Face::c0},
                                                             {"C90", Face::c90},
                                                             {"C180", Face::c180},
                                                             {"C270", Face::c270}}};

double number_of(std::string_view text, const pugi::xml_node& area, const char* name, LuminaireFindings& findings) {
    const pugi::xml_node element = area.child(name);
    if (!element) return 0.0;
    const std::string word = xml_text(element);
    const std::optional<double> value = decimal_number(word);
    if (!value)
        findings.fault(xml_line(text, element), name,
                       in_quotes(word) + " is no number; a plain decimal number is needed");
    return value.value_or(0.0);
}

bool is_level(Face face) { return face == Face::top || face == Face::bottom; }

/// From the least to the greatest of what is covered.
struct Span {
    double low = 0.0, high = 0.0;
    bool empty = true;
    void cover(double middle, double width) {
        const double from = middle - width / 2.0;
        low = empty ? from : std::min(low, from);
        high = empty ? from + width : std::max(high, from + width);
        empty = false;
    }
    double width() const { return high - low; }
};

}  // namespace

std::vector<Tm33Area> tm33_areas(std::string_view text, const pugi::xml_node& emitter, LuminaireFindings& findings) {
    std::vector<Tm33Area> areas;
    for (const auto& [name, face] : faces) {
        const std::string face_name = fmt::format("{}Face", name);
        const std::string area_name = fmt::format("{}Area", name);
        for (const pugi::xml_node& node :
             emitter.child("EmissionAreas").child(face_name.c_str()).children(area_name.c_str())) {
            if (findings.failed()) return areas;
            const auto number = [&](const char* field) { return number_of(text, node, field, findings); };
            const std::string round = xml_text(node.child("Circular"));
            areas.push_back({face, number("Length"), number("Width"), number("Height"), number("LengthOffset"),
                             number("WidthOffset"), round == "true" || round == "1"});
        }
    }
    return areas;
}

MeasuredOpeningSize tm33_opening(const std::vector<Tm33Area>& areas, bool length_along_90, int line,
                                 LuminaireFindings& findings) {
    const auto warn = [&](const char* message) { findings.warn(line, "EmissionAreas", message); };
    if (areas.empty()) return {};
    Span lengths, widths;
    std::array<double, 4> heights{};
    std::size_t level = 0, round = 0;
    for (const Tm33Area& area : areas) {
        if (area.length > 0.0 && area.face != Face::c90 && area.face != Face::c270)
            lengths.cover(area.length_offset, area.length);
        const double width = area.width > 0.0 || !area.round ? area.width : area.length;
        if (width > 0.0 && area.face != Face::c0 && area.face != Face::c180) widths.cover(area.width_offset, width);
        if (is_level(area.face)) {
            ++level;
            round += area.round ? 1 : 0;
        } else {
            double& height = heights[static_cast<std::size_t>(area.face) - static_cast<std::size_t>(Face::c0)];
            height = std::max(height, area.height);
        }
    }
    const double height = *std::max_element(heights.begin(), heights.end());
    if (lengths.empty || widths.empty) {
        warn("the areas leave the length or the width of the opening unknown; read as a point");
        return {};
    }
    if (level > 1) warn("several areas; the opening is the rectangle around them");
    if (level == 0) warn("areas on the sides alone; the opening is the box they stand around");
    const bool one_round = level == 1 && round == 1;
    MeasuredOpeningSize opening;
    opening.extent_0 = length_along_90 ? widths.width() : lengths.width();
    opening.extent_90 = length_along_90 ? lengths.width() : widths.width();
    opening.height = height;
    const bool equal = std::abs(opening.extent_0 - opening.extent_90) <= 1e-6;  // m: the files' own rounding
    if (one_round) {
        opening.shape = height > 0.0 ? OpeningShape::vertical_cylinder
                        : equal      ? OpeningShape::circle
                                     : OpeningShape::ellipse;
    } else {
        opening.shape = height > 0.0 ? OpeningShape::box : OpeningShape::rectangle;
    }
    if (std::any_of(heights.begin(), heights.end(), [&](double side) { return side != height; }))
        opening.side_heights = heights;
    return opening;
}

}  // namespace hanei
