/// A tile of stored coefficients times columns of numbers.
#pragma once

#include "engine/transport/stored_tile.h"

#include <span>
#include <vector>

namespace hanei {

/// Columns of numbers, each begun at a cache line and filled up with zeros to whole blocks. For compact
/// rows, whose codes are read as very small numbers, they are multiplied with a power of two each, which
/// a product with `back` undoes: not a bit is lost.
class Columns {
public:
    /// `interleaved`: number s of row j at j * sides + s.
    Columns(std::span<const double> interleaved, std::size_t sides, std::size_t length, RowFormat format);
    std::size_t sides() const { return back_.size(); }
    const double* operator[](std::size_t side) const { return at_ + side * stride_; }
    double back(std::size_t side) const { return back_[side]; }

private:
    std::vector<double> back_;
    std::size_t stride_;
    Lines memory_;
    const double* at_;
};

/// For each of the tile's `count` rows and each side: the sum of factor times share times number.
///
/// Needs     the tile's factors and shares as stored for the shape.
/// Returns   `arriving`: number s of row k at k * sides + s. Sums are of doubles, in an order that is
///           the same on every machine.
/// Cost      bound by reading the coefficients for up to four sides.
void multiply_tile(const TileShape& shape, std::size_t count, std::span<const std::byte> factors,
                   std::span<const std::byte> shares, const Columns& leaving, double* arriving);

}  // namespace hanei
