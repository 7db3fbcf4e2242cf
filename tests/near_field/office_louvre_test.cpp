/// Direct light of the louvre luminaires in the open-plan office against sums of samples with sight
/// rays, written without the engine's geometry. Skipped when the reference cases are absent.
#include "engine/direct/direct.h"
#include "engine/mesh/mesh.h"
#include "engine/project/reference_case.h"
#include "engine/scene/intensity.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <iostream>
#include <map>

namespace hanei {
namespace {

/// A convex polygon that sight rays are tested against.
class Screen {
public:
    explicit Screen(const Polygon& corners) : corners_(corners) {
        normal_ = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        for (const Vec3& corner : corners) middle_ += corner / static_cast<double>(corners.size());
        for (const Vec3& corner : corners) radius_ = std::max(radius_, glm::distance(corner, middle_));
    }
    bool may_stand_between(const Vec3& from, const Vec3& to, double around) const {
        const Vec3 way = to - from;
        const double t = std::clamp(glm::dot(middle_ - from, way) / glm::dot(way, way), 0.0, 1.0);
        return glm::distance(middle_, from + t * way) <= radius_ + around;
    }
    bool blocks(const Vec3& from, const Vec3& to) const {
        const double before = glm::dot(from - corners_[0], normal_), behind = glm::dot(to - corners_[0], normal_);
        const double touching = 1e-9 * glm::length(normal_);
        if (std::min(before, behind) > -touching || std::max(before, behind) < touching) return false;
        const Vec3 at = from + (before / (before - behind)) * (to - from);
        for (std::size_t k = 0; k < corners_.size(); ++k) {
            const Vec3 edge = corners_[(k + 1) % corners_.size()] - corners_[k];
            if (glm::dot(glm::cross(edge, at - corners_[k]), normal_) < 0.0) return false;
        }
        return true;
    }

private:
    Polygon corners_;
    Vec3 normal_{0.0}, middle_{0.0};
    double radius_ = 0.0;
};

/// One luminaire: every element of its rectangle has its share of the file's intensity.
struct Louvre {
    Polygon corners;
    Vec3 axes[3];  ///< the file's frame
    Screen screen;
};

double sampled(const ReferencePoint& at, const Louvre& louvre, const Photometry& photometry, double scale,
               const std::vector<Screen>& screens, int samples) {
    const Polygon& c = louvre.corners;
    const Vec3 middle = 0.25 * (c[0] + c[1] + c[2] + c[3]);
    std::vector<const Screen*> near;
    for (const Screen& screen : screens) {
        if (screen.may_stand_between(at.position, middle, 0.5 * glm::distance(c[0], c[2]))) near.push_back(&screen);
    }
    double sum = 0.0;
    for (int k = 0; k < samples; ++k) {
        // The plastic number's sequence: shadows of desks run along the opening's edges, and of a lattice
        // they would cut whole rows at once.
        const double u = std::fmod(0.5 + 0.7548776662466927 * k, 1.0), v = std::fmod(0.5 + 0.5698402909980532 * k, 1.0);
        const Vec3 place = c[0] + (c[1] - c[0]) * u + (c[3] - c[0]) * v;
        const Vec3 away = at.position - place;
        const double distance = glm::length(away), height = -glm::dot(away, at.normal);
        if (height <= 0.0) continue;
        if (std::ranges::any_of(near, [&](const Screen* s) { return s->blocks(at.position, place); })) continue;
        const Vec3 local{glm::dot(away, louvre.axes[0]), glm::dot(away, louvre.axes[1]),
                         glm::dot(away, louvre.axes[2])};
        sum += intensity(photometry, local / distance).value * height / (distance * distance * distance);
    }
    return scale * sum / samples;
}

struct Sampled {
    double value = 0.0, own_error = 0.0;
};

/// Many samples where a screen cuts the opening. A cut at a place of no meaning is off by about
/// samples^(-3/4) of what the whole opening would give.
Sampled converged(const ReferencePoint& at, const Louvre& louvre, const Photometry& photometry, double scale,
                  const std::vector<Screen>& screens) {
    const double whole = sampled(at, louvre, photometry, scale, {}, 4000);
    const double seen = sampled(at, louvre, photometry, scale, screens, 4000);
    if (seen == whole) return {whole, 1e-4 * whole};
    constexpr int samples = 32'000;
    return {sampled(at, louvre, photometry, scale, screens, samples), std::pow(samples, -0.75) * whole};
}

struct Figures {
    std::vector<double> error, claim;  ///< of the mean value
    double mean = 0.0;
    int within = 0;
    double part(std::vector<double>& of, double share) const {
        std::ranges::sort(of);
        return of[static_cast<std::size_t>(share * static_cast<double>(of.size() - 1))];
    }
};

TEST(OfficeLouvre, direct_light_at_the_receivers_is_that_of_converged_sampling) {
    const std::filesystem::path file = std::filesystem::path(HANEI_SHARED) / "reference/scenes/scene_S4.json";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent";
    const ReferenceRead read = read_reference(file);
    ASSERT_FALSE(read.cases.empty());
    const ReferenceCase& office = read.cases.front();
    const Photometry& photometry = office.scene.photometries.at(0);
    const OccluderSet occluders = occluders_of(office.scene);

    std::vector<Emitter> emitters;
    std::vector<Louvre> louvres;
    std::vector<Screen> screens;
    for (const FreeSurface& surface : office.scene.surfaces) screens.emplace_back(surface.region.outline);
    for (const Luminaire& luminaire : office.scene.luminaires) {
        emitters.emplace_back(office.scene, luminaire);
        Polygon corners = std::get<PolygonOpening>(luminaire.opening).region.outline;
        for (Vec3& corner : corners) corner += luminaire.position;  // none is turned
        louvres.push_back({corners, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, Screen(corners)});
        EXPECT_EQ(luminaire.yaw, 0.0);
        EXPECT_EQ(luminaire.tilt, 0.0);
    }
    const double scale = 3600.0 / luminous_flux(photometry).value;

    std::map<std::string, Figures> sets;
    for (std::size_t p = 0; p < office.points.size(); p += 20) {
        const ReferencePoint& at = office.points[p];
        Estimate got;
        double expected = 0.0, own_error = 0.0;
        for (std::size_t k = 0; k < emitters.size(); ++k) {
            const Estimate one = emitters[k].estimate({at.position, at.normal, {}}, &occluders);
            got.value += one.value;
            got.error += one.error;
            const Sampled all = converged(at, louvres[k], photometry, scale, screens);
            expected += all.value;
            own_error += all.own_error;
        }
        Figures& figures = sets[at.set];
        figures.error.push_back(std::abs(got.value - expected));
        figures.claim.push_back(got.error);
        figures.mean += expected;
        if (figures.error.back() <= got.error + own_error) ++figures.within;
    }
    for (auto& [name, figures] : sets) {
        const auto count = static_cast<double>(figures.error.size());
        double mean_error = 0.0;
        for (const double error : figures.error) mean_error += error / count;
        figures.mean /= count;
        std::cout << name << ": " << count << " receivers, mean " << figures.mean << " lx, error mean " << mean_error
                  << " p95 " << figures.part(figures.error, 0.95) << " max " << figures.part(figures.error, 1.0)
                  << " lx; claimed median " << figures.part(figures.claim, 0.5) << " max "
                  << figures.part(figures.claim, 1.0) << " lx; within " << figures.within / count << '\n';
        EXPECT_GE(figures.within, 0.99 * count) << name;
        EXPECT_LE(figures.part(figures.error, 1.0), 5e-3 * std::max(figures.mean, 1.0)) << name;
    }
}

}  // namespace
}  // namespace hanei
