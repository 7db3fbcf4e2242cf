/// What direct light of measured openings claims to be off by, and what the point certificate allows,
/// over the public luminaire files. Skipped when these are absent.
#include "engine/direct/direct.h"
#include "engine/geometry/polygon.h"
#include "engine/project/luminaire_file.h"
#include "engine/scene/point_certificate.h"
#include "tests/opening_sums.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <gtest/gtest.h>
#include <iostream>
#include <random>

namespace hanei {
namespace {

using testing::LocalReceiver;

/// Every `stride`th file that shines from an opening, smallest tables as likely as great ones.
std::vector<Photometry> public_files(std::size_t stride) {
    std::vector<std::filesystem::path> paths;
    for (const char* folder : {"ies", "ldt", "synthetic"}) {
        const auto path = std::filesystem::path(HANEI_SHARED) / "photometry/public" / folder;
        if (!std::filesystem::exists(path)) continue;
        for (const auto& entry : std::filesystem::directory_iterator(path)) paths.push_back(entry.path());
    }
    std::ranges::sort(paths);
    std::vector<Photometry> files;
    for (std::size_t k = 0; k < paths.size(); k += stride) {
        LuminaireFileRead read = read_luminaire_file(paths[k]);
        if (!read.photometry || !(peak_intensity(*read.photometry).value > 0.0)) continue;
        if (form_of(read.photometry->opening).radius == 0.0) continue;
        read.photometry->id = ObjectId{3};
        read.photometry->source_file = paths[k].filename().string();
        files.push_back(std::move(*read.photometry));
    }
    return files;
}

struct Shot {
    LocalReceiver at;
    double distance = 1.0;  ///< from the opening's ball
};

Shot shot(const Photometry& photometry, double distance, std::mt19937_64& random) {
    std::normal_distribution<double> any;
    const double radius = form_of(photometry.opening).radius;
    const Vec3 direction = glm::normalize(Vec3{any(random), any(random), -std::abs(any(random))});
    const Vec3 normal = glm::normalize(-direction + 0.5 * Vec3{any(random), any(random), any(random)});
    return {{(radius + distance) * direction, normal}, distance};
}

/// Fine enough that one lattice hardly differs from the next.
int lattice(const Photometry& photometry, const Shot& shot) {
    const double radius = form_of(photometry.opening).radius;
    const int fine = photometry.vertical_deg.size() > 100 ? 120 : 60;
    return std::clamp(static_cast<int>(fine * radius / shot.distance), 48, 320);
}

TEST(ClaimedError, holds_in_99_of_100_cases_over_the_public_files) {
    const std::vector<Photometry> files = public_files(3);
    if (files.empty()) GTEST_SKIP() << "no public luminaire files";
    std::mt19937_64 random(11);
    const std::array<Accuracy, 3> asked = {Accuracy{}, Accuracy{0.01, 0.0}, Accuracy{0.03, 0.0}};
    std::array<int, 3> cases{}, within{};
    std::array<std::vector<double>, 3> ratios;
    for (const Photometry& photometry : files) {
        Scene scene;
        scene.photometries = {photometry};
        Luminaire luminaire;
        luminaire.id = ObjectId{7};
        luminaire.opening = MeasuredOpening{};
        luminaire.distribution = Measured{photometry.id};
        luminaire.output = AsMeasured{};
        const Emitter emitter(scene, luminaire);
        for (const double distance : {0.1, 0.3, 1.0, 3.0, 10.0}) {
            for (const bool cut : {false, true}) {
                const Shot one = shot(photometry, distance, random);
                const int n = lattice(photometry, one);
                const Vec3& eye = one.at.position;
                double expected = 0.0, own_error = 0.0;
                std::array<Estimate, 3> got;
                const auto ask = [&](const OccluderSet* occluders) {
                    std::ranges::transform(asked, got.begin(), [&](const Accuracy& accuracy) {
                        return emitter.estimate({eye, one.at.normal, {}}, occluders, accuracy);
                    });
                };
                if (!cut) {
                    ask(nullptr);
                    expected = testing::opening_sum(photometry, one.at, n);
                    own_error = std::abs(expected - testing::opening_sum(photometry, one.at, 5 * n / 8));
                } else {
                    // A sheet half way whose edge crosses the sight of the middle: what is left of a flat
                    // opening is a convex polygon, summed as such.
                    if (is_solid(photometry.opening) || distance < 1.0) continue;
                    const Vec3 along = glm::normalize(glm::cross(eye, Vec3{0.3, -0.5, 0.8}));
                    const Vec3 out = glm::normalize(glm::cross(along, eye)), edge = 0.5 * eye;
                    const OccluderSet sheet({{{edge + 9.0 * along, edge - 9.0 * along, edge - 9.0 * along + 9.0 * out,
                                               edge + 9.0 * along + 9.0 * out},
                                              {{0, 1, 2, 3}},
                                              0}});
                    const Polygon whole = flat_opening(photometry.opening);
                    const Polygon left = clipped(whole, {eye, -out}, 0.0);
                    if (left.size() < 3) continue;
                    const double share = glm::length(vector_area(left)) / glm::length(vector_area(whole));
                    ask(&sheet);
                    expected = share * testing::flat_sum(photometry, left, one.at, n / 2);
                    own_error = std::abs(expected - share * testing::flat_sum(photometry, left, one.at, n / 3));
                }
                for (std::size_t k = 0; k < asked.size(); ++k) {
                    if (own_error > 0.3 * got[k].error) continue;  // the sum is no judge of it
                    const double error = std::abs(got[k].value - expected);
                    ++cases[k];
                    if (error <= got[k].error + own_error) ++within[k];
                    if (error > own_error) ratios[k].push_back(got[k].error / error);
                }
            }
        }
    }
    for (std::size_t k = 0; k < asked.size(); ++k) {
        std::ranges::sort(ratios[k]);
        std::cout << cases[k] << " cases of " << files.size() << " files at " << asked[k].share << ", within "
                  << static_cast<double>(within[k]) / cases[k] << ", claimed over true error: median "
                  << ratios[k][ratios[k].size() / 2] << '\n';
        EXPECT_GT(cases[k], 400);
        EXPECT_GE(within[k], 0.99 * cases[k]);
    }
}

TEST(PointCertificate, holds_for_every_public_file) {
    const std::vector<Photometry> files = public_files(1);
    if (files.empty()) GTEST_SKIP() << "no public luminaire files";
    std::mt19937_64 random(5);
    std::normal_distribution<double> any;
    std::vector<double> ratios;
    for (const Photometry& photometry : files) {
        const PointCertificate certificate(photometry);
        const double peak = peak_intensity(photometry).value, radius = certificate.opening().radius;
        for (const double radii : {3.0, 10.0, 60.0}) {
            const double distance = radii * radius;
            double greatest = 0.0;
            for (int k = 0; k < 6; ++k) {
                const Vec3 direction = glm::normalize(Vec3{any(random), any(random), any(random) - 1.0});
                const double candela = intensity(photometry, direction).value;
                const double sum = testing::opening_sum(photometry, {distance * direction, -direction}, 16);
                const double off = std::abs(sum * distance * distance - candela);
                const double own_error = 4e-3 * peak / (radii * radii) + 1e-9 * peak;
                EXPECT_LE(off, certificate.error(direction, distance, candela, 1.0) + own_error)
                    << photometry.source_file << " at " << radii;
                greatest = std::max(greatest, off / peak);
            }
            const double bound = certificate.bound(distance);
            EXPECT_GE(bound + 4e-3 / (radii * radii), greatest) << photometry.source_file;
            if (greatest > 1e-6 && std::isfinite(bound)) ratios.push_back(bound / greatest);
        }
    }
    std::ranges::sort(ratios);
    std::cout << files.size() << " files, bound over the greatest of six directions: median "
              << ratios[ratios.size() / 2] << ", least " << ratios.front() << '\n';
}

}  // namespace
}  // namespace hanei
