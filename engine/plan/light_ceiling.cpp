#include "engine/plan/light_ceiling.h"

#include "engine/geometry/polygon.h"
#include "engine/plan/direct_ceiling.h"
#include "engine/plan/light_bounds.h"
#include "engine/scene/colour.h"
#include "engine/scene/dimmers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace hanei {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int reflections_of_all = 20;
constexpr int reflections_of_part = 8;  // of what is missing, which is small anyway
constexpr int steps_closer = 3;

double greatest_of(std::span<const double> values) {
    return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

/// lm that leave the faces by themselves.
double own_flux(std::span<const Face> faces) {
    double flux = 0.0;
    for (const Face& face : faces) flux += face.own_exitance.value * glm::length(vector_area(face.region));
    return flux;
}

}  // namespace

LeavingLight& LeavingLight::operator+=(const LeavingLight& other) {
    exitance.resize(std::max(exitance.size(), other.exitance.size()), 0.0);
    for (std::size_t k = 0; k < other.exitance.size(); ++k) exitance[k] += other.exitance[k];
    flux += other.flux;
    return *this;
}

std::vector<std::size_t> brightest_first(std::span<const double> exitance) {
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < exitance.size(); ++k)
        if (exitance[k] > 0.0) order.push_back(k);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return exitance[a] > exitance[b]; });
    return order;
}

void SeenCells::sort() {
    nearest_.resize(seen_.size());
    std::iota(nearest_.begin(), nearest_.end(), 0U);
    std::stable_sort(nearest_.begin(), nearest_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return seen_[a].kernel > seen_[b].kernel; });
}

double SeenCells::arriving(const LeavingLight& light, std::span<const std::size_t> brightest) const {
    double free = 1.0, by_hemisphere = 0.0;
    for (const std::size_t k : brightest) {
        const double share = std::min(free, seen_[k].factor);
        if (!(share > 0.0)) continue;
        by_hemisphere += share * light.exitance[k];
        free -= share;
        if (free <= 0.0) break;
    }
    double rest = light.flux, by_flux = 0.0;
    for (const std::uint32_t k : nearest_) {
        if (!(rest > 0.0) || by_flux >= by_hemisphere) break;
        const double shown = seen_[k].factor * light.exitance[k];
        if (!(shown > 0.0)) continue;
        const double needed = shown / seen_[k].kernel;  // 0 where they touch
        by_flux += needed > rest ? rest * seen_[k].kernel : shown;
        rest -= needed;
    }
    return std::min(by_hemisphere, by_flux);
}

LightCeiling::LightCeiling(const Scene& scene, std::span<const Face> faces)
    : cells_(ceiling_cells(scene, faces)), bands_(is_neutral(scene) ? 1 : colour_bands) {
    const std::size_t count = cells_.size();
    for (std::size_t k = 0; k < count; ++k) {
        seen_.emplace_back(cells_[k], cells_);
        if (cells_[k].is_flat()) seen_[k].hide(k);
    }
    direct_.assign(static_cast<std::size_t>(bands_), std::vector<double>(count, 0.0));
    off_white_ = direct_;
    double most_colour = 1.0;
    for (const Luminaire& luminaire : scene.luminaires) {
        const double output = dimming_of(scene, luminaire) * scene.maintenance_factor;
        if (!(output > 0.0)) continue;
        const DirectCeiling direct(scene, luminaire);
        const Vec3 colour = bands_ > 1 ? band_output(luminaire, scene) : Vec3{1.0};
        most_colour = std::max({most_colour, colour.x, colour.y, colour.z});
        for (std::size_t k = 0; k < count; ++k) {
            const double lux = output * direct.on(cells_[k]);
            for (int band = 0; band < bands_; ++band) {
                const auto b = static_cast<std::size_t>(band);
                if (colour[band] > 0.0) direct_[b][k] += colour[band] * lux;
                if (colour[band] != 1.0) off_white_[b][k] += std::abs(colour[band] - 1.0) * lux;
            }
        }
    }
    emitted_ = most_colour * light_bounds(scene, faces).flux;
    own_ = own_flux(faces);
    leaving_.exitance.assign(count, 0.0);
    for (int band = 0; band < bands_; ++band) {
        const auto b = static_cast<std::size_t>(band);
        const std::vector<double> reflectance = reflectances(band);
        LeavingLight start{std::vector<double>(count), own_ + greatest_of(reflectance) * emitted_};
        for (std::size_t k = 0; k < count; ++k) {
            start.exitance[k] = cells_[k].own_exitance;
            if (reflectance[k] > 0.0) start.exitance[k] += reflectance[k] * direct_[b][k];
        }
        const LeavingLight light = settled(start, reflectance, reflections_of_all);
        if (!std::isfinite(light.flux)) bounded_ = false;
        if (!bounded_) break;
        const double weight = bands_ > 1 ? luminance_weights[band] : 1.0;
        const auto order = brightest_first(light.exitance);
        std::vector<double>& total = illuminance_.emplace_back(direct_[b]);
        for (std::size_t k = 0; k < count; ++k) {
            leaving_.exitance[k] += weight * light.exitance[k];
            total[k] += seen_[k].arriving(light, order);
        }
        leaving_.flux += weight * light.flux;
    }
    if (!bounded_) leaving_ = unbounded();
}

