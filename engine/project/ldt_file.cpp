#include "engine/project/ldt_file.h"

#include "engine/project/ldt_lines.h"
#include "engine/project/number_text.h"
#include "engine/project/photometric_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <utility>

namespace hanei {
namespace {

constexpr double metres_per_millimetre = 1e-3;
constexpr AllowedRange size_mm{0.0, 1e9, "a length from 0 in millimetres"};

struct LdtHeader {
    int isym = 0;
    int planes = 0;  ///< Mc, in the full circle
    int verticals = 0;
    double conversion = 1.0;
};

/// Lines 1 to 12.
LdtHeader read_layout(LdtLines& lines, Photometry& photometry, LuminaireFindings& findings) {
    constexpr double most_angles = 100'000.0;  // a thousandth of a degree apart; no instrument is finer
    constexpr AllowedRange count{1.0, most_angles, "a whole number from 1 to 100000"};
    LdtHeader header;
    lines.text("company");
    const int ityp = lines.whole("Ityp", {0.0, 9.0, "1, 2 or 3"});
    if (ityp < 1 || ityp > 3) findings.warn(lines.line(), "Ityp", fmt::format("{} found; known are 1, 2 and 3", ityp));
    header.isym = lines.whole("Isym", {0.0, 4.0, "0, 1, 2, 3 or 4"});
    header.planes = lines.whole("Mc", count);
    const int parts = header.isym == 2 ? 2 : header.isym >= 3 ? 4 : 1;
    if (header.planes % parts != 0) {
        findings.fault(lines.line(), "Mc",
                       fmt::format("{} planes cannot have the symmetry Isym {}; a multiple of {} is needed",
                                   header.planes, header.isym, parts));
    }
    lines.number("Dc");
    header.verticals = lines.whole("Ng", {2.0, most_angles, "a whole number from 2 to 100000"});
    lines.number("Dg");
    lines.text("measurement report");
    photometry.name = utf8_text(lines.text("luminaire name"));
    lines.text("luminaire number");
    lines.text("file name");
    lines.text("date and user");
    return header;
}

/// Lines 13 to 21, in millimetres: the luminaire's own size is kept as text, the opening converted.
void read_opening(LdtLines& lines, Photometry& photometry, LuminaireFindings& findings) {
    for (const char* field : {"length", "width", "height"}) lines.number(field, size_mm);
    const double length = metres_per_millimetre * lines.number("luminous length", size_mm);
    const int line = lines.line();
    const double width = metres_per_millimetre * lines.number("luminous width", size_mm);
    std::array<double, 4> heights{};
    const char* const fields[] = {"luminous height C0", "luminous height C90", "luminous height C180",
                                  "luminous height C270"};
    for (std::size_t k = 0; k < heights.size(); ++k)
        heights[k] = metres_per_millimetre * lines.number(fields[k], size_mm);
    const double height = *std::max_element(heights.begin(), heights.end());
    if (length == 0.0 && width == 0.0) {
        photometry.opening = {OpeningShape::point, 0.0, 0.0, 0.0};
    } else if (width == 0.0) {
        photometry.opening = {height > 0.0 ? OpeningShape::vertical_cylinder : OpeningShape::circle, length, length,
                              height};
    } else {
        photometry.opening = {height > 0.0 ? OpeningShape::box : OpeningShape::rectangle, width, length, height};
    }
    const bool differ = std::any_of(heights.begin(), heights.end(), [&](double side) { return side != height; });
    if (differ && photometry.opening.shape != OpeningShape::point) photometry.opening.side_heights = heights;
    check_opening(photometry.opening, line, findings);
}

/// Lines 22 to 25.
void read_declared(LdtLines& lines, LdtHeader& header, Photometry& photometry, LuminaireFindings& findings) {
    photometry.declared_downward_share = lines.number("downward flux fraction") / 100.0;
    photometry.declared_output_ratio = lines.number("light output ratio") / 100.0;
    header.conversion = lines.number("conversion factor", {0.0, 1e6, "0 or more"});
    if (header.conversion == 0.0) {
        findings.warn(lines.line(), "conversion factor", "0 found; read as 1");
        header.conversion = 1.0;
    } else if (header.conversion != 1.0) {
        findings.warn(lines.line(), "conversion factor",
                      fmt::format("intensities are multiplied by {}; few programs do so", header.conversion));
    }
    lines.number("tilt at measurement");
}

/// Line 26 and the lamp sets. The flux that scales cd/klm is that of the first.
double read_lamps(LdtLines& lines, Photometry& photometry, LuminaireFindings& findings) {
    const int sets = lines.whole("number of lamp sets", {0.0, 1e6, "0 to what the file holds, 20 by the format"});
    const int line = lines.line();
    if (static_cast<std::size_t>(sets) * 6 > lines.left()) {
        findings.fault(lines.line(), "number of lamp sets",
                       fmt::format("{} found, {} lines are left", sets, lines.left()));
        return 0.0;
    }
    for (int k = 0; k < sets && !findings.failed(); ++k) {
        LampSet set;
        set.count = lines.number("number of lamps");
        set.type = utf8_text(lines.text("lamp type"));
        set.lumens = lines.number("flux", {0.0, 1e12, "0 or more lumens"});
        if (k == 0 && set.lumens == 0.0) findings.warn(lines.line(), "flux", "0 lm: the luminaire is dark");
        set.colour = utf8_text(lines.text("lamp colour"));
        set.rendering = utf8_text(lines.text("colour rendering group"));
        set.watts = lines.number("watts with gear");
        photometry.lamp_sets.push_back(std::move(set));
    }
    if (findings.failed()) return 0.0;
    if (sets == 0) {
        findings.warn(line, "number of lamp sets", "0: the flux is unknown; 1000 lm are taken");
        return 1000.0;
    }
    if (sets > 1)
        findings.warn(line, "number of lamp sets",
                      fmt::format("{} alternatives; the first is used until another is chosen", sets));
    const LampSet& first = photometry.lamp_sets.front();
    photometry.absolute = first.count < 0.0;
    photometry.lamps = static_cast<int>(std::clamp(std::abs(first.count), 0.0, 1e6));
    photometry.lamp_lumens = photometry.absolute ? 0.0 : first.lumens;
    photometry.input_watts = first.watts;
    return first.lumens;
}

/// Which of the planes of the full circle the file stores, by Isym: `count` from `first` on, over the
/// end of the list to its beginning.
struct StoredPlanes {
    int first = 0;
    int count = 1;
    PhotometricSymmetry symmetry = PhotometricSymmetry::rotational;
    double from_deg = 0.0, to_deg = 0.0;  ///< where they must begin and end; the same when they need not
};

StoredPlanes stored_planes(const LdtHeader& header) {
    const int n = header.planes;
    switch (header.isym) {
        case 0:
            return {0, n, n == 1 ? PhotometricSymmetry::rotational : PhotometricSymmetry::none};
        case 1:
            return {0, 1, PhotometricSymmetry::rotational};
        case 2:
            return {0, n / 2 + 1, PhotometricSymmetry::plane_0, 0.0, 180.0};
        case 3:
            return {3 * n / 4, n / 2 + 1, PhotometricSymmetry::plane_90, -90.0, 90.0};
        default:
            return {0, n / 4 + 1, PhotometricSymmetry::quadrant, 0.0, 90.0};
    }
}

void select_planes(const LdtHeader& header, const StoredPlanes& stored, const std::vector<double>& circle, int line,
                   Photometry& photometry, LuminaireFindings& findings) {
    for (int k = 0; k < stored.count; ++k) {
        const int place = stored.first + k;
        const double turned = header.isym == 3 && place < header.planes ? 360.0 : 0.0;
        photometry.horizontal_deg.push_back(circle[static_cast<std::size_t>(place % header.planes)] - turned);
    }
    photometry.symmetry = stored.symmetry;
    if (stored.from_deg == stored.to_deg) return;
    constexpr double same_angle = 1e-3;  // degrees: 89.999 stands for 90
    const double first = photometry.horizontal_deg.front();
    const double last = photometry.horizontal_deg.back();
    if (std::abs(first - stored.from_deg) > same_angle || std::abs(last - stored.to_deg) > same_angle) {
        findings.fault(line, "C angle",
                       fmt::format("with Isym {} the stored planes must run from {} to {}, not from {} to {}",
                                   header.isym, stored.from_deg, stored.to_deg, first, last));
    }
}

void read_table(LdtLines& lines, const LdtHeader& header, double flux, Photometry& photometry,
                LuminaireFindings& findings) {
    lines.numbers(10, "direct ratio");
    const auto planes = static_cast<std::size_t>(header.planes);
    const std::vector<double> circle = lines.increasing(planes, "C angle", {-180.0, 360.0, "0 to 360 degrees"});
    const int circle_line = lines.line();
    const auto verticals = static_cast<std::size_t>(header.verticals);
    photometry.vertical_deg = lines.increasing(verticals, "gamma angle", {0.0, 180.0, "0 to 180 degrees"});
    if (findings.failed()) return;
    const StoredPlanes stored = stored_planes(header);
    select_planes(header, stored, circle, circle_line, photometry, findings);
    if (header.isym == 0) {
        if (planes == 1) findings.warn(circle_line, "Isym", "0 with one plane; read as rotational");
        const auto symmetry = symmetry_of(PhotometricType::C, photometry.horizontal_deg, circle_line, findings);
        if (symmetry) photometry.symmetry = *symmetry;
    }
    const int line = lines.line() + 1;
    std::vector<double> figures = lines.numbers(static_cast<std::size_t>(stored.count) * verticals, "intensity");
    set_candela(photometry, std::move(figures), header.conversion * flux / 1000.0, line, findings);
    if (findings.failed()) return;
    if (const int rest = lines.first_line_with_text(); rest > 0) {
        findings.warn(rest, "end of data", "lines follow the last intensity and are not read");
    }
}

}  // namespace

Photometry read_ldt(std::string_view text, LuminaireFindings& findings) {
    Photometry photometry;
    photometry.format = "EULUMDAT";
    LdtLines lines{text.substr(0, text.find('\x1A')), findings};
    LdtHeader header = read_layout(lines, photometry, findings);
    read_opening(lines, photometry, findings);
    read_declared(lines, header, photometry, findings);
    const double flux = read_lamps(lines, photometry, findings);
    photometry.keywords = lines.header();
    if (!findings.failed()) read_table(lines, header, flux, photometry, findings);
    return photometry;
}

bool looks_like_ldt(std::string_view text) {
    LineReader lines{text};
    lines.next();
    for (int k = 2; k <= 6; ++k) {
        if (!lines.next() || !decimal_number_with_comma(trimmed(lines.line()))) return false;
    }
    return true;
}

}  // namespace hanei
