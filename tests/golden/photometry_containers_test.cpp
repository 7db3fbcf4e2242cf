// GLDF containers with known contents: product, files, photometries, emitters, variants, orphans.

#include "engine/project/gldf_file.h"
#include "engine/scene/intensity.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace hanei {
namespace {

using nlohmann::json;

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{stream}, std::istreambuf_iterator<char>{}};
}

json or_null(const std::string& text) { return text.empty() ? json(nullptr) : json(text); }

json files_of(const GldfListing& listing) {
    json files = json::object();
    for (const GldfFile& file : listing.files) {
        json& one = files[file.id] = {{"contentType", file.content_type}, {"type", file.type}, {"name", file.name}};
        one["entry"] = or_null(file.entry);
        one["present"] = file.entry.empty() ? json(nullptr) : json(file.present);
    }
    return files;
}

json emitters_of(const GldfListing& listing) {
    json emitters = json::object();
    for (const GldfEmitter& emitter : listing.emitters) {
        emitters[emitter.id].push_back({{"kind", emitter.kind},
                                        {"photometry", or_null(emitter.photometry)},
                                        {"rated_flux", emitter.rated_flux ? json(*emitter.rated_flux) : json(nullptr)},
                                        {"emergency", or_null(emitter.emergency)}});
    }
    return emitters;
}

json variants_of(const GldfListing& listing) {
    json variants = json::array();
    for (const GldfVariant& variant : listing.variants)
        variants.push_back({{"id", variant.id}, {"name", variant.name}, {"emitters", variant.emitters}});
    return variants;
}

std::string difference(const Photometry& found, const json& expected) {
    std::string text;
    const auto compare = [&](const char* what, double value, double wanted, double tolerance) {
        if (std::abs(value - wanted) > tolerance) text += fmt::format("{} {} instead of {}; ", what, value, wanted);
    };
    const double flux = expected["flux_lm"].get<double>();
    compare("flux", luminous_flux(found).value, flux, 1e-4 * flux);
    compare("peak", peak_intensity(found).value, expected["max_cd"].get<double>(), 1e-4 * flux);
    compare("lamps", found.lamp_lumens, expected["lamp_lumens"].get<double>(), 1e-9);
    const json& opening = expected["opening"];
    compare("extent 0", found.opening.extent_0, opening["extent_c0_c180_m"].get<double>(), 1e-9);
    compare("extent 90", found.opening.extent_90, opening["extent_c90_c270_m"].get<double>(), 1e-9);
    return text;
}

std::string photometry_difference(const GldfListing& listing, const json& expected) {
    if (listing.photometries.size() != expected.size()) return "number of photometries; ";
    std::string text;
    for (const GldfPhotometry& found : listing.photometries) {
        if (!expected.contains(found.id)) return "photometry " + found.id + "; ";
        const json& wanted = expected[found.id];
        if (wanted["file"] != found.file) text += "file of " + found.id + "; ";
        if (wanted.contains("flux_lm") != found.photometry.has_value()) text += "reading of " + found.id + "; ";
        if (wanted.contains("error") && found.fault.empty()) text += "no fault of " + found.id + "; ";
        if (wanted.contains("flux_lm") && found.photometry) text += difference(*found.photometry, wanted);
    }
    return text;
}

/// Every warning that is expected is found: a missing file by its words, any other by what it is about.
std::string warning_difference(const GldfRead& read, const json& expected) {
    std::string text;
    for (const json& warning : expected) {
        const std::string words = warning.get<std::string>();
        const std::string subject = words.substr(0, words.find_first_of(": "));
        const bool found = std::any_of(read.findings.begin(), read.findings.end(), [&](const Diagnostic& finding) {
            if (words.starts_with("file "))
                return fmt::format("f{}: {}", finding.place.field.substr(1), finding.message) == words;
            return to_text(finding).find(subject) != std::string::npos;
        });
        if (!found) text += "no word of: " + words + "; ";
    }
    const auto missing = [](const Diagnostic& finding) { return finding.place.field.starts_with("File "); };
    const auto wanted = std::count_if(expected.begin(), expected.end(), [](const json& warning) {
        return warning.get<std::string>().starts_with("file ");
    });
    if (std::count_if(read.findings.begin(), read.findings.end(), missing) != wanted) text += "number of warnings; ";
    return text;
}

