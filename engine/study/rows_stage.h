/// Coefficients between surfaces and receivers, kept while bodies stand still and brought up to date
/// where one moved.
#pragma once

#include "engine/study/body_changes.h"
#include "engine/transport/nodes.h"
#include "engine/transport/stored_rows.h"

#include <memory>
#include <optional>
#include <span>

namespace hanei {

/// Between what rows are wanted, and how.
struct RowsInput {
    enum class Kind { paper, paper_closed, nodes };

    Kind kind = Kind::nodes;
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const Nodes> nodes;            ///< columns; of the paper's rows: those that tell what a point sees
    std::shared_ptr<const Mesh> seen;              ///< its patches have a visible share each: one a patch or one a node
    std::shared_ptr<const void> geometry;          ///< the same object as long as shapes and nodes are
    std::shared_ptr<const void> receivers_are;     ///< the same object as long as the receivers are
    std::span<const Receiver> receivers;           ///< one a row
    std::shared_ptr<const OccluderSet> occluders;  ///< null: everything is visible
    RowStorage storage;
};

class RowsStage {
public:
    /// Returns   null when stopped.
    const StoredRows* get(const RowsInput& input, const Work& work);

    const StoredRows* now() const { return rows_ ? &*rows_ : nullptr; }
    bool reused() const { return reused_; }                                  ///< the last get() worked nothing out
    const std::shared_ptr<const void>& version() const { return version_; }  ///< another object once a row changed

private:
    bool holds(const RowsInput& input) const;
    bool bring_up_to_date(const RowsInput& input, const Work& work);

    std::optional<RowsInput> input_;
    std::optional<StoredRows> rows_;
    std::shared_ptr<const void> version_;
    bool reused_ = false;
};

/// Rows made for once.
std::optional<StoredRows> make_rows(const RowsInput& input, const Work& work);

}  // namespace hanei
