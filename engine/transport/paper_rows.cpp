#include "engine/transport/paper_rows.h"

#include "engine/geometry/visible_part.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hanei {

namespace {

/// Form factors from point to point grow past all bounds in a gap; a float ends at 3e38, and what is
/// infinite ends every sum. Rows that come near this say of themselves that they pass on too much light.
constexpr double most_of_a_factor = 1e30;

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

void PaperRows::write_factors(const Vertex& at, float* row) const {
    for (std::size_t j = 0; j < mesh_.vertices.size(); ++j) {
        const Vertex& from = mesh_.vertices[j];
        const Vec3 apart = from.receiver.position - at.receiver.position;
        const double over_receiver = glm::dot(at.receiver.normal, apart);
        const double over_sender = -glm::dot(from.receiver.normal, apart);
        if (over_receiver <= 0.0 || over_sender <= 0.0) continue;
        const double square = glm::dot(apart, apart);
        const double factor = over_receiver * over_sender * from.area / (std::numbers::pi * square * square);
        row[j] = static_cast<float>(std::fmin(factor, most_of_a_factor));
    }
}

bool PaperRows::write(std::size_t first, std::size_t last, float* factors, float* shares) {
    const std::size_t count = mesh_.vertices.size();
    for (std::size_t i = first; i < last; ++i) write_factors(mesh_.vertices[i], factors + (i - first) * count);
    if (!occluders_ || occluders_->empty()) return false;
    RowsSeen rows(mesh_, *occluders_);
    for (std::size_t i = first; i < last; ++i) {
        const Vertex& from = mesh_.vertices[i];
        for (const MeshFace& face : mesh_.faces) {
            const Vec3& corner = face.face.region.outline.front();
            if (face.vertex_count == 0 || glm::dot(from.receiver.position - corner, face.face.normal) <= 0.0) continue;
            rows.write(from, face, shares + (i - first) * count);
        }
    }
    return std::any_of(shares, shares + (last - first) * count, [](float share) { return share != 1.0F; });
}

}  // namespace hanei