LeavingLight LightCeiling::unbounded() const { return {std::vector<double>(cells_.size(), infinite), infinite}; }

std::vector<double> LightCeiling::reflectances(int band) const {
    std::vector<double> reflectance;
    for (const CeilingCell& cell : cells_)
        reflectance.push_back(bands_ > 1 ? cell.reflectance[band] : cell.photometric);
    return reflectance;
}

/// One reflection more.
LeavingLight LightCeiling::reflected(const LeavingLight& light, std::span<const double> reflectance) const {
    const auto order = brightest_first(light.exitance);
    LeavingLight next{std::vector<double>(cells_.size(), 0.0), greatest_of(reflectance) * light.flux};
    for (std::size_t k = 0; k < cells_.size(); ++k)
        if (reflectance[k] > 0.0) next.exitance[k] = reflectance[k] * seen_[k].arriving(light, order);
    return next;
}

/// What leaves when `start` does and is reflected on and on; infinite where there is no end. Reflection by
/// reflection first: of what comes after the last no place receives more than its brightest, over and over.
/// That is above the balance, and every step of the balance itself from there is closer and still above.
LeavingLight LightCeiling::settled(const LeavingLight& start, std::span<const double> reflectance,
                                   int reflections) const {
    const double brightest = greatest_of(start.exitance), greatest = greatest_of(reflectance);
    if (!(brightest > 0.0)) return start;
    if (greatest >= 1.0 || !std::isfinite(brightest) || !std::isfinite(start.flux)) return unbounded();
    LeavingLight leaving = start, last = start;
    for (int n = 0; n < reflections; ++n) {
        last = reflected(last, reflectance);
        leaving += last;
    }
    const double after = greatest_of(last.exitance) / (1.0 - greatest);
    for (std::size_t k = 0; k < cells_.size(); ++k) leaving.exitance[k] += reflectance[k] * after;
    leaving.flux = start.flux / (1.0 - greatest);
    for (int step = 0; step < steps_closer; ++step) {
        const LeavingLight next = reflected(leaving, reflectance);
        for (std::size_t k = 0; k < cells_.size(); ++k)
            leaving.exitance[k] = std::min(leaving.exitance[k], start.exitance[k] + next.exitance[k]);
    }
    return leaving;
}

