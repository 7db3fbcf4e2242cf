#include "engine/base/tiles.h"
#include "engine/geometry/visible_part.h"
#include "engine/transport/factors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hanei {

namespace {

constexpr std::size_t rows_a_tile = 16;

struct Bounds {
    Vec3 low{std::numeric_limits<double>::infinity()};
    Vec3 high{-std::numeric_limits<double>::infinity()};

    void include(const Vec3& place) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    bool meets(const Box& box) const {
        return glm::all(glm::lessThanEqual(low, box.high)) && glm::all(glm::lessThanEqual(box.low, high));
    }
};

/// True when the plane through the eye and a row has the body's box on both sides.
bool plane_cuts(const Vec3& normal, const Vec3& eye, const Box& box, double same_place) {
    const double height = glm::dot(normal, box.centre() - eye);
    return std::abs(height) <= glm::dot(glm::abs(normal), box.half_size() + Vec3(same_place));
}

bool is_outside(const Face& face, const Box& box, double same_place) {
    const double height = glm::dot(face.normal, box.centre() - face.region.outline.front());
    return height + glm::dot(glm::abs(face.normal), box.half_size()) <= same_place;
}

/// The rows of grid points seen from one grid point.
class RowsSeen {
public:
    RowsSeen(const Mesh& mesh, const OccluderSet& occluders) : mesh_(mesh), occluders_(occluders) {}

    void write(const Vertex& from, const MeshFace& face, float* shares) {
        candidates_.clear();
        occluders_.between(from.receiver.position, face.face.region.outline, candidates_);
        std::erase_if(candidates_, [&](BodyIndex body) {
            const Box& box = occluders_.shape(body).box;
            const double same_place = occluders_.same_place();
            return is_outside(mesh_.faces[from.face].face, box, same_place) || is_outside(face.face, box, same_place);
        });
        if (candidates_.empty()) return;
        for (const VertexRow& row : face.rows) write_row(from.receiver.position, row, shares);
    }

private:
    void write_row(const Vec3& eye, const VertexRow& row, float* shares) {
        // a little longer than the row: a shadow that ends at its last point then ends inside the segment
        const Vec3 beyond =
            1e-3 * (mesh_[row.vertices.back()].receiver.position - mesh_[row.vertices.front()].receiver.position);
        const Vec3 first = mesh_[row.vertices.front()].receiver.position - beyond;
        const Vec3 last = mesh_[row.vertices.back()].receiver.position + beyond;
        Bounds triangle;
        for (const Vec3& corner : {eye, first, last}) triangle.include(corner);
        const Vec3 plane = glm::cross(first - eye, last - eye);
        near_.clear();
        for (const BodyIndex body : candidates_) {
            const Box& box = occluders_.shape(body).box;
            if (triangle.meets(box) && plane_cuts(plane, eye, box, occluders_.same_place())) near_.push_back(body);
        }
        if (near_.empty()) return;
        const double length = glm::length(last - first);
        if (length <= occluders_.same_place()) {
            for (const VertexId id : row.vertices) {
                if (occluders_.blocks(eye, mesh_[id].receiver.position, near_))
                    shares[static_cast<std::size_t>(id)] = 0.0F;
            }
            return;
        }
        const auto visible = visible_intervals(first, last, eye, occluders_, near_);
        // hidden intervals are open: a point at their very end is seen
        const double end = occluders_.same_place() / length;
        for (const VertexId id : row.vertices) {
            const double t = glm::dot(mesh_[id].receiver.position - first, last - first) / (length * length);
            const bool seen = std::any_of(visible.begin(), visible.end(), [&](const auto& interval) {
                return t >= interval.first - end && t <= interval.second + end;
            });
            if (!seen) shares[static_cast<std::size_t>(id)] = 0.0F;
        }
    }

    const Mesh& mesh_;
    const OccluderSet& occluders_;
    std::vector<BodyIndex> candidates_, near_;
};

}  // namespace

std::optional<DenseRows> paper_factors(const Mesh& mesh, const Work& work) {
    const std::size_t count = mesh.vertices.size();
    DenseRows factors{count, count, std::vector<float>(count * count)};
    const bool finished = for_each_tile(count, rows_a_tile, work, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Receiver& at = mesh.vertices[i].receiver;
            for (std::size_t j = 0; j < count; ++j) {
                const Vertex& from = mesh.vertices[j];
                const Vec3 apart = from.receiver.position - at.position;
                const double over_receiver = glm::dot(at.normal, apart);
                const double over_sender = -glm::dot(from.receiver.normal, apart);
                if (over_receiver <= 0.0 || over_sender <= 0.0) continue;
                const double square = glm::dot(apart, apart);
                factors.values[i * count + j] =
                    static_cast<float>(over_receiver * over_sender * from.area / (std::numbers::pi * square * square));
            }
        }
    });
    if (!finished) return std::nullopt;
    return factors;
}

std::optional<Visibility> paper_visibility(const Mesh& mesh, const OccluderSet& occluders, const Work& work) {
    Visibility visibility;
    if (occluders.empty()) return visibility;
    const std::size_t count = mesh.vertices.size();
    visibility.share = {count, count, std::vector<float>(count * count, 1.0F)};
    std::vector<float>& shares = visibility.share.values;
    const bool finished = for_each_tile(count, rows_a_tile, work, [&](std::size_t begin, std::size_t end) {
        RowsSeen rows(mesh, occluders);
        for (std::size_t i = begin; i < end; ++i) {
            const Vertex& from = mesh.vertices[i];
            for (const MeshFace& face : mesh.faces) {
                const Vec3& corner = face.face.region.outline.front();
                if (face.vertex_count == 0 || glm::dot(from.receiver.position - corner, face.face.normal) <= 0.0)
                    continue;
                rows.write(from, face, shares.data() + i * count);
            }
        }
    });
    if (!finished) return std::nullopt;
    visibility.all_visible = std::all_of(shares.begin(), shares.end(), [](float share) { return share == 1.0F; });
    if (visibility.all_visible) visibility.share = {};
    return visibility;
}

}  // namespace hanei
