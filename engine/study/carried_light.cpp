#include "engine/study/carried_light.h"

#include <array>
#include <limits>
#include <map>
#include <numeric>

namespace hanei {

namespace {

constexpr std::size_t neighbours = 4;

/// Vertices of the old mesh that a value is taken from, with their shares.
struct Among {
    std::array<std::uint32_t, neighbours> vertex{};
    std::array<double, neighbours> share{};
    std::size_t count = 0;
};

/// The nearest of a face's vertices, the nearer the more; `moved` is how far the face went.
Among among_nearest(const Mesh& mesh, const MeshFace& face, const Vec3& place, const Vec3& moved) {
    std::array<double, neighbours> squares;
    squares.fill(std::numeric_limits<double>::infinity());
    Among among;
    for (std::uint32_t v = face.first_vertex; v < face.first_vertex + face.vertex_count; ++v) {
        const Vec3 apart = mesh.vertices[v].receiver.position + moved - place;
        double square = glm::dot(apart, apart);
        std::uint32_t vertex = v;
        for (std::size_t k = 0; k < neighbours; ++k) {
            if (square >= squares[k]) continue;
            std::swap(square, squares[k]);
            std::swap(vertex, among.vertex[k]);
        }
    }
    among.count = std::min<std::size_t>(neighbours, face.vertex_count);
    const double same = 1e-12 * (1.0 + glm::dot(place, place));
    if (among.count > 0 && squares[0] <= same) among.count = 1;
    double sum = 0.0;
    for (std::size_t k = 0; k < among.count; ++k) sum += among.share[k] = 1.0 / std::max(squares[k], same);
    for (std::size_t k = 0; k < among.count; ++k) among.share[k] /= sum;
    return among;
}

std::vector<Among> sources_of(const Mesh& from, const Mesh& to) {
    std::map<SurfaceRef, const MeshFace*> known;
    for (const MeshFace& face : from.faces) known.emplace(face.face.ref, &face);
    std::vector<Among> sources(to.vertices.size());
    for (const MeshFace& face : to.faces) {
        const auto found = known.find(face.face.ref);
        if (found == known.end()) continue;
        const Vec3 moved = face.face.region.outline.front() - found->second->face.region.outline.front();
        for (std::uint32_t v = face.first_vertex; v < face.first_vertex + face.vertex_count; ++v)
            sources[v] = among_nearest(from, *found->second, to.vertices[v].receiver.position, moved);
    }
    return sources;
}

std::vector<double> carried(const std::vector<double>& values, std::span<const Among> sources) {
    const double mean =
        values.empty() ? 0.0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    std::vector<double> carried;
    carried.reserve(sources.size());
    for (const Among& among : sources) {
        double value = among.count == 0 ? mean : 0.0;
        for (std::size_t k = 0; k < among.count; ++k) value += among.share[k] * values[among.vertex[k]];
        carried.push_back(value);
    }
    return carried;
}

}  // namespace

void CarriedLight::keep(std::shared_ptr<const Mesh> mesh, LightOfSurfaces light, double flux) {
    mesh_ = std::move(mesh);
    light_ = std::move(light);
    light_.open.clear();
    flux_ = flux;
}

LightOfSurfaces CarriedLight::at(const std::shared_ptr<const Mesh>& mesh, double flux) const {
    LightOfSurfaces light = light_;
    if (mesh != mesh_) {
        const std::vector<Among> sources = sources_of(*mesh_, *mesh);
        light.interreflected = carried(light_.interreflected, sources);
        for (std::size_t band = 0; band < light.bands.size(); ++band)
            light.bands[band] = carried(light_.bands[band], sources);
    }
    const double ratio = flux_ > 0.0 ? flux / flux_ : 1.0;
    for (double& lux : light.interreflected) lux *= ratio;
    for (std::vector<double>& band : light.bands)
        for (double& lux : band) lux *= ratio;
    return light;
}

}  // namespace hanei
