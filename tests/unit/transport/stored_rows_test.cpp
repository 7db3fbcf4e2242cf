#include "engine/transport/stored_rows.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <gtest/gtest.h>
#include <random>
#include <sys/resource.h>
#include <system_error>

namespace hanei {
namespace {

/// Factors over six decades, some 0; shares mostly 1 or 0 by whole stretches, some between.
struct Matrix {
    RowShape shape;
    std::vector<float> factors, shares;

    Matrix(std::size_t rows, std::size_t columns, std::size_t columns_a_share, unsigned seed = 1)
        : shape{rows, columns, columns_a_share}, factors(rows * columns), shares(rows * columns / columns_a_share) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> unit(0.0F, 1.0F);
        for (float& factor : factors) factor = unit(random) < 0.2F ? 0.0F : std::pow(10.0F, -6.0F * unit(random));
        for (std::size_t k = 0; k < shares.size();) {
            const auto run = static_cast<std::size_t>(90.0F * unit(random)) + 1;
            const float kind = unit(random);
            for (std::size_t end = std::min(shares.size(), k + run); k < end; ++k) {
                shares[k] = kind < 0.4F ? 1.0F : kind < 0.7F ? 0.0F : unit(random);
            }
        }
    }
    std::size_t share_columns() const { return shape.columns / shape.columns_a_share; }
    double exact(std::size_t row, std::size_t column) const {
        return double{factors[row * shape.columns + column]} *
               double{shares[row * share_columns() + column / shape.columns_a_share]};
    }
    RowWriter writer() const {
        return [this](std::size_t first, std::size_t last, float* f, float* s) {
            std::copy(&factors[first * shape.columns], &factors[0] + last * shape.columns, f);
            std::copy(&shares[first * share_columns()], &shares[0] + last * share_columns(), s);
            return true;
        };
    }
    StoredRows stored(RowStorage storage, int threads = 2) const {
        return std::move(*StoredRows::make(shape, storage, [this] { return writer(); }, {threads}));
    }
};

std::vector<double> numbers(std::size_t count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.0, 100.0);
    std::vector<double> found(count);
    for (double& number : found) number = unit(random);
    return found;
}

std::vector<double> product(const StoredRows& rows, std::size_t sides, int threads = 2) {
    std::vector<double> arriving(rows.rows() * sides);
    EXPECT_TRUE(rows.multiply(numbers(rows.columns() * sides), arriving, sides, {threads}));
    return arriving;
}

/// Greatest error of a product, over the sum of its terms.
double error_of(const Matrix& matrix, const StoredRows& rows, std::size_t sides) {
    const std::vector<double> leaving = numbers(rows.columns() * sides), arriving = product(rows, sides);
    double worst = 0.0;
    for (std::size_t i = 0; i < rows.rows(); ++i) {
        for (std::size_t s = 0; s < sides; ++s) {
            double sum = 0.0;
            for (std::size_t j = 0; j < rows.columns(); ++j) sum += matrix.exact(i, j) * leaving[j * sides + s];
            worst = std::max(worst, std::abs(arriving[i * sides + s] - sum) / std::max(sum, 1e-300));
        }
    }
    return worst;
}

constexpr std::size_t nothing = 0;

TEST(StoredRows, exact_products_are_those_of_the_factors_and_shares_written) {
    for (const std::size_t each : {1U, 4U}) {
        const Matrix matrix(37, 300, each);
        const StoredRows rows = matrix.stored({});
        for (const std::size_t sides : {1U, 2U, 3U, 4U, 7U}) {
            EXPECT_LT(error_of(matrix, rows, sides), 1e-14);  // doubles summed in another order
        }
    }
}

TEST(StoredRows, compact_products_err_by_the_steps_of_factors_and_shares) {
    for (const std::size_t each : {1U, 4U}) {
        Matrix matrix(40, 1000, each);
        EXPECT_LT(error_of(matrix, matrix.stored({RowFormat::compact}), 3), 2e-3);  // half a step of 1/255
        std::ranges::fill(matrix.shares, 1.0F);
        EXPECT_LT(error_of(matrix, matrix.stored({RowFormat::compact}), 3), 1.3e-4);  // 2^-13
    }
}

