#include "engine/project/photometric_sum.h"

#include "engine/scene/intensity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace hanei {
namespace {

constexpr double just_after = 1e-3;  // degrees: files give two decimals at most
constexpr std::size_t most_intensities = 4'000'000;

void keep_distinct(std::vector<double>& angles) {
    std::sort(angles.begin(), angles.end());
    const auto same = [](double a, double b) { return b - a < just_after / 2.0; };
    angles.erase(std::unique(angles.begin(), angles.end(), same), angles.end());
}

/// A table that ends with light left is dark from there on: the sum steps down.
bool ends_bright(const Photometry& part, std::size_t vertical) {
    for (std::size_t k = vertical; k < part.candela.size(); k += part.vertical_deg.size()) {
        if (part.candela[k] > 0.0) return true;
    }
    return false;
}

std::vector<double> verticals(std::span<const Photometry> parts) {
    std::vector<double> angles;
    double first = parts.front().vertical_deg.front();
    double last = parts.front().vertical_deg.back();
    for (const Photometry& part : parts) {
        angles.insert(angles.end(), part.vertical_deg.begin(), part.vertical_deg.end());
        first = std::min(first, part.vertical_deg.front());
        last = std::max(last, part.vertical_deg.back());
    }
    for (const Photometry& part : parts) {
        const double begin = part.vertical_deg.front();
        const double end = part.vertical_deg.back();
        if (begin > first && ends_bright(part, 0)) angles.push_back(begin - just_after);
        if (end < last && ends_bright(part, part.vertical_deg.size() - 1)) angles.push_back(end + just_after);
    }
    keep_distinct(angles);
    return angles;
}

/// The directions that a plane of the table stands for, all around.
void add_mirrored(const Photometry& part, std::vector<double>& planes) {
    const bool about_0 =
        part.symmetry == PhotometricSymmetry::plane_0 || part.symmetry == PhotometricSymmetry::quadrant;
    const bool about_90 =
        part.symmetry == PhotometricSymmetry::plane_90 || part.symmetry == PhotometricSymmetry::quadrant;
    const bool circle = part.type == PhotometricType::C;
    const auto add = [&](double plane) {
        planes.push_back(circle ? plane - 360.0 * std::floor(plane / 360.0) : plane);
    };
    for (const double plane : part.horizontal_deg) {
        add(plane);
        if (about_0) add(-plane);
        if (about_90) add(180.0 - plane);
        if (about_0 && about_90) add(180.0 + plane);
    }
}

std::vector<double> horizontals(std::span<const Photometry> parts, bool alike) {
    std::vector<double> planes;
    for (const Photometry& part : parts) {
        if (alike) {
            planes.insert(planes.end(), part.horizontal_deg.begin(), part.horizontal_deg.end());
        } else if (part.symmetry != PhotometricSymmetry::rotational) {
            add_mirrored(part, planes);
        }
    }
    keep_distinct(planes);
    if (!alike && parts.front().type == PhotometricType::C && planes.size() > 1 && planes.back() > 360.0 - just_after)
        planes.pop_back();
    return planes;
}

bool same_angles(std::span<const Photometry> parts) {
    return std::all_of(parts.begin(), parts.end(), [&](const Photometry& part) {
        return part.horizontal_deg == parts.front().horizontal_deg && part.vertical_deg == parts.front().vertical_deg;
    });
}

/// All parts have these angles: figures are added as they are.
void add_tables(std::span<const Photometry> parts, Photometry& sum) {
    for (const Photometry& part : parts.subspan(1)) {
        for (std::size_t k = 0; k < sum.candela.size(); ++k) sum.candela[k] += part.candela[k];
    }
}

/// Beside a pole, where the planes still lie apart: at the pole itself a direction has no plane.
Vec3 direction_of(PhotometricType type, PhotometricAngles angles) {
    constexpr double beside = 1e-7;  // degrees: a billionth of a table's step
    const auto keep = [](double angle, double from, double to) {
        return std::clamp(angle, from + beside, to - beside);
    };
    if (type == PhotometricType::C) angles.vertical_deg = keep(angles.vertical_deg, 0.0, 180.0);
    if (type == PhotometricType::A) angles.vertical_deg = keep(angles.vertical_deg, -90.0, 90.0);
    if (type == PhotometricType::B) angles.horizontal_deg = keep(angles.horizontal_deg, -90.0, 90.0);
    return photometric_direction(type, angles);
}

void resample(std::span<const Photometry> parts, Photometry& sum) {
    sum.candela.clear();
    sum.candela.reserve(sum.horizontal_deg.size() * sum.vertical_deg.size());
    for (const double plane : sum.horizontal_deg) {
        for (const double vertical : sum.vertical_deg) {
            const Vec3 direction = direction_of(sum.type, {plane, vertical});
            double total = 0.0;
            for (const Photometry& part : parts) total += intensity(part, direction).value;
            sum.candela.push_back(total);
        }
    }
}

}  // namespace

std::optional<Photometry> photometric_sum(std::span<const Photometry> parts) {
    if (parts.empty()) return std::nullopt;
    Photometry sum = parts.front();
    bool alike = true;
    for (const Photometry& part : parts.subspan(1)) {
        if (part.type != sum.type) return std::nullopt;
        alike = alike && part.symmetry == sum.symmetry &&
                (part.symmetry == PhotometricSymmetry::rotational ||
                 (std::abs(part.horizontal_deg.front() - sum.horizontal_deg.front()) < just_after &&
                  std::abs(part.horizontal_deg.back() - sum.horizontal_deg.back()) < just_after));
        sum.lamps += part.lamps;
        sum.lamp_lumens += part.lamp_lumens;
        sum.input_watts += part.input_watts;
        sum.absolute = sum.absolute || part.absolute;
    }
    if (sum.absolute) sum.lamp_lumens = 0.0;
    if (same_angles(parts) && alike) {
        add_tables(parts, sum);
        return sum;
    }
    const bool round = alike && sum.symmetry == PhotometricSymmetry::rotational;
    if (!round) sum.horizontal_deg = horizontals(parts, alike);
    if (!alike) sum.symmetry = PhotometricSymmetry::none;
    sum.vertical_deg = verticals(parts);
    if (sum.horizontal_deg.size() * sum.vertical_deg.size() > most_intensities) return std::nullopt;
    resample(parts, sum);
    return sum;
}

}  // namespace hanei
