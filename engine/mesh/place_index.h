/// Numbers places so that two closer than a given distance get one number.
#pragma once

#include "engine/base/vector.h"

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace hanei {

/// Holds     the first place of every number: later ones within `same` on each axis are given its
///           number, whatever side of a bucket's border they lie on.
/// Cost      one or two look-ups a place.
class PlaceIndex {
public:
    explicit PlaceIndex(double same);

    std::uint32_t number_of(const Vec3& place);
    std::span<const Vec3> places() const { return places_; }

private:
    double same_;
    double bucket_;
    std::vector<Vec3> places_;
    std::unordered_multimap<std::uint64_t, std::uint32_t> buckets_;

    std::uint64_t key(double x, double y, double z) const;
};

}  // namespace hanei
