#include "engine/base/check.h"
#include "engine/transport/balance.h"
#include "engine/transport/side_on_its_way.h"

#include <algorithm>
#include <list>

namespace hanei {

namespace {

// Who allows no more than these wants bounces, not the solution: the paper's figures have four.
constexpr int most_counted_bounces = 20;

// Light that surfaces of reflectance 1 lose by seeing others is lost within a few reflections, or the
// room is all but closed and nothing is gained by waiting.
constexpr int most_grown = 12;

using Columns = std::vector<std::span<const double>>;
using Products = std::vector<std::vector<double>>;

/// Products of several columns in one pass; empty when stopped.
std::optional<Products> exchanged(const Exchange& exchange, std::size_t unknowns, const Columns& columns,
                                  const Work& work) {
    if (work.stop.stop_requested()) return std::nullopt;
    const std::size_t sides = columns.size();
    std::vector<double> leaving(unknowns * sides), arriving(unknowns * sides);
    for (std::size_t s = 0; s < sides; ++s) {
        for (std::size_t k = 0; k < unknowns; ++k) leaving[k * sides + s] = columns[s][k];
    }
    if (!exchange(leaving, arriving, sides)) return std::nullopt;
    Products products(sides);
    for (std::size_t s = 0; s < sides; ++s) {
        products[s].reserve(unknowns);
        for (std::size_t k = 0; k < unknowns; ++k) products[s].push_back(arriving[k * sides + s]);
    }
    return products;
}

double greatest(std::span<const double> values) {
    double found = 0.0;
    for (const double value : values) found = std::max(found, value);
    return found;
}

/// What sides of the same reflectance share.
struct Band {
    std::span<const double> reflectance;
    RowSums rows;
    std::optional<Comparison> comparison;
};

bool same(std::span<const double> a, std::span<const double> b) {
    return a.data() == b.data() || std::equal(a.begin(), a.end(), b.begin(), b.end());
}

/// The sides of one balance, and how often the rows were read for them.
class Sides {
public:
    Sides(const Exchange& exchange, std::size_t unknowns, std::span<const LightSide> sides, const BalanceLimits& limits)
        : exchange_(exchange), unknowns_(unknowns), sides_(sides), limits_(limits) {
        for (const LightSide& side : sides) {
            const auto known = std::find_if(bands_.begin(), bands_.end(),
                                            [&](const Band& band) { return same(band.reflectance, side.reflectance); });
            band_of_.push_back(known != bands_.end() ? &*known : &bands_.emplace_back(Band{side.reflectance, {}, {}}));
        }
    }

    /// The first product: row sums, and the light of every side that has any.
    bool begin(const Work& work);

    /// One product more for the sides that are not done. False when stopped.
    bool go_on(const Work& work);

    bool ended() const {
        return std::all_of(on_their_way_.begin(), on_their_way_.end(), [](const auto& side) { return side->ended(); });
    }

    std::vector<Balance> states() const {
        std::vector<Balance> states;
        for (std::size_t s = 0; s < sides_.size(); ++s) {
            states.push_back(on_their_way_[s]->state());
            states.back().products = products_[s];
        }
        return states;
    }

private:
    bool solves() const { return limits_.bounces > most_counted_bounces; }

    /// Products until light is known to die out in every band, or there is no use; how many.
    std::optional<int> grow(const Work& work);

    std::unique_ptr<SideOnItsWay> start(const LightSide& side, const Band& band) const {
        if (solves() && band.comparison->dies_out())
            return std::make_unique<SideSolved>(side, band.rows, *band.comparison, limits_);
        return std::make_unique<SideInSeries>(side, band.rows, limits_);
    }

