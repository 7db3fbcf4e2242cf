#include "engine/direct/direct.h"
#include "engine/direct/obstacles.h"
#include "engine/direct/source.h"
#include "engine/geometry/visible_part.h"

#include <algorithm>
#include <array>
#include <limits>
#include <variant>

namespace hanei {

struct Emitter::Parts {
    ObjectId luminaire;
    LuminousFlux flux;
    Source source;
    std::vector<Vec3> extent;
    std::vector<LuminousPiece> pieces;
    std::vector<double> weights;  ///< a piece: what from_place multiplies by
};

namespace {

struct ExtentOf {
    std::vector<Vec3> operator()(const PointSource& source) const { return {source.position()}; }
    std::vector<Vec3> operator()(const LineSource& source) const { return {source.from, source.to}; }
    std::vector<Vec3> operator()(const DiffuseSource& source) const { return source.extent(); }
    std::vector<Vec3> operator()(const MeasuredSource& source) const { return source.extent(); }
};

struct PiecesOf {
    using Pieces = std::vector<LuminousPiece>;
    Pieces operator()(const PointSource& source) const {
        return source.is_dark() ? Pieces{} : Pieces{{{source.position()}, source.front()}};
    }
    Pieces operator()(const LineSource& source) const {
        return source.normal_intensity > 0.0 ? Pieces{{{source.from, source.to}, Vec3{0.0}}} : Pieces{};
    }
    Pieces operator()(const DiffuseSource& source) const {
        Pieces pieces;
        for (const DiffuseSource::Face& face : source.faces()) {
            if (!(face.luminous.exitance > 0.0)) continue;
            for (const Polygon& piece : face.pieces) pieces.push_back({piece, face.front});
        }
        return pieces;
    }
    Pieces operator()(const MeasuredSource& source) const {
        Pieces pieces;
        for (const Polygon& piece : source.pieces()) pieces.push_back({piece, source.front()});
        return pieces;
    }
};

/// Each piece's share of the opening; of uniform faces its flux.
struct WeightsOf {
    std::span<const LuminousPiece> pieces;

    std::vector<double> operator()(const PointSource&) const { return shares(); }
    std::vector<double> operator()(const LineSource&) const { return shares(); }
    std::vector<double> operator()(const MeasuredSource&) const { return shares(); }
    std::vector<double> operator()(const DiffuseSource& source) const {
        std::vector<double> weights;
        for (const DiffuseSource::Face& face : source.faces()) {
            if (!(face.luminous.exitance > 0.0)) continue;
            for (const Polygon& piece : face.pieces) weights.push_back(face.luminous.exitance * FlatCell(piece).size);
        }
        return weights;
    }

private:
    std::vector<double> shares() const {
        std::vector<double> sizes;
        double sum = 0.0;
        for (const LuminousPiece& piece : pieces) sum += sizes.emplace_back(FlatCell(piece.corners).size);
        for (double& size : sizes) size = sum > 0.0 ? size / sum : 0.0;
        return sizes;
    }
};

/// From one place of a piece to a part of a patch.
struct FromPlace {
    const LuminousPiece& piece;
    const Vec3& place;
    const FlatCell& part;
    const Vec3& normal;

    PlaceLight operator()(const DiffuseSource&) const {
        const double factor = configuration_factor(part.corners, {place, piece.front, Vec3{0.0}});
        return {part.size > 0.0 ? factor / part.size : 0.0, 0.0};
    }
    PlaceLight operator()(const PointSource& source) const {
        return over_nodes([&](const Receiver& receiver) { return source.unobstructed(receiver); });
    }
    PlaceLight operator()(const LineSource& source) const {
        return over_nodes([&](const Receiver& receiver) { return source.from_place(place, receiver); });
    }
    PlaceLight operator()(const MeasuredSource& source) const {
        return over_nodes([&](const Receiver& receiver) { return source.from_place(place, receiver); });
    }

private:
    template <class Light>
    PlaceLight over_nodes(Light&& light) const {
        double sum = 0.0, least = std::numeric_limits<double>::infinity(), greatest = 0.0;
        for (const Vec3& node : part.nodes()) {
            const double here = light(Receiver{node, normal, Vec3{0.0}});
            sum += here;
            least = std::min(least, here);
            greatest = std::max(greatest, here);
        }
        if (part.count == 0) return {};
        return {sum / static_cast<double>(part.count), greatest - least};
    }
};

/// What arrives from each kind of source past the obstacles.
struct Arriving {
    const Receiver& receiver;
    Obstacles obstacles;
    Accuracy accuracy;

