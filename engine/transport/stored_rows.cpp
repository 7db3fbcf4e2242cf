#include "engine/transport/stored_rows.h"

#include "engine/base/check.h"
#include "engine/base/tiles.h"
#include "engine/transport/row_product.h"
#include "engine/transport/spare.h"
#include "engine/transport/spill_file.h"

#include <algorithm>
#include <atomic>
#include <mutex>

namespace hanei {

namespace {

/// What a thread needs to fill tiles.
struct Workplace {
    RowWriter write;
    std::vector<float> factors, shares;
    StoredTile tile;
};

}  // namespace

std::filesystem::path RowStorage::default_folder() {
    std::error_code none;
    const std::filesystem::path folder = std::filesystem::temp_directory_path(none);
    return none ? std::filesystem::path(".") : folder;
}

/// Fills tiles and finds each a place.
class StoredRows::Assembly {
public:
    Assembly(StoredRows& rows, const RowStorage& storage) : rows_(rows), storage_(storage) {}

    void fill(std::size_t number, Workplace& at) {
        const TileShape& shape = rows_.shape_;
        const std::size_t count = rows_.rows_of(number), first = number * TileShape::rows;
        at.factors.assign(count * shape.columns, 0.0F);
        at.shares.assign(count * shape.share_columns(), 1.0F);
        const bool hidden = at.write(first, first + count, at.factors.data(), at.shares.data());
        store_factors(shape, count, at.factors.data(), at.tile.factors);
        store_shares(shape, count, at.tile.factors, hidden ? at.shares.data() : nullptr, at.tile.shares);
        put(number, std::move(at.tile.factors), at.tile.shares);
    }

private:
    void put(std::size_t number, Lines factors, const Lines& shares) {
        Place& place = rows_.places_[number];
        place.share_bytes = shares.size();
        const std::size_t size = factors.size() + shares.size();
        place.on_disk = used_.fetch_add(size) + size > storage_.memory;
        if (!place.on_disk) {
            place.tile = {std::move(factors), shares};  // a copy is no longer than need be
            return;
        }
        used_ -= size;
        file().write(number * rows_.slot_bytes(), factors.all());
        file().write(number * rows_.slot_bytes() + factors.size(), shares.all());
    }

    SpillFile& file() {
        const std::scoped_lock lock(guard_);
        if (!rows_.file_) rows_.file_ = std::make_unique<SpillFile>(storage_.folder);
        return *rows_.file_;
    }

    StoredRows& rows_;
    const RowStorage& storage_;
    std::atomic<std::size_t> used_ = 0;
    std::mutex guard_;
};

StoredRows::StoredRows(const RowShape& shape, const RowStorage& storage)
    : rows_(shape.rows), shape_{storage.format, shape.columns, shape.columns_a_share} {
    HANEI_CHECK(shape.columns_a_share == 1 || shape.columns_a_share == 4);
    HANEI_CHECK(shape.columns % shape.columns_a_share == 0);
    places_.resize((rows_ + TileShape::rows - 1) / TileShape::rows);
}

StoredRows::StoredRows(StoredRows&&) noexcept = default;
StoredRows& StoredRows::operator=(StoredRows&&) noexcept = default;
StoredRows::~StoredRows() = default;

std::optional<StoredRows> StoredRows::make(const RowShape& shape, const RowStorage& storage,
                                           const std::function<RowWriter()>& maker, const Work& work) {
    StoredRows rows(shape, storage);
    Assembly assembly(rows, storage);
    Spare<Workplace> workplaces([&] { return Workplace{maker(), {}, {}, {}}; });
    const bool finished = for_each_tile(rows.places_.size(), 1, work, [&](std::size_t tile, std::size_t) {
        workplaces.with([&](Workplace& at) { assembly.fill(tile, at); });
    });
    if (!finished) return std::nullopt;
    return rows;
}

std::size_t StoredRows::rows_of(std::size_t tile) const {
    return std::min(TileShape::rows, rows_ - tile * TileShape::rows);
}

/// Each tile has its own part of the file, wide enough for all the shares it can ever have.
std::size_t StoredRows::slot_bytes() const { return shape_.factor_bytes() + shape_.most_share_bytes(); }

std::size_t StoredRows::bytes_in_memory() const {
    std::size_t bytes = 0;
    for (const Place& place : places_) bytes += place.tile.factors.size() + place.tile.shares.size();
    return bytes;
}

void StoredRows::read(std::size_t tile, StoredTile& into) const {
    into.factors.resize(shape_.factor_bytes());
    into.shares.resize(places_[tile].share_bytes);
    file_->read(tile * slot_bytes(), into.factors.all());
    file_->read(tile * slot_bytes() + into.factors.size(), into.shares.all());
}

bool StoredRows::multiply(std::span<const double> leaving, std::span<double> arriving, std::size_t sides,
                          const Work& work) const {
    HANEI_CHECK(leaving.size() == columns() * sides && arriving.size() == rows() * sides);
    if (sides == 0) return true;
    const Columns numbers(leaving, sides, columns(), shape_.format);
    Spare<StoredTile> buffers([] { return StoredTile{}; });
    const auto product = [&](std::size_t tile, const StoredTile& stored) {
        multiply_tile(shape_, rows_of(tile), stored.factors.all(), stored.shares.all(), numbers,
                      arriving.data() + tile * TileShape::rows * sides);
    };
    return for_each_tile(places_.size(), 1, work, [&](std::size_t tile, std::size_t) {
        if (!places_[tile].on_disk) return product(tile, places_[tile].tile);
        buffers.with([&](StoredTile& buffer) {
            read(tile, buffer);
            product(tile, buffer);
        });
    });
}

std::optional<std::vector<double>> StoredRows::row_sums(const Work& work) const {
    const std::vector<double> ones(columns(), 1.0);
    std::vector<double> sums(rows());
    if (!multiply(ones, sums, 1, work)) return std::nullopt;
    return sums;
}

bool StoredRows::rewrite_shares(const std::function<ShareWriter()>& maker, const Work& work) {
    struct Rewriter {
        ShareWriter writer;
        StoredTile from_disk;
        std::vector<float> shares;
    };
    Spare<Rewriter> spare([&] { return Rewriter{maker(), {}, {}}; });
    return for_each_tile(places_.size(), 1, work, [&](std::size_t tile, std::size_t) {
        spare.with([&](Rewriter& at) { rewrite_tile(tile, at.writer, at.from_disk, at.shares); });
    });
}

void StoredRows::rewrite_tile(std::size_t tile, const ShareWriter& writer, StoredTile& from_disk,
                              std::vector<float>& shares) {
    const std::size_t count = rows_of(tile), first = tile * TileShape::rows;
    Place& place = places_[tile];
    if (place.on_disk) read(tile, from_disk);
    StoredTile& stored = place.on_disk ? from_disk : place.tile;
    shares.resize(count * shape_.share_columns());
    recall_shares(shape_, count, stored.shares, shares.data());
    if (!writer(first, first + count, shares.data())) return;
    store_shares(shape_, count, stored.factors, shares.data(), stored.shares);
    place.share_bytes = stored.shares.size();
    if (place.on_disk) file_->write(tile * slot_bytes() + stored.factors.size(), stored.shares.all());
}

}  // namespace hanei