    const Exchange& exchange_;
    std::size_t unknowns_;
    std::span<const LightSide> sides_;
    BalanceLimits limits_;
    std::list<Band> bands_;  // places that stay
    std::vector<const Band*> band_of_;
    std::vector<std::unique_ptr<SideOnItsWay>> on_their_way_;
    std::vector<int> products_;
};

bool Sides::begin(const Work& work) {
    const std::vector<double> ones(unknowns_, 1.0);
    Columns columns = {ones};
    for (const Band& band : bands_) columns.push_back(band.reflectance);
    std::vector<std::vector<double>> sent;
    for (const LightSide& side : sides_) sent.push_back(first_sent_by(side));
    columns.insert(columns.end(), sent.begin(), sent.end());
    auto products = exchanged(exchange_, unknowns_, columns, work);
    if (!products) return false;
    auto product = products->begin();
    const std::vector<double> plain = std::move(*product++);
    for (Band& band : bands_) {
        band.rows = {plain, std::move(*product++), greatest(plain), 0.0};
        band.rows.greatest = greatest(band.rows.reflecting);
        band.comparison.emplace(band.reflectance, band.rows.plain, band.rows.reflecting);
    }
    const auto grown = grow(work);
    if (!grown) return false;
    for (std::size_t s = 0; s < sides_.size(); ++s, ++product) {
        on_their_way_.push_back(start(sides_[s], *band_of_[s]));
        SideOnItsWay& side = *on_their_way_.back();
        if (!side.ended() && same(side.leaving(), sent[s])) side.arrive(*product);
    }
    products_.assign(sides_.size(), 1 + *grown);
    return true;
}

std::optional<int> Sides::grow(const Work& work) {
    if (!solves()) return 0;
    for (int grown = 0;; ++grown) {
        Columns columns;
        for (const Band& band : bands_) {
            if (!band.comparison->growing().empty()) columns.push_back(band.comparison->growing());
        }
        if (columns.empty() || grown == most_grown) return grown;
        const auto products = exchanged(exchange_, unknowns_, columns, work);
        if (!products) return std::nullopt;
        auto product = products->begin();
        for (Band& band : bands_) {
            if (!band.comparison->growing().empty()) band.comparison->grow(*product++);
        }
    }
}

bool Sides::go_on(const Work& work) {
    Columns columns;
    for (const auto& side : on_their_way_) {
        if (!side->ended()) columns.push_back(side->leaving());
    }
    const auto products = exchanged(exchange_, unknowns_, columns, work);
    if (!products) return false;
    auto product = products->begin();
    for (std::size_t s = 0; s < sides_.size(); ++s) {
        if (on_their_way_[s]->ended()) continue;
        on_their_way_[s]->arrive(*product++);
        ++products_[s];
    }
    return true;
}

}  // namespace

Exchange exchange_by(const DenseRows& factors, const Visibility* visibility, const Work& work) {
    return
        [&factors, visibility, work](std::span<const double> leaving, std::span<double> arriving, std::size_t sides) {
            return multiply(factors, visibility, leaving, arriving, sides, work);
        };
}

std::optional<std::vector<Balance>> balance(const Exchange& exchange, std::size_t unknowns,
                                            std::span<const LightSide> sides, const BalanceLimits& limits,
                                            const Work& work,
                                            const std::function<bool(std::span<const Balance>)>& on_bounce) {
    for (const LightSide& side : sides) {
        HANEI_CHECK(side.reflectance.size() == unknowns && side.direct.size() == unknowns);
        HANEI_CHECK(side.own_exitance.size() == unknowns);
        HANEI_CHECK(side.guess.empty() || side.guess.size() == unknowns);
        HANEI_CHECK(side.guess_arriving.empty() || side.guess_arriving.size() == side.guess.size());
    }
    if (sides.empty()) return std::vector<Balance>{};
    Sides all(exchange, unknowns, sides, limits);
    for (bool more = all.begin(work); more; more = all.go_on(work)) {
        const bool ended = all.ended();
        if (!ended && !on_bounce) continue;
        std::vector<Balance> states = all.states();
        if (on_bounce && !on_bounce(states)) return std::nullopt;
        if (ended) return states;
    }
    return std::nullopt;
}

}  // namespace hanei
