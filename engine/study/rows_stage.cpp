#include "engine/study/rows_stage.h"

#include "engine/transport/closure.h"
#include "engine/transport/factor_rows.h"
#include "engine/transport/paper_rows.h"
#include "engine/transport/visible_shares.h"

#include <utility>

namespace hanei {

namespace {

/// Rows of nodes: analytic factors, visible parts.
class NodeRows {
public:
    explicit NodeRows(const RowsInput& input) : input_(input), factors_(*input.mesh, *input.nodes) {
        if (input.occluders) shares_.emplace(*input.seen, *input.occluders);
    }
    bool write(std::size_t first, std::size_t last, float* factors, float* shares) {
        const auto receivers = input_.receivers.subspan(first, last - first);
        factors_.write(receivers, factors);
        return shares_ && shares_->write(receivers, shares);
    }

private:
    const RowsInput& input_;
    FactorRows factors_;
    std::optional<VisibleShares> shares_;
};

/// The paper's rows, made to pass on what their point sees of the patches.
class ClosedRows {
public:
    explicit ClosedRows(const RowsInput& input)
        : paper_(*input.mesh, input.occluders.get()),
          seen_(input),
          columns_(input.mesh->vertices.size()),
          patches_(input.nodes->size()) {}

    bool write(std::size_t first, std::size_t last, float* factors, float* shares) {
        const bool hidden = paper_.write(first, last, factors, shares);
        seen_factors_.assign((last - first) * patches_, 0.0F);
        seen_shares_.assign((last - first) * patches_, 1.0F);
        seen_.write(first, last, seen_factors_.data(), seen_shares_.data());
        for (std::size_t row = 0; row < last - first; ++row) {
            const std::span seen_factors(seen_factors_.data() + row * patches_, patches_);
            const std::span seen_shares(seen_shares_.data() + row * patches_, patches_);
            close_row({factors + row * columns_, columns_}, {shares + row * columns_, columns_},
                      visible_sum(seen_factors, seen_shares));
        }
        return hidden;
    }

private:
    PaperRows paper_;
    NodeRows seen_;
    std::size_t columns_, patches_;
    std::vector<float> seen_factors_, seen_shares_;
};

template <class Writer>
RowWriter row_writer(std::shared_ptr<Writer> writer) {
    return [writer = std::move(writer)](std::size_t first, std::size_t last, float* factors, float* shares) {
        return writer->write(first, last, factors, shares);
    };
}

RowWriter row_writer_for(const RowsInput& input) {
    switch (input.kind) {
        case RowsInput::Kind::paper:
            return row_writer(std::make_shared<PaperRows>(*input.mesh, input.occluders.get()));
        case RowsInput::Kind::paper_closed:
            return row_writer(std::make_shared<ClosedRows>(input));
        case RowsInput::Kind::nodes:
            break;
    }
    return row_writer(std::make_shared<NodeRows>(input));
}

ShareWriter share_writer_for(const RowsInput& input, const OccluderSet& changed) {
    const auto shares = std::make_shared<VisibleShares>(*input.seen, *input.occluders);
    return [=, &input, &changed](std::size_t first, std::size_t last, float* rows) {
        return shares->rewrite(input.receivers.subspan(first, last - first), changed, rows);
    };
}

OccluderSet all_of(const OccluderSet& some, const OccluderSet& others) {
    std::vector<ConvexBody> bodies(some.bodies().begin(), some.bodies().end());
    bodies.insert(bodies.end(), others.bodies().begin(), others.bodies().end());
    return OccluderSet(std::move(bodies));
}

}  // namespace

std::optional<StoredRows> make_rows(const RowsInput& input, const Work& work) {
    const bool of_nodes = input.kind == RowsInput::Kind::nodes;
    const std::size_t columns = of_nodes ? input.nodes->size() : input.mesh->vertices.size();
    const RowShape shape{input.receivers.size(), columns,
                         of_nodes ? input.nodes->size() / input.seen->patches.size() : 1};
    return StoredRows::make(
        shape, input.storage, [&] { return row_writer_for(input); }, work);
}

/// Equal but for occluders.
bool RowsStage::holds(const RowsInput& input) const {
    return rows_ && input_->kind == input.kind && input_->geometry == input.geometry &&
           input_->receivers_are == input.receivers_are && input_->storage.format == input.storage.format &&
           input_->storage.memory == input.storage.memory;
}

bool RowsStage::bring_up_to_date(const RowsInput& input, const Work& work) {
    const BodyChanges changes = body_changes(*input_->occluders, *input.occluders);
    if (changes.most) {
        rows_ = make_rows(input, work);
        return rows_.has_value();
    }
    const OccluderSet changed = all_of(changes.gone, changes.come);
    return rows_->rewrite_shares([&] { return share_writer_for(input, changed); }, work);
}

const StoredRows* RowsStage::get(const RowsInput& input, const Work& work) {
    reused_ = holds(input) && input_->occluders == input.occluders;
    if (reused_) return &*rows_;
    version_ = std::make_shared<const int>();
    const bool same_shapes = holds(input) && input.kind == RowsInput::Kind::nodes;
    bool done = false;
    if (same_shapes && input_->occluders && input.occluders) {
        done = bring_up_to_date(input, work);
    } else {
        rows_ = make_rows(input, work);
        done = rows_.has_value();
    }
    if (!done) rows_.reset();
    input_ = input;
    input_->receivers = {};
    return rows_ ? &*rows_ : nullptr;
}

}  // namespace hanei
