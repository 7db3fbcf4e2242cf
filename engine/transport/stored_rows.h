/// Coefficients of interreflection, row by row: factors times visible shares, in memory or on disk.
#pragma once

#include "engine/base/progress.h"
#include "engine/transport/stored_tile.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace hanei {

class SpillFile;

struct RowShape {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::size_t columns_a_share = 1;  ///< 1 or 4: neighbouring columns of one patch have one share
};

struct RowStorage {
    RowFormat format = RowFormat::exact;
    std::size_t memory = ~std::size_t{0};             ///< bytes; what does not fit goes to disk
    std::filesystem::path folder = default_folder();  ///< where

    static std::filesystem::path default_folder();
};

/// Writes rows [first, last) of factors (given zeroed) and of shares (given as ones, a share every
/// columns_a_share columns). Returns false when the shares were left as they are: nothing is hidden.
using RowWriter = std::function<bool(std::size_t first, std::size_t last, float* factors, float* shares)>;

/// Writes shares of rows [first, last) anew where they changed: `shares` are those kept (0 where the
/// factor is 0; to the steps of the format). Returns false when all are as they were.
using ShareWriter = std::function<bool(std::size_t first, std::size_t last, float* shares)>;

/// A matrix whose products are all that is asked of it.
///
/// Needs     factors >= 0 and finite, shares 0 to 1. Writers are made one a thread (by `maker`) and given
///           rows of any tile in any order.
/// Holds     every tile of 16 rows in memory until `memory` is spent, the others in a nameless file of
///           `folder`. The same products, to the bit, on any number of threads and wherever rows lie.
/// Returns   std::system_error with a sentence for the user when the disk is full or cannot be written.
/// Weak when compact: a product errs by up to 1.2e-4 of its sum, 2e-3 where shares are not 0 or 1.
/// Cost      exact 4 bytes a factor and 4 a share, compact 2 and 1; no share where all of 64 columns
///           are in full view or hidden. A product reads each byte once for up to four sides.
class StoredRows {
public:
    /// Empty when stopped.
    static std::optional<StoredRows> make(const RowShape& shape, const RowStorage& storage,
                                          const std::function<RowWriter()>& maker, const Work& work);
    StoredRows(StoredRows&&) noexcept;
    StoredRows& operator=(StoredRows&&) noexcept;
    ~StoredRows();

    std::size_t rows() const { return rows_; }
    std::size_t columns() const { return shape_.columns; }
    std::size_t bytes_in_memory() const;
    bool on_disk() const { return file_ != nullptr; }

    /// `leaving`: side s of column j at j * sides + s. `arriving`: side s of row i at i * sides + s.
    /// Returns   false when stopped.
    bool multiply(std::span<const double> leaving, std::span<double> arriving, std::size_t sides,
                  const Work& work) const;

    /// Sum of each row; empty when stopped.
    std::optional<std::vector<double>> row_sums(const Work& work) const;

    /// Shares written anew where they change, as if made so from the start.
    /// Returns   false when stopped: then some are new and some are not.
    bool rewrite_shares(const std::function<ShareWriter()>& maker, const Work& work);

private:
    struct Place {
        bool on_disk = false;
        std::size_t share_bytes = 0;
        StoredTile tile;  ///< empty on disk
    };
    class Assembly;

    StoredRows(const RowShape& shape, const RowStorage& storage);
    std::size_t rows_of(std::size_t tile) const;
    std::size_t slot_bytes() const;
    void read(std::size_t tile, StoredTile& into) const;
    void rewrite_tile(std::size_t tile, const ShareWriter& writer, StoredTile& from_disk, std::vector<float>& shares);

    std::size_t rows_ = 0;
    TileShape shape_;
    std::vector<Place> places_;
    std::unique_ptr<SpillFile> file_;
};

}  // namespace hanei