std::string disagreement(const GldfRead& read, const json& expected) {
    if (expected.contains("error")) return read.listing || !has_errors(read.findings) ? "read; " : "";
    if (!read.listing) return "not read; ";
    const GldfListing& listing = *read.listing;
    std::string text;
    const auto compare = [&text](const char* what, const json& found, const json& wanted) {
        if (found != wanted) text += fmt::format("{} {} instead of {}; ", what, found.dump(), wanted.dump());
    };
    compare("manufacturer", or_null(listing.manufacturer), expected["manufacturer"]);
    compare("product", or_null(listing.product), expected["product"]);
    compare("version", or_null(listing.format_version), expected["format_version"]);
    compare("files", files_of(listing), expected["files"]);
    compare("emitters", emitters_of(listing), expected["emitters"]);
    compare("variants", variants_of(listing), expected["variants"]);
    compare("orphans", listing.orphans, expected["orphans"]);
    return text + photometry_difference(listing, expected["photometries"]) +
           warning_difference(read, expected["warnings"]);
}

/// A luminaire for every emitter of a variant that has a photometry, and no luminaire without a word why.
std::size_t luminaires_expected(const json& expected) {
    std::size_t count = 0;
    if (!expected.contains("variants")) return 0;
    for (const json& variant : expected["variants"]) {
        for (const json& id : variant["emitters"]) {
            for (const json& emitter : expected["emitters"][id.get<std::string>()]) {
                if (emitter["photometry"].is_null()) continue;
                const json& photometry = expected["photometries"][emitter["photometry"].get<std::string>()];
                if (photometry.contains("flux_lm")) ++count;
            }
        }
    }
    return count;
}

/// An entry of this container has its name twice: in the code page of the machine that wrote it, and as
/// UTF-8 (field 0x7075), which is what was meant. The expectations were written from the first.
void set_right(const std::string& name, json& expected) {
    if (name.ends_with("GldfWithCodepage850.gldf")) expected["orphans"] = {"ldc/\u00C4\u00F6\u00FC\u00B0\u00A7.ldt"};
}

/// Returns   how many containers of the folder agree.
std::size_t count_agreeing(const std::filesystem::path& folder, json files, std::size_t& count) {
    std::size_t agreeing = 0;
    for (auto& [name, expected] : files.items()) {
        if (!name.ends_with(".gldf")) continue;
        ++count;
        set_right(name, expected);
        const GldfRead read = read_gldf(bytes_of(folder / name), name);
        const std::string text = disagreement(read, expected);
        EXPECT_EQ(text, "") << name;
        EXPECT_EQ(read.luminaires.size(), luminaires_expected(expected)) << name;
        EXPECT_NE(read.luminaires.empty(), !has_errors(read.findings)) << name;
        if (text.empty()) ++agreeing;
    }
    return agreeing;
}

TEST(Containers, of_public_collections_hold_what_is_known_of_them) {
    const auto folder = std::filesystem::path{HANEI_SHARED} / "photometry";
    std::ifstream stream{folder / "public_containers_expected.json"};
    if (!stream) GTEST_SKIP() << "skipped: no test data at " << folder;
    const json expected = json::parse(stream);
    std::size_t count = 0;
    const std::size_t agreeing = count_agreeing(folder / "public", expected["files"], count);
    std::cout << agreeing << " of " << count << " GLDF containers agree\n";
    EXPECT_EQ(agreeing, count);
    EXPECT_EQ(count, 15U);
}

const std::filesystem::path own_folder = std::filesystem::path{HANEI_SOURCE} / "tests/golden/luminaires/containers";

TEST(Containers, written_for_the_tests_hold_what_is_known_of_them) {
    std::ifstream stream{own_folder / "expected.json"};
    std::size_t count = 0;
    EXPECT_EQ(count_agreeing(own_folder, json::parse(stream)["files"], count), count);
    EXPECT_EQ(count, 3U);
}

TEST(Containers, give_each_emitter_the_flux_it_is_rated_for) {
    const GldfRead read = read_gldf(bytes_of(own_folder / "two_emitters_bom.gldf"), "two_emitters_bom.gldf");
    ASSERT_EQ(read.luminaires.size(), 2U);
    EXPECT_EQ(read.luminaires[0].name, "V / e1");
    EXPECT_EQ(read.luminaires[1].name, "V / e2, emergency only");
    EXPECT_NEAR(luminous_flux(read.luminaires[0].photometry).value, 1000.0, 1e-9);
    EXPECT_NEAR(luminous_flux(read.luminaires[1].photometry).value, 250.0, 1e-9);
    EXPECT_EQ(read.luminaires[0].photometry.input_watts, 20.0);
    EXPECT_FALSE(read.luminaires[0].photometry.warnings.empty());
}

}  // namespace
}  // namespace hanei