TEST(StoredRows, compact_keeps_rows_of_tiny_and_of_huge_factors) {
    Matrix matrix(32, 64, 1);
    std::ranges::fill(matrix.shares, 1.0F);
    for (std::size_t k = 0; k < matrix.factors.size(); ++k) {
        const std::size_t row = k / 64;
        matrix.factors[k] = std::ldexp(1.0F + 0.01F * static_cast<float>(k % 64), static_cast<int>(row * 7) - 120);
    }
    EXPECT_LT(error_of(matrix, matrix.stored({RowFormat::compact}), 1), 1.3e-4);
}

TEST(StoredRows, a_row_of_nothing_gives_nothing) {
    Matrix matrix(20, 70, 1);
    std::ranges::fill(matrix.factors, 0.0F);
    for (const RowFormat format : {RowFormat::exact, RowFormat::compact}) {
        for (const double sum : product(matrix.stored({format}), 2)) EXPECT_EQ(sum, 0.0);
    }
}

TEST(StoredRows, the_same_bits_in_memory_and_on_disk_and_on_any_number_of_threads) {
    const Matrix matrix(100, 260, 4);
    for (const RowFormat format : {RowFormat::exact, RowFormat::compact}) {
        const StoredRows in_memory = matrix.stored({format}, 1);
        const StoredRows on_disk = matrix.stored({format, nothing}, 3);
        const StoredRows partly = matrix.stored({format, in_memory.bytes_in_memory() / 2});
        EXPECT_FALSE(in_memory.on_disk());
        EXPECT_TRUE(on_disk.on_disk() && partly.on_disk());
        EXPECT_EQ(on_disk.bytes_in_memory(), 0U);
        EXPECT_GT(partly.bytes_in_memory(), 0U);
        EXPECT_LE(partly.bytes_in_memory(), in_memory.bytes_in_memory() / 2);
        const std::vector<double> expected = product(in_memory, 3, 1);
        EXPECT_EQ(product(on_disk, 3, 7), expected);
        EXPECT_EQ(product(partly, 3, 2), expected);
    }
}

TEST(StoredRows, several_sides_give_the_bits_of_one_after_another) {
    const Matrix matrix(33, 200, 1);
    const StoredRows rows = matrix.stored({RowFormat::compact});
    const std::vector<double> leaving = numbers(200 * 5), together = product(rows, 5);
    for (std::size_t s = 0; s < 5; ++s) {
        std::vector<double> one(200), arriving(33);
        for (std::size_t j = 0; j < 200; ++j) one[j] = leaving[j * 5 + s];
        ASSERT_TRUE(rows.multiply(one, arriving, 1, {}));
        for (std::size_t i = 0; i < 33; ++i) EXPECT_EQ(arriving[i], together[i * 5 + s]);
    }
}

TEST(StoredRows, rows_in_full_view_or_in_the_dark_keep_no_shares) {
    Matrix matrix(64, 640, 1);
    std::ranges::fill(matrix.shares, 1.0F);
    const std::size_t clear = matrix.stored({}).bytes_in_memory();
    std::ranges::fill(matrix.shares, 0.0F);
    EXPECT_EQ(matrix.stored({}).bytes_in_memory(), clear);
    std::ranges::fill(matrix.shares, 0.5F);
    EXPECT_EQ(matrix.stored({}).bytes_in_memory(), clear + 64 * 640 * sizeof(float));
}

TEST(StoredRows, row_sums_are_products_with_ones) {
    const Matrix matrix(18, 100, 1);
    const std::vector<double> sums = *matrix.stored({}).row_sums({2});
    for (std::size_t i = 0; i < sums.size(); ++i) {
        double sum = 0.0;
        for (std::size_t j = 0; j < 100; ++j) sum += matrix.exact(i, j);
        EXPECT_NEAR(sums[i], sum, 1e-13 * sum);
    }
}

