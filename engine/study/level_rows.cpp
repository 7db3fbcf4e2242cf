#include "engine/study/level.h"

namespace hanei {

std::optional<StoredRows> Level::rows_to(std::span<const Receiver> receivers, const LevelInput& input,
                                         const Work& work) const {
    RowsInput rows = rows_between_surfaces(input);
    rows.kind = RowsInput::Kind::nodes;
    rows.receivers_are = nullptr;
    rows.receivers = receivers;
    rows.storage.format = RowFormat::exact;
    return make_rows(rows, work);
}

std::optional<std::vector<std::vector<double>>> Level::reflections(const MixPart& part, const LevelInput& input,
                                                                   std::size_t count, const Work& work) const {
    const std::vector<double> reflecting = reflectances(*input.scene, *input.plan, part.band);
    std::vector<double> leaving = part.of_surfaces ? own_exitances() : std::vector<double>(reflecting.size(), 0.0);
    for (std::size_t k = 0; k < leaving.size(); ++k) leaving[k] += reflecting[k] * part.light->direct[k];
    std::vector<std::vector<double>> all;
    std::vector<double> arriving(leaving.size());
    for (std::size_t n = 0; n < count; ++n) {
        all.push_back(node_values(leaving));
        if (n + 1 == count || !rows_.now()) break;
        if (!rows_.now()->multiply(leaving, arriving, 1, work)) return std::nullopt;
        for (std::size_t k = 0; k < leaving.size(); ++k) leaving[k] = part.light->gain * reflecting[k] * arriving[k];
    }
    return all;
}

}  // namespace hanei