    Estimate operator()(const PointSource& source) const {
        const double whole = source.unobstructed(receiver);
        if (whole == 0.0 || !obstacles.occluders) return {whole};
        std::vector<BodyIndex>& found = bodies_between({&source.position(), 1});
        return obstacles.occluders->blocks(receiver.position, source.position(), found) ? Estimate{} : Estimate{whole};
    }
    Estimate operator()(const LineSource& source) const {
        const double whole = source.unobstructed(receiver);
        if (whole == 0.0 || !obstacles.occluders) return {whole};
        const std::array ends{source.from, source.to};
        std::vector<BodyIndex>& found = bodies_between(ends);
        if (found.empty()) return {whole};
        double sum = 0.0;
        for (const auto& [first, last] :
             visible_intervals(source.from, source.to, receiver.position, *obstacles.occluders, found)) {
            sum += source.unobstructed(receiver, first, last);
        }
        return {sum};
    }
    Estimate operator()(const DiffuseSource& source) const { return {source.obstructed(receiver, obstacles)}; }
    Estimate operator()(const MeasuredSource& source) const { return source.obstructed(receiver, obstacles, accuracy); }

private:
    std::vector<BodyIndex>& bodies_between(std::span<const Vec3> points) const {
        thread_local std::vector<BodyIndex> found;
        obstacles.between(receiver.position, points, found);
        return found;
    }
};

}  // namespace

Emitter::Emitter(const Scene& scene, const Luminaire& luminaire) {
    MadeSource made = make_source(scene, luminaire);
    std::vector<Vec3> extent = std::visit(ExtentOf{}, made.source);
    std::vector<LuminousPiece> pieces = std::visit(PiecesOf{}, made.source);
    std::vector<double> weights = std::visit(WeightsOf{pieces}, made.source);
    parts_ = std::make_shared<const Parts>(Parts{luminaire.id, made.flux, std::move(made.source), std::move(extent),
                                                 std::move(pieces), std::move(weights)});
}

Estimate Emitter::estimate(const Receiver& receiver, const OccluderSet* occluders, const Accuracy& accuracy) const {
    return std::visit(Arriving{receiver, {occluders, parts_->luminaire.value, {}}, accuracy}, parts_->source);
}

Estimate Emitter::estimate(const Receiver& receiver, const OccluderSet& occluders, std::span<const BodyIndex> among,
                           const Accuracy& accuracy) const {
    return std::visit(Arriving{receiver, {&occluders, parts_->luminaire.value, among}, accuracy}, parts_->source);
}

Illuminance Emitter::illuminance(const Receiver& receiver, const OccluderSet* occluders) const {
    return {estimate(receiver, occluders).value};
}

Illuminance Emitter::illuminance(const Receiver& receiver, const OccluderSet& occluders,
                                 std::span<const BodyIndex> among) const {
    return {estimate(receiver, occluders, among).value};
}

PlaceLight Emitter::from_place(std::size_t piece, const Vec3& place, const FlatCell& part, const Vec3& normal) const {
    const PlaceLight light = std::visit(FromPlace{parts_->pieces[piece], place, part, normal}, parts_->source);
    return {parts_->weights[piece] * light.mean, parts_->weights[piece] * light.spread};
}

bool Emitter::shines_from_places() const {
    if (const auto* measured = std::get_if<MeasuredSource>(&parts_->source)) return measured->is_flat();
    const auto* diffuse = std::get_if<DiffuseSource>(&parts_->source);
    return !diffuse || !diffuse->hides_itself();
}

std::optional<NarrowBeam> Emitter::narrow_beam() const {
    const auto* const point = std::get_if<PointSource>(&parts_->source);
    return point != nullptr ? point->narrow_beam() : std::nullopt;
}

bool Emitter::is_exact() const { return !std::holds_alternative<MeasuredSource>(parts_->source); }

bool Emitter::is_uniform() const { return std::holds_alternative<DiffuseSource>(parts_->source); }

LuminousFlux Emitter::flux() const { return parts_->flux; }
ObjectId Emitter::luminaire() const { return parts_->luminaire; }
std::span<const Vec3> Emitter::extent() const { return parts_->extent; }
std::span<const LuminousPiece> Emitter::pieces() const { return parts_->pieces; }

}  // namespace hanei