LeavingLight LightCeiling::without_reflection_of(ObjectId piece) const {
    if (!bounded_) return unbounded();
    const std::size_t count = cells_.size();
    LeavingLight missing{std::vector<double>(count, 0.0), 0.0};
    for (int band = 0; band < bands_; ++band) {
        const std::vector<double> reflectance = reflectances(band);
        LeavingLight start{std::vector<double>(count, 0.0), 0.0};
        std::vector<double> others = reflectance;
        for (std::size_t k = 0; k < count; ++k) {
            if (cells_[k].object != piece) continue;
            start.exitance[k] = reflectance[k] * illuminance_[static_cast<std::size_t>(band)][k];
            start.flux += start.exitance[k] * cells_[k].surface;
            others[k] = 0.0;  // all that leaves the piece is counted
        }
        LeavingLight light = settled(start, others, reflections_of_part);
        const double weight = bands_ > 1 ? luminance_weights[band] : 1.0;
        for (double& exitance : light.exitance) exitance *= weight;
        light.flux *= weight;
        missing += light;
    }
    return missing;
}

/// With E_1 the illuminance in one band, E_b in three, rho the photometric reflectance (the bands' mean by
/// luminance) and D_b = rho_b E_b - rho E_1, the bands' means of the first terms of
///     D_b = rho_b (E_b - E_1) + (rho_b - rho) E_1,   E_b - E_1 = (colour_b - 1) direct + F D_b
/// cancel, and the mean D = sum w_b D_b follows D = rho F D + sum w_b (rho_b - rho)(E_b - E_1).
LeavingLight LightCeiling::without_colour() const {
    const std::size_t count = cells_.size();
    if (!bounded_) return unbounded();
    LeavingLight start{std::vector<double>(count, 0.0), 0.0};
    if (bands_ == 1) return start;
    std::vector<double> photometric, in_one_band(count, 0.0);
    for (const CeilingCell& cell : cells_) photometric.push_back(cell.photometric);
    LeavingLight white{std::vector<double>(count), own_ + greatest_of(photometric) * emitted_};
    for (std::size_t k = 0; k < count; ++k) {
        for (int band = 0; band < bands_; ++band)
            in_one_band[k] += luminance_weights[band] * direct_[static_cast<std::size_t>(band)][k];
        white.exitance[k] = cells_[k].own_exitance + photometric[k] * in_one_band[k];
    }
    const LeavingLight grey = settled(white, photometric, reflections_of_all);
    const auto brightest = brightest_first(grey.exitance);
    for (std::size_t k = 0; k < count; ++k) in_one_band[k] += seen_[k].arriving(grey, brightest);
    for (int band = 0; band < bands_; ++band) {
        const auto b = static_cast<std::size_t>(band);
        const std::vector<double> reflectance = reflectances(band);
        LeavingLight first{std::vector<double>(count), 0.0};
        for (std::size_t k = 0; k < count; ++k) {
            first.exitance[k] = reflectance[k] * off_white_[b][k] + cells_[k].apart[band] * in_one_band[k];
            first.flux += first.exitance[k] * cells_[k].surface;
        }
        const LeavingLight off = settled(first, reflectance, reflections_of_all);
        const auto order = brightest_first(off.exitance);
        for (std::size_t k = 0; k < count; ++k) {
            const double received = off_white_[b][k] + seen_[k].arriving(off, order);
            const double more = luminance_weights[band] * cells_[k].apart[band] * received;
            start.exitance[k] += more;
            start.flux += more * cells_[k].surface;
        }
    }
    return settled(start, photometric, reflections_of_all);
}

double LightCeiling::arriving(std::size_t cell, const LeavingLight& light) const {
    return seen_[cell].arriving(light, brightest_first(light.exitance));
}

double MissingLight::at(const Vec3& position, const Vec3& normal) const {
    const SeenCells seen(Receiver{position, normal, Vec3{0.0}}, ceiling->cells());
    return seen.arriving(light, brightest_first(light.exitance));
}

double MissingLight::anywhere() const {
    double most = 0.0;
    for (std::size_t k = 0; k < light.exitance.size(); ++k) most = std::max(most, ceiling->arriving(k, light));
    return most;
}

}  // namespace hanei
