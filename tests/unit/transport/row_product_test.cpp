#include "engine/transport/row_product.h"

#include "engine/transport/row_kernel.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace hanei {
namespace {

/// A tile of 11 rows and 150 columns, its blocks dark, clear and veiled.
StoredTile random_tile(const TileShape& shape, std::size_t count) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0.0F, 1.0F);
    std::vector<float> factors(count * shape.columns), shares(count * shape.share_columns());
    for (float& factor : factors) factor = std::pow(10.0F, -5.0F * unit(random));
    for (std::size_t k = 0; k < shares.size(); ++k)
        shares[k] = k / 70 % 3 == 0 ? 1.0F : k / 70 % 3 == 1 ? 0.0F : unit(random);
    StoredTile tile;
    store_factors(shape, count, factors.data(), tile.factors);
    store_shares(shape, count, tile.factors, shares.data(), tile.shares);
    return tile;
}

#if defined(__x86_64__)
TEST(RowProduct, has_the_same_bits_on_machines_with_wide_vectors_and_without) {
    if (!__builtin_cpu_supports("avx2")) GTEST_SKIP();
    constexpr std::size_t count = 11, columns = 152;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0.0, 1000.0);
    for (const RowFormat format : {RowFormat::exact, RowFormat::compact}) {
        for (const std::size_t each : {1U, 4U}) {
            const TileShape shape{format, columns, each};
            const StoredTile tile = random_tile(shape, count);
            for (std::size_t sides = 1; sides <= row_kernel::most_sides; ++sides) {
                std::vector<double> leaving(columns * sides);
                for (double& number : leaving) number = unit(random);
                const Columns numbers(leaving, sides, columns, format);
                std::vector<double> plain(count * sides), wide(count * sides);
                row_kernel::Job job{format == RowFormat::exact,
                                    each,
                                    shape.blocks(),
                                    count,
                                    tile.factors.data(),
                                    tile.factors.data() + shape.factors_at(),
                                    tile.shares.data(),
                                    tile.shares.data() + shape.shares_at(),
                                    {},
                                    {},
                                    plain.data(),
                                    sides};
                for (std::size_t s = 0; s < sides; ++s) {
                    job.leaving[s] = numbers[s];
                    job.back[s] = numbers.back(s);
                }
                row_kernel::run_plain(job, sides);
                job.arriving = wide.data();
                row_kernel::run_wide(job, sides);
                EXPECT_EQ(plain, wide) << sides;
                EXPECT_GT(plain.front(), 0.0);
            }
        }
    }
}
#endif

TEST(RowProduct, of_compact_rows_holds_for_numbers_of_any_size) {
    const TileShape shape{RowFormat::compact, 152, 1};
    const StoredTile tile = random_tile(shape, 1);
    const auto product = [&](double number) {
        const std::vector<double> leaving(152, number);
        double arriving = 0.0;
        multiply_tile(shape, 1, tile.factors.all(), tile.shares.all(), Columns(leaving, 1, 152, shape.format),
                      &arriving);
        return arriving;
    };
    const double one = product(1.0);
    EXPECT_GT(one, 0.0);
    for (const int power : {-1000, -300, 300, 1000}) EXPECT_EQ(product(std::ldexp(1.0, power)), std::ldexp(one, power));
    EXPECT_EQ(product(0.0), 0.0);
    EXPECT_EQ(product(-1.0), -one);
}

}  // namespace
}  // namespace hanei
