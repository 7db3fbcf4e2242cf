#include "engine/study/gather_stage.h"

#include <algorithm>

namespace hanei {

bool GatherStage::gather(const std::vector<std::shared_ptr<const SideLight>>& lights, const SourceOf& source_of,
                         const StoredRows& rows, const Work& work) {
    const std::size_t sides = 2 * lights.size();
    std::vector<double> leaving(rows.columns() * sides), arriving(rows.rows() * sides);
    for (std::size_t s = 0; s < lights.size(); ++s) {
        const Source source = source_of(*lights[s]);
        for (std::size_t j = 0; j < rows.columns(); ++j) {
            leaving[j * sides + 2 * s] = source.exitance[j];
            leaving[j * sides + 2 * s + 1] = source.half_width[j];
        }
    }
    if (!rows.multiply(leaving, arriving, sides, work)) return false;
    for (std::size_t s = 0; s < lights.size(); ++s) {
        Kept kept{lights[s], std::vector<double>(rows.rows()), std::vector<double>(rows.rows())};
        for (std::size_t k = 0; k < rows.rows(); ++k) {
            kept.interreflected[k] = arriving[k * sides + 2 * s];
            kept.iteration[k] = arriving[k * sides + 2 * s + 1];
        }
        kept_.insert_or_assign(lights[s].get(), std::move(kept));
    }
    return true;
}

std::optional<GatheredLight> GatherStage::get(const RowsInput& input, std::span<const MixPart> parts,
                                              const SourceOf& source_of, const Work& work) {
    const StoredRows* const rows = rows_.get(input, work);
    if (!rows) return std::nullopt;
    if (version_ != rows_.version()) kept_.clear();
    version_ = rows_.version();

    std::vector<std::shared_ptr<const SideLight>> anew;
    for (const MixPart& part : parts)
        if (!kept_.contains(part.light.get())) anew.push_back(part.light);
    reused_ = rows_.reused() && anew.empty();
    if (!anew.empty() && !gather(anew, source_of, *rows, work)) return std::nullopt;

    GatheredLight total;
    int bands = 1;
    for (const MixPart& part : parts) bands = std::max(bands, part.band + 1);
    total.interreflected.assign(rows->rows(), 0.0);
    total.iteration.assign(rows->rows(), 0.0);
    if (bands > 1) total.bands.assign(static_cast<std::size_t>(bands), total.interreflected);
    for (const MixPart& part : parts) {
        const Kept& kept = kept_.at(part.light.get());
        const double share = part.level * part.band_weight;
        for (std::size_t k = 0; k < rows->rows(); ++k) {
            total.interreflected[k] += share * kept.interreflected[k];
            total.iteration[k] += share * kept.iteration[k];
        }
        if (bands == 1) continue;
        std::vector<double>& band = total.bands[static_cast<std::size_t>(part.band)];
        for (std::size_t k = 0; k < rows->rows(); ++k) band[k] += part.level * kept.interreflected[k];
    }
    std::erase_if(kept_, [&](const auto& entry) { return entry.second.light.use_count() == 1; });
    return total;
}

}  // namespace hanei
