#include "engine/transport/stored_tile.h"

#include "engine/base/check.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace hanei {

namespace {

constexpr std::size_t block = TileShape::block;

/// A positive number in 16 bits, five of them its exponent: a float's upper bits after multiplication
/// with a power of two that puts the row's greatest in the topmost binade but one.
class Codes {
public:
    explicit Codes(float greatest) : shift_(greatest > 0.0F ? top - std::ilogb(greatest) : 0) {}

    /// What the codes, read as floats (see row_product.cpp), are to be multiplied with.
    double scale() const { return std::ldexp(1.0, -shift_); }

    std::uint16_t of(float value) const {
        constexpr std::uint32_t dropped_bits = 12, smallest = 1U << 11U;
        const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(std::ldexp(double{value}, shift_)));
        const std::uint32_t even = (bits >> dropped_bits) & 1U;
        const std::uint32_t code = (bits + 0x7FFU + even) >> dropped_bits;
        if (code >= smallest) return static_cast<std::uint16_t>(code);
        return code > smallest / 2 ? smallest : 0;  // below 1e-9 of the row's greatest
    }

private:
    static constexpr int top = 30 - 127;
    int shift_;
};

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
        const std::span values(factors + row * shape.columns, shape.columns);
        float greatest = 0.0F;
        bool sound = true;
        for (const float value : values) {
            sound = sound && value >= 0.0F;
            greatest = std::max(greatest, value);
        }
        HANEI_CHECK(sound && std::isfinite(greatest));
        const double scale = encode(values, greatest, codes.data());
        std::memcpy(stored.data() + row * sizeof(double), &scale, sizeof scale);
        written.row(row, codes.data());
    }
}

/// True where some factor of the share's columns is stored as more than 0.
template <class Code>
void mark_used(const TileShape& shape, const Lines& factors, std::size_t number, std::array<bool, block>& used) {
    std::array<Code, block> codes;
    std::memcpy(codes.data(), factors.data() + shape.factors_at() + number * sizeof codes, sizeof codes);
    const std::size_t each = shape.columns_a_share;
    for (std::size_t k = 0; k < shape.shares_a_block(); ++k) {
        used[k] = std::any_of(&codes[k * each], &codes[k * each] + each, [](Code code) { return code != Code{}; });
    }
}

float share_code(float share, float /*kind*/) { return std::clamp(share, 0.0F, 1.0F); }
std::uint8_t share_code(float share, std::uint8_t /*kind*/) {
    return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(share, 0.0F, 1.0F)));
}
float share_of(float code) { return code; }
float share_of(std::uint8_t code) { return static_cast<float>(code) / 255.0F; }

template <class Factor, class Share>
void store_shares_as(const TileShape& shape, std::size_t count, const Lines& factors, const float* shares,
                     Lines& stored) {
    const Share whole = share_code(1.0F, Share{});
    const std::size_t each = shape.shares_a_block();
    stored.resize(shape.most_share_bytes());
    std::size_t end = shape.shares_at();
    for (std::size_t b = 0; b < shape.blocks(); ++b) {
        const std::size_t first = b * each, columns = std::min(each, shape.share_columns() - first);
        for (std::size_t row = 0; row < TileShape::rows; ++row) {
            const std::size_t number = b * TileShape::rows + row;
            std::array<bool, block> used{};
            std::array<Share, block> codes{};
            if (row < count) mark_used<Factor>(shape, factors, number, used);
            bool dark = true, clear = true;
            for (std::size_t k = 0; k < columns; ++k) {
                if (!used[k]) continue;
                codes[k] = shares ? share_code(shares[row * shape.share_columns() + first + k], Share{}) : whole;
                dark = dark && codes[k] == Share{};
                clear = clear && codes[k] == whole;
            }
            stored.data()[number] = static_cast<std::byte>(dark    ? BlockKind::dark
                                                           : clear ? BlockKind::clear
                                                                   : BlockKind::veiled);
            if (dark || clear) continue;
            std::memcpy(stored.data() + end, codes.data(), each * sizeof(Share));
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
        write_rows<float>(shape, count, factors, stored, [](std::span<const float> values, float, float* codes) {
            std::ranges::copy(values, codes);
            return 1.0;
        });
        return;
    }
    write_rows<std::uint16_t>(shape, count, factors, stored,
                              [](std::span<const float> values, float greatest, std::uint16_t* codes) {
                                  const Codes code(greatest);
                                  std::ranges::transform(values, codes, [&](float value) { return code.of(value); });
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
