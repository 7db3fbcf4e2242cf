#include "engine/project/ies_profile.h"

#include "engine/edit/intensity_of.h"
#include "engine/edit/luminaire_edits.h"
#include "engine/geometry/polygon.h"
#include "engine/scene/intensity.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace hanei {
namespace {

struct Grid {
    std::vector<double> vertical, horizontal;  ///< degrees
};

std::vector<double> steps(double last, double step) {
    std::vector<double> angles;
    for (int k = 0; k * step <= last; ++k) angles.push_back(k * step);
    return angles;
}

/// From 0 or 90 to 90 or 180, as the format wants it; dark where the table does not reach.
std::vector<double> usual_range(std::vector<double> vertical) {
    constexpr double edge = 0.01;
    if (vertical.front() != 0.0 && vertical.front() != 90.0) {
        if (vertical.front() > edge) vertical.insert(vertical.begin(), vertical.front() - edge);
        vertical.insert(vertical.begin(), 0.0);
    }
    const double last = vertical.back();
    if (last == 90.0 || last == 180.0) return vertical;
    const double end = last < 90.0 ? 90.0 : 180.0;
    if (last + edge < end) vertical.push_back(last + edge);
    vertical.push_back(end);
    return vertical;
}

/// The planes of the table and those that its symmetry makes of them, all around.
std::vector<double> full_circle(const Photometry& photometry) {
    using Symmetry = PhotometricSymmetry;
    std::set<double> angles{0.0, 360.0};
    const auto add = [&](double angle) {
        angles.insert(std::fmod(angle + 90.0 * photometry.quarter_turns + 720.0, 360.0));
    };
    const bool about_0 = photometry.symmetry == Symmetry::plane_0 || photometry.symmetry == Symmetry::quadrant;
    const bool about_90 = photometry.symmetry == Symmetry::plane_90 || photometry.symmetry == Symmetry::quadrant;
    for (const double angle : photometry.horizontal_deg) {
        add(angle);
        if (about_0) add(-angle);
        if (about_90) add(180.0 - angle);
        if (about_0 && about_90) add(180.0 + angle);
    }
    return {angles.begin(), angles.end()};
}

Grid sampled_all_around(double around) { return {steps(180.0, 1.0), steps(360.0, around)}; }

constexpr double of_tables = 2.5, of_smooth_curves = 5.0;  // degrees around the nadir

Grid grid_of(const Photometry& photometry) {
    using Symmetry = PhotometricSymmetry;
    if (photometry.type != PhotometricType::C) return sampled_all_around(of_tables);
    const std::vector<double>& planes = photometry.horizontal_deg;
    const std::vector<double> vertical = usual_range(photometry.vertical_deg);
    if (photometry.symmetry == Symmetry::rotational) return {vertical, {0.0}};
    const bool half = photometry.symmetry == Symmetry::plane_0 && planes.back() == 180.0;
    const bool quarter = photometry.symmetry == Symmetry::quadrant && planes.back() == 90.0;
    const bool usual = photometry.quarter_turns == 0 && planes.front() == 0.0 && (half || quarter);
    return {vertical, usual ? planes : full_circle(photometry)};
}

Grid grid_of(const Luminaire& luminaire) {
    constexpr double narrow = 50.0, down = -1.0 + 1e-12;
    if (const auto* const beam = std::get_if<CosinePower>(&luminaire.distribution))
        return {steps(90.0, beam->exponent > narrow ? 0.25 : 1.0), {0.0}};
    if (const auto* const flat = std::get_if<PolygonOpening>(&luminaire.opening))
        return unit_normal(flat->region.outline).z < down ? Grid{steps(90.0, 1.0), {0.0}}
                                                          : sampled_all_around(of_smooth_curves);
    if (std::holds_alternative<LineOpening>(luminaire.opening)) return sampled_all_around(of_smooth_curves);
    return {{0.0, 180.0}, {0.0}};
}

/// The format's three lengths, whose signs say the shape.
Vec3 width_length_height(const MeasuredOpeningSize& size) {
    const double length = size.extent_0, width = size.extent_90, height = size.height;
    switch (size.shape) {
        case OpeningShape::point:
            break;
        case OpeningShape::rectangle:
            return {width, length, 0.0};
        case OpeningShape::box:
            return {width, length, height};
        case OpeningShape::circle:
        case OpeningShape::ellipse:
            return {-width, -length, 0.0};
        case OpeningShape::vertical_cylinder:
            return {-width, -length, height};
        case OpeningShape::sphere:
        case OpeningShape::ellipsoid:
            return {-width, -length, -height};
        case OpeningShape::horizontal_cylinder:
            return {-width, length, -height};
        case OpeningShape::horizontal_cylinder_90:
            return {width, -length, -height};
        case OpeningShape::vertical_disc:
            return {-width, 0.0, -height};
    }
    return Vec3{0.0};
}

/// A level rectangle along the luminaire's own axes has a word; other polygons are points.
Vec3 width_length_height(const Region& region) {
    Vec3 low = region.outline[0], high = low;
    for (const Vec3& corner : region.outline) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    const Vec3 size = high - low;
    const double area = glm::length(vector_area(region));
    const bool rectangle = size.z == 0.0 && std::abs(area - size.x * size.y) <= 1e-9 * area;
    return rectangle ? Vec3{size.y, size.x, 0.0} : Vec3{0.0};
}

Vec3 dimensions(const Luminaire& luminaire, const Photometry* photometry) {
    if (const auto* const flat = std::get_if<PolygonOpening>(&luminaire.opening))
        return width_length_height(flat->region);
    const bool measured = photometry != nullptr && std::holds_alternative<MeasuredOpening>(luminaire.opening);
    return measured ? width_length_height(photometry->opening) : Vec3{0.0};
}

/// Without an exponent, which not every reader of the format knows.
std::string figure(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (decimals > 0) text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

void add_list(std::string& text, const std::vector<double>& values, int decimals) {
    constexpr std::size_t a_line = 10;
    for (std::size_t k = 0; k < values.size(); ++k)
        text += figure(values[k], decimals) + (k + 1 == values.size() || k % a_line == a_line - 1 ? '\n' : ' ');
}

}  // namespace

std::string ies_profile(const Scene& scene, const Luminaire& luminaire) {
    const Photometry* const photometry = photometry_of(scene, luminaire);
    const bool measured = photometry != nullptr && !photometry->candela.empty();
    const Grid grid = measured ? grid_of(*photometry) : grid_of(luminaire);
    const IntensityOf intensity_of(scene, luminaire);
    std::vector<std::vector<double>> planes;
    double peak = 0.0;
    for (const double horizontal : grid.horizontal) {
        std::vector<double>& plane = planes.emplace_back();
        for (const double vertical : grid.vertical) {
            const Vec3 there = photometric_direction(PhotometricType::C, {horizontal, vertical});
            plane.push_back(std::max(0.0, intensity_of(there)));
            peak = std::max(peak, plane.back());
        }
    }
    constexpr int of_lengths = 6, of_angles = 6, most = 15, digits = 7;
    const int of_candela =
        peak > 0.0 ? std::clamp(digits - static_cast<int>(std::floor(std::log10(peak))), 0, most) : 0;
    const Vec3 size = dimensions(luminaire, photometry);
    std::string text = "IESNA:LM-63-2002\n[TEST] none\n[TESTLAB] none\n[ISSUEDATE] none\n[MANUFAC] none\nTILT=NONE\n";
    text += fmt::format("1 -1 1 {} {} 1 2 {} {} {}\n", grid.vertical.size(), grid.horizontal.size(),
                        figure(size.x, of_lengths), figure(size.y, of_lengths), figure(size.z, of_lengths));
    text += fmt::format("1 1 {}\n", figure(measured ? std::max(0.0, photometry->input_watts) : 0.0, of_lengths));
    add_list(text, grid.vertical, of_angles);
    add_list(text, grid.horizontal, of_angles);
    for (const std::vector<double>& plane : planes) add_list(text, plane, of_candela);
    return text;
}

}  // namespace hanei
