#include "engine/transport/stored_tile.h"

#include "engine/base/check.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace hanei {

namespace {

constexpr std::size_t block = TileShape::block;

constexpr int mantissa_bits = 23, dropped_bits = 12;

/// Positive numbers in 16 bits, five of them the exponent: a float's upper bits after multiplication
/// with a power of two that puts the row's greatest in the topmost binade but one (it may round up).
class Codes {
public:
    /// `greatest`: bits of the row's greatest. Rows of nothing above 1e-29 are not moved.
    explicit Codes(std::int32_t greatest) : shift_(std::max(0, (greatest >> mantissa_bits) - top)) {}

    /// What the codes, read as floats (see row_kernel.h), are to be multiplied with.
    double scale() const { return std::ldexp(1.0, shift_); }

    std::uint16_t of(float value) const {
        constexpr std::int32_t half = (1 << (dropped_bits - 1)) - 1;
        const std::int32_t bits = std::bit_cast<std::int32_t>(value) - (shift_ << mantissa_bits);
        const std::int32_t even = (bits >> dropped_bits) & 1;
        const std::int32_t code = (bits + half + even) >> dropped_bits;
        return static_cast<std::uint16_t>(bits < (1 << mantissa_bits) ? 0 : code);  // below 1e-9 of the greatest: 0
    }

private:
    static constexpr int top = 30;
    int shift_;
};

/// Bits of the greatest of numbers none of which may be negative, infinite or no number.
std::int32_t greatest_of(std::span<const float> values) {
    constexpr std::int32_t infinite = 0x7F800000, minus_zero = std::numeric_limits<std::int32_t>::min();
    std::int32_t greatest = 0, negative = 0;
    for (const float value : values) {
        const auto bits = std::bit_cast<std::int32_t>(value);
        const std::int32_t sound = bits == minus_zero ? 0 : bits;
        greatest = std::max(greatest, sound);
        negative |= sound;
    }
    HANEI_CHECK(negative >= 0 && greatest < infinite);
    return greatest;
}

template <class Code>
class Written {
public:
    Written(const TileShape& shape, std::byte* at) : shape_(shape), at_(at) {}
    void row(std::size_t row, const Code* codes) {
        for (std::size_t b = 0; b < shape_.blocks(); ++b) {
            const std::size_t first = b * block, count = std::min(block, shape_.columns - first);
            std::memcpy(at_ + (b * TileShape::rows + row) * block * sizeof(Code), codes + first, count * sizeof(Code));
        }
    }

private:
    const TileShape& shape_;
    std::byte* at_;
};

template <class Code, class Encode>
void write_rows(const TileShape& shape, std::size_t count, const float* factors, Lines& stored, Encode&& encode) {
    std::vector<Code> codes(shape.columns);
    Written<Code> written(shape, stored.data() + shape.factors_at());
    for (std::size_t row = 0; row < count; ++row) {
        const double scale = encode(std::span(factors + row * shape.columns, shape.columns), codes.data());
        std::memcpy(stored.data() + row * sizeof(double), &scale, sizeof scale);
        written.row(row, codes.data());
    }
}

float share_code(float share, float /*kind*/) { return std::min(std::max(share, 0.0F), 1.0F); }
std::uint8_t share_code(float share, std::uint8_t /*kind*/) {
    return static_cast<std::uint8_t>(static_cast<int>(255.0F * std::min(std::max(share, 0.0F), 1.0F) + 0.5F));
}
float share_of(float code) { return code; }
float share_of(std::uint8_t code) { return static_cast<float>(code) / 255.0F; }

/// One block of one row: what of it is seen.
template <class Factor, class Share>
class Block {
public:
    Block(const TileShape& shape, const std::byte* factors) : each_(shape.columns_a_share) {
        std::memcpy(factors_.data(), factors, sizeof factors_);
    }

