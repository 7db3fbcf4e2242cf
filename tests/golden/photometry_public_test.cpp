// Luminaire files with known answers: intensity in 50 directions, flux, opening, output ratio. The
// synthetic ones travel with the tests, the measured ones lie beside the project when present.

#include "engine/project/luminaire_file.h"
#include "engine/scene/intensity.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace hanei {
namespace {

using nlohmann::json;

const std::filesystem::path own_folder = std::filesystem::path{HANEI_SOURCE} / "tests/golden/luminaires";
const std::filesystem::path shared_folder = std::filesystem::path{HANEI_SHARED} / "photometry";

json read_json(const std::filesystem::path& file) {
    std::ifstream stream{file};
    return json::parse(stream);
}

std::vector<double> intensities(const Photometry& photometry, const json& directions) {
    std::vector<double> values;
    for (const json& direction : directions) {
        const PhotometricAngles angles{direction[0].get<double>(), direction[1].get<double>()};
        values.push_back(intensity(photometry, photometric_direction(PhotometricType::C, angles)).value);
    }
    return values;
}

/// EULUMDAT states a height for each side. A point has none.
template <class Compare>
void compare_sides(const MeasuredOpeningSize& opening, const json& heights_mm, const Compare& compare) {
    if (opening.shape == OpeningShape::point) return;
    const char* const sides[] = {"C0", "C90", "C180", "C270"};
    for (std::size_t k = 0; k < 4; ++k) {
        const double found = opening.side_heights ? (*opening.side_heights)[k] : opening.height;
        compare(std::string{"height at "} + sides[k], found, heights_mm[sides[k]].get<double>() / 1000.0, 1e-9);
    }
}

/// Everything in which a file differs from what is expected of it; empty when it agrees.
std::string disagreement(const std::filesystem::path& file, const json& expected, const json& directions) {
    const LuminaireFileRead read = read_luminaire_file(file);
    if (!read.photometry) return "refused: " + to_text(read.findings.back());
    const Photometry& photometry = *read.photometry;
    std::string text;
    const auto compare = [&text](const std::string& what, double found, double wanted, double tolerance) {
        if (std::abs(found - wanted) <= tolerance) return;
        text += what + " " + std::to_string(found) + " instead of " + std::to_string(wanted) + "; ";
    };
    const double peak = expected["max_cd"].get<double>();
    const std::vector<double> values = intensities(photometry, directions);
    for (std::size_t k = 0; k < values.size(); ++k) {
        compare("intensity " + directions[k].dump(), values[k], expected["intensity_cd"][k].get<double>(), 1e-4 * peak);
    }
    const double flux = expected["flux_lm"].get<double>();
    compare("flux", luminous_flux(photometry).value, flux, 1e-4 * flux);
    compare("zone flux", zone_average_flux(photometry).value, expected["flux_zone_average_lm"].get<double>(),
            1e-4 * flux);
    if (expected.contains("flux_lower_lm") && !expected["flux_lower_lm"].is_null()) {
        compare("downward flux", downward_flux(photometry).value, expected["flux_lower_lm"].get<double>(), 1e-4 * flux);
    }
    compare("peak", peak_intensity(photometry).value, peak, 1e-4 * peak);
    compare("watts", photometry.input_watts, expected["input_watts"].get<double>(), 1e-9);
    const json& opening = expected["opening"];
    if (opening.contains("extent_c0_c180_m") && !opening["extent_c0_c180_m"].is_null()) {
        compare("extent 0", photometry.opening.extent_0, opening["extent_c0_c180_m"].get<double>(), 1e-6);
        compare("extent 90", photometry.opening.extent_90, opening["extent_c90_c270_m"].get<double>(), 1e-6);
        if (opening.contains("heights_mm")) {
            compare_sides(photometry.opening, opening["heights_mm"], compare);
        } else {
            compare("height", photometry.opening.height, opening["height_m"].get<double>(), 1e-6);
        }
    }
    const bool has_ratio = !photometry.absolute && photometry.lamp_lumens > 0.0;
    if (has_ratio == expected["lor"].is_null()) {
        text += "output ratio known on one side alone; ";
    } else if (has_ratio) {
        compare("output ratio", luminous_flux(photometry).value / photometry.lamp_lumens, expected["lor"].get<double>(),
                1e-3);
    }
    return text;
}

std::size_t count_agreeing(const std::filesystem::path& folder, const json& expected) {
    std::size_t agreeing = 0;
    for (const auto& [name, of_file] : expected["files"].items()) {
        const std::string text = disagreement(folder / name, of_file, expected["directions"]);
        EXPECT_EQ(text, "") << name;
        if (text.empty()) ++agreeing;
    }
    return agreeing;
}

TEST(LuminaireFiles, written_for_the_tests_give_the_known_intensities_flux_and_opening) {
    const json expected = read_json(own_folder / "expected.json");
    EXPECT_EQ(count_agreeing(own_folder, expected), 93U);
}

TEST(LuminaireFiles, of_manufacturers_give_the_known_intensities_flux_and_opening) {
    const auto file = shared_folder / "public_expected.json";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "skipped: no test data at " << file;
    const json expected = read_json(file);
    const std::size_t agreeing = count_agreeing(shared_folder / "public", expected);
    std::cout << agreeing << " of " << expected["files"].size() << " luminaire files agree\n";
    EXPECT_EQ(agreeing, expected["files"].size());
}

TEST(LuminaireFiles, one_light_in_many_notations_is_one_light) {
    const json groups = read_json(own_folder / "synthetic/groups.json");
    const json directions = read_json(own_folder / "expected.json")["directions"];
    EXPECT_EQ(groups.size(), 9U);
    for (const auto& [group, names] : groups.items()) {
        std::vector<double> first;
        double flux = 0.0;
        for (const json& name : names) {
            const LuminaireFileRead read = read_luminaire_file(own_folder / "synthetic" / name.get<std::string>());
            ASSERT_TRUE(read.photometry) << name;
            const std::vector<double> values = intensities(*read.photometry, directions);
            if (first.empty()) {
                first = values;
                flux = luminous_flux(*read.photometry).value;
            }
            // figures are written with three decimals, cd/klm are rounded before they are multiplied
            const double peak = peak_intensity(*read.photometry).value;
            for (std::size_t k = 0; k < values.size(); ++k) EXPECT_NEAR(values[k], first[k], 1e-5 * peak) << name;
            EXPECT_NEAR(luminous_flux(*read.photometry).value, flux, 1e-5 * flux) << name;
        }
    }
}

}  // namespace
}  // namespace hanei
