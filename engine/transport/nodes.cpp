#include "engine/transport/nodes.h"

#include "engine/base/check.h"

#include <algorithm>
#include <numeric>

namespace hanei {

Nodes nodes_of(const Mesh& mesh, Elements elements) {
    Nodes nodes;
    nodes.elements = elements;
    nodes.per_patch = elements == Elements::linear ? 4 : 1;
    nodes.receivers.reserve(mesh.patches.size() * nodes.per_patch);
    for (const Patch& patch : mesh.patches) {
        const Face& face = mesh.faces[patch.face].face;
        nodes.areas.insert(nodes.areas.end(), nodes.per_patch, patch.area / static_cast<double>(nodes.per_patch));
        if (elements == Elements::constant) {
            nodes.receivers.push_back(mesh.centre_of(patch));
            continue;
        }
        const PatchFrame frame = frame_of(patch.outline, face.normal, face.along);
        for (unsigned k = 0; k < 4; ++k) nodes.receivers.push_back({frame.node(k), face.normal, Vec3{0.0}});
    }
    return nodes;
}

PatchFrame Nodes::frame(std::size_t patch) const {
    const auto place = [&](std::size_t k) { return receivers[4 * patch + k].position; };
    return {0.5 * (place(0) + place(3)), 0.5 * (place(1) - place(0)), 0.5 * (place(2) - place(0))};
}

std::vector<double> patch_means(const Nodes& nodes, std::span<const double> node_values) {
    std::vector<double> means(nodes.patches());
    for (std::size_t p = 0; p < means.size(); ++p) {
        const auto own = node_values.subspan(p * nodes.per_patch, nodes.per_patch);
        means[p] = std::accumulate(own.begin(), own.end(), 0.0) / static_cast<double>(nodes.per_patch);
    }
    return means;
}

double exitance_at(const Mesh& mesh, const Nodes& nodes, PatchId patch, const Vec3& place,
                   std::span<const double> node_values) {
    HANEI_CHECK(nodes.patches() == mesh.patches.size() && node_values.size() == nodes.size());
    const auto p = static_cast<std::size_t>(patch);
    if (nodes.elements == Elements::constant) return std::max(0.0, node_values[p]);
    const Vec2 at = nodes.frame(p).coordinates(place);
    const auto own = node_values.subspan(4 * p, 4);
    const double near = own[0] * (1.0 - at.x) + own[1] * (1.0 + at.x);
    const double far = own[2] * (1.0 - at.x) + own[3] * (1.0 + at.x);
    return std::max(0.0, 0.25 * (near * (1.0 - at.y) + far * (1.0 + at.y)));
}

std::vector<double> vertex_values(const Mesh& mesh, const Nodes& nodes, std::span<const double> node_values) {
    std::vector<double> sums(mesh.vertices.size(), 0.0);
    std::vector<double> counts(mesh.vertices.size(), 0.0);
    for (std::size_t p = 0; p < mesh.patches.size(); ++p) {
        const Patch& patch = mesh.patches[p];
        for (std::size_t k = 0; k < patch.corners.size(); ++k) {
            const auto vertex = static_cast<std::size_t>(patch.corners[k]);
            sums[vertex] +=
                exitance_at(mesh, nodes, PatchId{static_cast<std::uint32_t>(p)}, patch.outline[k], node_values);
            counts[vertex] += 1.0;
        }
    }
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] /= std::max(1.0, counts[k]);
    return sums;
}

std::array<Polygon, 4> quarters_of(const Mesh& mesh, const Nodes& nodes, PatchId patch) {
    return quarters_of(mesh[patch].outline, nodes.frame(static_cast<std::size_t>(patch)));
}

std::array<double, 4> node_values_of_quarters(const Mesh& mesh, const Nodes& nodes, PatchId patch,
                                              const std::array<double, 4>& means) {
    const PatchFrame frame = nodes.frame(static_cast<std::size_t>(patch));
    const std::array<Polygon, 4> quarters = quarters_of(mesh[patch].outline, frame);
    std::array<FrameMeans, 4> parts;
    double area = 0.0, light = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
        parts[k] = means_over(quarters[k], frame);
        area += parts[k].area;
        light += parts[k].area * means[k];
    }
    const double mean = light / area;

    double xx = 0.0, yy = 0.0, xy = 0.0, x_light = 0.0, y_light = 0.0, twisted = 0.0, twist_light = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
        const FrameMeans& part = parts[k];
        xx += part.area * part.xi * part.xi;
        yy += part.area * part.eta * part.eta;
        xy += part.area * part.xi * part.eta;
        x_light += part.area * part.xi * (means[k] - mean);
        y_light += part.area * part.eta * (means[k] - mean);
    }
    const double determinant = xx * yy - xy * xy;
    const double slope_x = (yy * x_light - xy * y_light) / determinant;
    const double slope_y = (xx * y_light - xy * x_light) / determinant;
    for (std::size_t k = 0; k < 4; ++k) {
        const FrameMeans& part = parts[k];
        const double left = means[k] - mean - slope_x * part.xi - slope_y * part.eta;
        twisted += part.area * part.product * part.product;
        twist_light += part.area * part.product * left;
    }
    const double twist = twist_light / twisted;

    std::array<double, 4> values{};
    double flatter = 1.0;
    for (unsigned k = 0; k < 4; ++k) {
        const double x = k & 1U ? 1.0 : -1.0, y = k & 2U ? 1.0 : -1.0;
        values[k] = slope_x * x + slope_y * y + twist * x * y;
        if (mean + values[k] < 0.0) flatter = std::min(flatter, -mean / values[k]);
    }
    for (double& value : values) value = std::max(0.0, mean + flatter * value);
    return values;
}

}  // namespace hanei