    /// Its kind, and the codes of its shares where it is veiled.
    BlockKind of(const float* shares, std::size_t count) {
        Factor any{};
        for (const Factor factor : factors_) any = std::max(any, factor);
        if (any == Factor{}) return BlockKind::dark;
        if (!shares) return BlockKind::clear;
        std::uint32_t off_one = 0, off_zero = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const auto bits = std::bit_cast<std::uint32_t>(shares[k]);
            off_one |= bits ^ std::bit_cast<std::uint32_t>(1.0F);
            off_zero |= bits;
        }
        if (off_one == 0) return BlockKind::clear;
        return off_zero == 0 ? BlockKind::dark : mixed(shares, count);
    }
    const Share* codes() const { return codes_.data(); }

private:
    BlockKind mixed(const float* shares, std::size_t count) {
        const Share whole = share_code(1.0F, Share{});
        bool dark = true, clear = true;
        codes_ = {};
        for (std::size_t k = 0; k < count; ++k) {
            bool used = false;
            for (std::size_t j = k * each_; j < (k + 1) * each_; ++j) used |= factors_[j] != Factor{};
            const Share code = used ? share_code(shares[k], Share{}) : Share{};
            codes_[k] = code;
            dark &= code == Share{};
            clear &= !used || code == whole;
        }
        return dark ? BlockKind::dark : clear ? BlockKind::clear : BlockKind::veiled;
    }

    std::size_t each_;
    std::array<Factor, block> factors_;
    std::array<Share, block> codes_;
};

template <class Factor, class Share>
void store_shares_as(const TileShape& shape, std::size_t count, const Lines& factors, const float* shares,
                     Lines& stored) {
    const std::size_t each = shape.shares_a_block();
    stored.resize(shape.most_share_bytes());
    std::size_t end = shape.shares_at();
    for (std::size_t b = 0; b < shape.blocks(); ++b) {
        const std::size_t first = b * each, columns = std::min(each, shape.share_columns() - first);
        for (std::size_t row = 0; row < TileShape::rows; ++row) {
            const std::size_t number = b * TileShape::rows + row;
            std::byte& kind = stored.data()[number];
            kind = static_cast<std::byte>(BlockKind::dark);
            if (row >= count) continue;
            Block<Factor, Share> seen(shape, factors.data() + shape.factors_at() + number * block * sizeof(Factor));
            kind = static_cast<std::byte>(
                seen.of(shares ? shares + row * shape.share_columns() + first : nullptr, columns));
            if (kind != static_cast<std::byte>(BlockKind::veiled)) continue;
            std::memcpy(stored.data() + end, seen.codes(), each * sizeof(Share));
            end += each * sizeof(Share);
        }
    }
    stored.resize(end);
}

template <class Share>
void recall_shares_as(const TileShape& shape, std::size_t count, const Lines& stored, float* shares) {
    const std::size_t each = shape.shares_a_block();
    const std::byte* next = stored.data() + shape.shares_at();
    for (std::size_t b = 0; b < shape.blocks(); ++b) {
        const std::size_t first = b * each, columns = std::min(each, shape.share_columns() - first);
        for (std::size_t row = 0; row < count; ++row) {
            float* at = shares + row * shape.share_columns() + first;
            const auto kind = static_cast<BlockKind>(stored.data()[b * TileShape::rows + row]);
            std::fill_n(at, columns, kind == BlockKind::clear ? 1.0F : 0.0F);
            if (kind != BlockKind::veiled) continue;
            std::array<Share, block> codes;
            std::memcpy(codes.data(), next, each * sizeof(Share));
            for (std::size_t k = 0; k < columns; ++k) at[k] = share_of(codes[k]);
            next += each * sizeof(Share);
        }
    }
}

}  // namespace

void store_factors(const TileShape& shape, std::size_t count, const float* factors, Lines& stored) {
    stored = {};
    stored.resize(shape.factor_bytes());
    if (shape.format == RowFormat::exact) {
        write_rows<float>(shape, count, factors, stored, [](std::span<const float> values, float* codes) {
            greatest_of(values);
            std::ranges::copy(values, codes);
            return 1.0;
        });
        return;
    }
    write_rows<std::uint16_t>(shape, count, factors, stored, [](std::span<const float> values, std::uint16_t* codes) {
        const Codes code(greatest_of(values));
        for (std::size_t k = 0; k < values.size(); ++k) codes[k] = code.of(values[k]);
        return code.scale() / 255.0;
    });
}

void store_shares(const TileShape& shape, std::size_t count, const Lines& factors, const float* shares, Lines& stored) {
    if (shape.format == RowFormat::exact) {
        store_shares_as<float, float>(shape, count, factors, shares, stored);
    } else {
        store_shares_as<std::uint16_t, std::uint8_t>(shape, count, factors, shares, stored);
    }
}

void recall_shares(const TileShape& shape, std::size_t count, const Lines& stored, float* shares) {
    if (shape.format == RowFormat::exact) {
        recall_shares_as<float>(shape, count, stored, shares);
    } else {
        recall_shares_as<std::uint8_t>(shape, count, stored, shares);
    }
}

}  // namespace hanei
