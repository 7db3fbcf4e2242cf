#include "engine/mesh/place_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hanei {

PlaceIndex::PlaceIndex(double same)
    : same_(std::max(same, std::numeric_limits<double>::min())), bucket_(64.0 * same_) {}

std::uint64_t PlaceIndex::key(double x, double y, double z) const {
    std::uint64_t mixed = 0;
    for (const double c : {x, y, z}) {
        const auto cell = static_cast<std::int64_t>(std::floor(c / bucket_));
        mixed = (mixed ^ static_cast<std::uint64_t>(cell)) * 0x9E3779B97F4A7C15ULL;
        mixed ^= mixed >> 29U;
    }
    return mixed;
}

std::uint32_t PlaceIndex::number_of(const Vec3& place) {
    std::uint64_t seen = key(place.x, place.y, place.z);
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 near =
            place + same_ * Vec3((corner & 1) ? 1.0 : -1.0, (corner & 2) ? 1.0 : -1.0, (corner & 4) ? 1.0 : -1.0);
        const std::uint64_t bucket = key(near.x, near.y, near.z);
        if (corner > 0 && bucket == seen) continue;  // nearly always all eight corners share a bucket
        seen = bucket;
        const auto [begin, end] = buckets_.equal_range(bucket);
        for (auto found = begin; found != end; ++found) {
            const Vec3 apart = glm::abs(places_[found->second] - place);
            if (std::max({apart.x, apart.y, apart.z}) <= same_) return found->second;
        }
    }
    const auto number = static_cast<std::uint32_t>(places_.size());
    places_.push_back(place);
    buckets_.emplace(key(place.x, place.y, place.z), number);
    return number;
}

}  // namespace hanei
