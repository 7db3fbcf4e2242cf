#include "engine/edit/box_balance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hanei {

double parallel_form_factor(double length, double width, double distance) {
    if (!(length > 0.0) || !(width > 0.0)) return 0.0;
    if (!(distance > 0.0)) return 1.0;
    const double x = length / distance, y = width / distance;
    const double xx = 1.0 + x * x, yy = 1.0 + y * y;
    const double sum = 0.5 * std::log(xx * yy / (xx + yy - 1.0)) + x * std::sqrt(yy) * std::atan(x / std::sqrt(yy)) +
                       y * std::sqrt(xx) * std::atan(y / std::sqrt(xx)) - x * std::atan(x) - y * std::atan(y);
    return std::clamp(2.0 * sum / (std::numbers::pi * x * y), 0.0, 1.0);
}

BoxBalance::BoxBalance(double length, double width, std::vector<double> borders)
    : length_(length), width_(width), borders_(std::move(borders)) {}

double BoxBalance::band_area(std::size_t band) const {
    return 2.0 * (length_ + width_) * (borders_[band + 1] - borders_[band]);
}

double BoxBalance::through(double distance) const {
    return floor_area() * parallel_form_factor(length_, width_, std::abs(distance));
}

/// m2, area times form factor. Surfaces are numbered: floor, ceiling, bands from below. What passes one
/// cross-section and not the next has met the band between them.
double BoxBalance::exchange(std::size_t one, std::size_t other) const {
    if (one > other) std::swap(one, other);
    const double low = borders_.front(), high = borders_.back();
    const auto from_level = [&](double level, std::size_t band) {
        const double near = std::min(std::abs(level - borders_[band]), std::abs(level - borders_[band + 1]));
        const double far = std::max(std::abs(level - borders_[band]), std::abs(level - borders_[band + 1]));
        return through(near) - through(far);
    };
    if (other < 2) return one == other ? 0.0 : through(high - low);
    const std::size_t b = other - 2;
    if (one < 2) return from_level(one == 0 ? low : high, b);
    const std::size_t a = one - 2;
    if (a == b) return band_area(a) - 2.0 * (through(0.0) - through(borders_[a + 1] - borders_[a]));
    return from_level(borders_[b], a) - from_level(borders_[b + 1], a);
}

double BoxBalance::reflected_through(double height, const Direct& direct, const Reflectances& reflectances) const {
    constexpr double most = 0.99;  // what reflects all light never comes to rest
    const std::size_t count = bands() + 2;
    std::vector<double> area(count), reflectance(count), arriving(count);
    for (std::size_t k = 0; k < count; ++k) {
        area[k] = k < 2 ? floor_area() : band_area(k - 2);
        const double stated = k == 0 ? reflectances.floor : k == 1 ? reflectances.ceiling : reflectances.walls;
        reflectance[k] = std::clamp(stated, 0.0, most);
        arriving[k] = (k == 0 ? direct.floor : k == 1 ? direct.ceiling : direct.bands[k - 2]) / area[k];
    }
    std::vector<double> factors(count * count);
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t j = 0; j < count; ++j) factors[k * count + j] = exchange(k, j) / area[k];
    std::vector<double> exitance(count, 0.0);
    constexpr int rounds = 2000;
    constexpr double settled = 1e-9;
    for (int round = 0; round < rounds; ++round) {
        double change = 0.0, greatest = 0.0;
        for (std::size_t k = 0; k < count; ++k) {
            double lux = arriving[k];
            for (std::size_t j = 0; j < count; ++j) lux += factors[k * count + j] * exitance[j];
            const double next = reflectance[k] * lux;
            change = std::max(change, std::abs(next - exitance[k]));
            greatest = std::max(greatest, next);
            exitance[k] = next;
        }
        if (change <= settled * greatest) break;
    }
    double flux = exitance[1] * through(borders_.back() - height);
    for (std::size_t band = 0; band < bands(); ++band)
        if (borders_[band] >= height)
            flux += exitance[band + 2] * (through(borders_[band] - height) - through(borders_[band + 1] - height));
    return flux;
}

}  // namespace hanei
