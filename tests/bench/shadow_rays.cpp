#include "tests/bench/shadow_rays.h"

#include "tests/bench/settings.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace hanei::bench {

namespace {

constexpr std::size_t packet = 16;

struct Triangles {
    std::vector<std::array<float, 3>> corners;
    std::vector<std::array<unsigned, 3>> indices;
};

Triangles triangles_of(std::span<const ConvexBody> bodies) {
    Triangles made;
    for (const ConvexBody& body : bodies) {
        const auto first = static_cast<unsigned>(made.corners.size());
        for (const Vec3& v : body.vertices) {
            made.corners.push_back({static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
        }
        for (const std::vector<int>& face : body.faces) {
            for (std::size_t k = 2; k < face.size(); ++k) {
                made.indices.push_back({first + static_cast<unsigned>(face[0]),
                                        first + static_cast<unsigned>(face[k - 1]),
                                        first + static_cast<unsigned>(face[k])});
            }
        }
    }
    return made;
}

template <class T>
void give(RTCGeometry geometry, RTCBufferType type, RTCFormat format, const std::vector<std::array<T, 3>>& values) {
    auto* buffer = static_cast<T*>(rtcSetNewGeometryBuffer(geometry, type, 0, format, 3 * sizeof(T), values.size()));
    for (const std::array<T, 3>& value : values) {
        for (const T component : value) *buffer++ = component;
    }
}

}  // namespace

ShadowRays::ShadowRays(std::span<const ConvexBody> bodies)
    : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_.get())) {
    const Triangles triangles = triangles_of(bodies);
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    give(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, triangles.corners);
    give(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles.indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_.get());
}

void ShadowRays::set_samples(int count) {
    const auto on_panel = [](double t, double width) { return static_cast<float>(width * (t - std::floor(t) - 0.5)); };
    x_.clear();
    y_.clear();
    for (int k = 0; k < count; ++k) {
        x_.push_back(on_panel(0.5 + 0.7548776662466927 * k, panel_width));
        y_.push_back(on_panel(0.5 + 0.5698402909980532 * k, panel_depth));
    }
}

double ShadowRays::visible_share(const Receiver& receiver, const Vec3& panel) const {
    const Vec3 to_panel = panel - receiver.position;
    const auto dx = static_cast<float>(to_panel.x), dy = static_cast<float>(to_panel.y);
    const auto dz = static_cast<float>(to_panel.z);
    const auto nx = static_cast<float>(receiver.normal.x), ny = static_cast<float>(receiver.normal.y);
    const auto nz = static_cast<float>(receiver.normal.z);
    alignas(64) std::array<int, packet> valid;
    valid.fill(-1);
    alignas(64) RTCRay16 rays;
    alignas(64) std::array<float, packet> weights;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;

    float whole = 0.0F, seen = 0.0F;
    for (std::size_t first = 0; first < x_.size(); first += packet) {
        for (std::size_t k = 0; k < packet; ++k) {
            rays.org_x[k] = static_cast<float>(receiver.position.x);
            rays.org_y[k] = static_cast<float>(receiver.position.y);
            rays.org_z[k] = static_cast<float>(receiver.position.z);
            rays.dir_x[k] = dx + x_[first + k];
            rays.dir_y[k] = dy + y_[first + k];
            rays.dir_z[k] = dz;
            rays.tnear[k] = 1e-5F;
            rays.tfar[k] = 1.0F - 1e-5F;
            rays.time[k] = 0.0F;
            rays.mask[k] = ~0U;
            rays.id[k] = 0;
            rays.flags[k] = 0;
            const float square = rays.dir_x[k] * rays.dir_x[k] + rays.dir_y[k] * rays.dir_y[k] + dz * dz;
            const float height = rays.dir_x[k] * nx + rays.dir_y[k] * ny + dz * nz;
            weights[k] = (height > 0.0F ? height : 0.0F) * dz / (square * square);
        }
        rtcOccluded16(valid.data(), scene_.get(), &context, &rays);
        for (std::size_t k = 0; k < packet; ++k) {
            whole += weights[k];
            seen += rays.tfar[k] < 0.0F ? 0.0F : weights[k];
        }
    }
    return whole > 0.0F ? static_cast<double>(seen / whole) : 0.0;
}

}  // namespace hanei::bench