/// Another matrix of the same factors, its shares those of `matrix` but in some columns of some tiles.
struct Edit {
    Matrix after;

    explicit Edit(const Matrix& before) : after(before) {
        Matrix other(before.shape.rows, before.shape.columns, before.shape.columns_a_share, 2);
        for (std::size_t k = 0; k < after.shares.size(); ++k) {
            if (row_changes(k / after.share_columns()) && changes(k % after.share_columns())) {
                after.shares[k] = other.shares[k];
            }
        }
    }
    static bool row_changes(std::size_t row) { return row / TileShape::rows % 2 == 1; }
    static bool changes(std::size_t column) {
        return (column >= 3 && column < 20) || column == 64 || (column >= 90 && column < 140);
    }
    ShareWriter writer() const {
        return [this](std::size_t first, std::size_t last, float* shares) {
            if (!row_changes(first)) return false;
            for (std::size_t row = first; row < last; ++row) {
                for (std::size_t j = 0; j < after.share_columns(); ++j) {
                    const std::size_t at = (row - first) * after.share_columns() + j;
                    if (changes(j)) shares[at] = after.shares[row * after.share_columns() + j];
                }
            }
            return true;
        };
    }
};

TEST(StoredRows, shares_rewritten_give_the_bits_of_rows_made_from_the_start) {
    for (const std::size_t each : {1U, 4U}) {
        const Matrix before(75, 600, each);
        const Edit edit(before);
        for (const RowFormat format : {RowFormat::exact, RowFormat::compact}) {
            for (const std::size_t memory : {nothing, ~nothing}) {
                StoredRows rows = before.stored({format, memory});
                const StoredRows expected = edit.after.stored({format, memory});
                EXPECT_NE(product(rows, 2), product(expected, 2));
                ASSERT_TRUE(rows.rewrite_shares([&] { return edit.writer(); }, {2}));
                EXPECT_EQ(product(rows, 2), product(expected, 2));
                EXPECT_EQ(rows.bytes_in_memory(), expected.bytes_in_memory());
            }
        }
    }
}

TEST(StoredRows, a_folder_that_cannot_be_written_is_named) {
    const Matrix matrix(20, 100, 1);
    try {
        matrix.stored({RowFormat::exact, nothing, "/proc/no such folder"});
        FAIL() << "rows are nowhere";
    } catch (const std::system_error& error) {
        EXPECT_NE(std::string(error.what()).find("/proc/no such folder"), std::string::npos) << error.what();
    }
}

TEST(StoredRows, a_full_disk_ends_the_computation_with_a_sentence) {
    const Matrix matrix(200, 1000, 1);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{100'000, before.rlim_max};  // bytes a file may have: as if the disk were full
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    std::string message;
    try {
        matrix.stored({RowFormat::exact, nothing});
    } catch (const std::system_error& error) {
        message = error.what();
    }
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_NE(message.find("cannot be written in the folder"), std::string::npos) << message;
}

TEST(StoredRows, a_stopped_computation_returns_nothing) {
    const Matrix matrix(40, 100, 1);
    std::stop_source stop;
    stop.request_stop();
    const Work stopped{2, stop.get_token(), nullptr};
    EXPECT_FALSE(StoredRows::make(
        matrix.shape, {}, [&] { return matrix.writer(); }, stopped));
    const StoredRows rows = matrix.stored({});
    EXPECT_FALSE(rows.row_sums(stopped));
}

TEST(StoredRows, no_rows_and_no_columns_are_answered) {
    EXPECT_TRUE(product(Matrix(0, 10, 1).stored({}), 2).empty());
    for (const double sum : product(Matrix(5, 0, 1).stored({RowFormat::compact}), 1)) EXPECT_EQ(sum, 0.0);
}

}  // namespace
}  // namespace hanei
