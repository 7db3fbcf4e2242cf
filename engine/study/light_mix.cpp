#include "engine/study/light_mix.h"

namespace hanei {

namespace {

void add(std::vector<double>& sum, double share, const std::vector<double>& values) {
    if (sum.empty()) sum.assign(values.size(), 0.0);
    for (std::size_t k = 0; k < values.size(); ++k) sum[k] += share * values[k];
}

}  // namespace

std::vector<double> mixed(std::span<const MixPart> parts, LightField field) {
    std::vector<double> sum;
    for (const MixPart& part : parts) add(sum, part.level * part.band_weight, (*part.light).*field);
    return sum;
}

std::vector<double> mixed_band(std::span<const MixPart> parts, int band, LightField field) {
    std::vector<double> sum;
    for (const MixPart& part : parts)
        if (part.band == band) add(sum, part.level, (*part.light).*field);
    return sum;
}

}  // namespace hanei
