/// Some rows of coefficients as they are kept: factors, and beside them the shares that are visible.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hanei {

/// How precisely coefficients are kept.
enum class RowFormat {
    exact,   ///< factors and shares as floats
    compact  ///< factors to 12 bits of their own size (error 1.2e-4 of it), shares in steps of 1/255
};

/// Columns are taken 64 at a time: a block of one row is wholly hidden, in full view, or has shares.
struct TileShape {
    static constexpr std::size_t rows = 16;
    static constexpr std::size_t block = 64;

    RowFormat format = RowFormat::exact;
    std::size_t columns = 0;
    std::size_t columns_a_share = 1;  ///< 1 or 4

    std::size_t blocks() const { return (columns + block - 1) / block; }
    std::size_t share_columns() const { return columns / columns_a_share; }
    std::size_t shares_a_block() const { return block / columns_a_share; }
    std::size_t factor_size() const { return format == RowFormat::exact ? sizeof(float) : sizeof(std::uint16_t); }
    std::size_t share_size() const { return format == RowFormat::exact ? sizeof(float) : 1; }
    std::size_t factors_at() const { return rows * sizeof(double); }
    std::size_t factor_bytes() const { return factors_at() + blocks() * rows * block * factor_size(); }
    std::size_t shares_at() const { return (blocks() * rows + 63) / 64 * 64; }
    std::size_t most_share_bytes() const { return shares_at() + blocks() * rows * shares_a_block() * share_size(); }
};

enum class BlockKind : std::uint8_t {
    dark,   ///< nothing arrives from it: no shares are kept
    clear,  ///< all of it is seen: no shares are kept
    veiled  ///< its shares follow those of the veiled block before it
};

/// Memory that begins at a cache line.
class Lines {
public:
    void resize(std::size_t bytes) { lines_.resize((bytes + sizeof(Line) - 1) / sizeof(Line)), bytes_ = bytes; }
    std::size_t size() const { return bytes_; }
    std::byte* data() { return lines_.empty() ? nullptr : lines_.front().bytes.data(); }
    const std::byte* data() const { return lines_.empty() ? nullptr : lines_.front().bytes.data(); }
    std::span<std::byte> all() { return {data(), bytes_}; }
    std::span<const std::byte> all() const { return {data(), bytes_}; }

private:
    struct alignas(64) Line {
        std::array<std::byte, 64> bytes{};
    };
    std::vector<Line> lines_;
    std::size_t bytes_ = 0;
};

/// Up to TileShape::rows rows.
///
///     factors   a scale a row (double), then block by block, row by row the block's codes
///     shares    a kind a block and row, in the same order, then the shares of veiled ones
///
/// Holds     codes that depend on the rows' values alone; a share is kept only where a factor is not 0.
struct StoredTile {
    Lines factors, shares;
};

/// Needs     `count` rows of factors, none negative, all finite.
void store_factors(const TileShape& shape, std::size_t count, const float* factors, Lines& stored);

/// Needs     the factors as stored, and shares 0 to 1; null when all are 1.
void store_shares(const TileShape& shape, std::size_t count, const Lines& factors, const float* shares, Lines& stored);

/// The shares as kept (0 where no factor is, or nothing arrives); `shares`: rows of share_columns().
void recall_shares(const TileShape& shape, std::size_t count, const Lines& stored, float* shares);

}  // namespace hanei
