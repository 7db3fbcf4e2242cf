// Hostile luminaire files: each is answered as its line in index.tsv asks, at once and in one sentence.

#include "engine/project/luminaire_file.h"
#include "engine/scene/intensity.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace hanei {
namespace {

struct Demand {
    std::string file, verdict, line;
};

std::vector<std::string> cells(const std::string& row) {
    std::vector<std::string> result;
    std::istringstream stream{row};
    for (std::string cell; std::getline(stream, cell, '\t');) result.push_back(cell);
    return result;
}

/// Rows of index.tsv for the formats that are read, its columns found by their names.
std::vector<Demand> demands(const std::filesystem::path& index) {
    std::ifstream stream{index};
    std::string row;
    std::getline(stream, row);
    const std::vector<std::string> names = cells(row);
    const auto column = [&names](const std::string& name) {
        return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    std::vector<Demand> result;
    while (std::getline(stream, row)) {
        std::vector<std::string> values = cells(row);
        values.resize(names.size());
        const std::string& file = values[column("file")];
        const bool read = file.ends_with(".ies") || file.ends_with(".ldt") || file.ends_with(".xml");
        if (read) result.push_back({file, values[column("verdict")], values[column("line")]});
    }
    return result;
}

/// "" or a number or "8-10".
bool holds(const std::string& lines, int line) {
    if (lines.empty()) return true;
    const std::size_t dash = lines.find('-');
    const int first = std::stoi(lines);
    return line >= first && line <= (dash == std::string::npos ? first : std::stoi(lines.substr(dash + 1)));
}

std::string fault_of(const Demand& demand, const LuminaireFileRead& read) {
    if (read.photometry.has_value() == has_errors(read.findings)) return "errors and a photometry exclude each other";
    if (demand.verdict == "reject" && read.photometry) return "loaded";
    if (demand.verdict == "accept" && !read.photometry) return "refused";
    for (const Diagnostic& found : read.findings) {
        if (found.message.empty() || found.place.field.empty()) return "no sentence";
    }
    const bool names_line = std::any_of(read.findings.begin(), read.findings.end(),
                                        [&](const Diagnostic& found) { return holds(demand.line, found.place.line); });
    if (!read.photometry) return names_line ? "" : "line " + std::to_string(read.findings.back().place.line);
    // an opening of no size and a long label are nothing to warn of
    const bool harmless = demand.file == "ldt_18_zero_opening.ldt" || demand.file == "ies_38_60000_keywords.ies";
    if (!names_line && !harmless) return "no warning with its line";
    const bool finite = std::isfinite(luminous_flux(*read.photometry).value);
    return finite && std::isfinite(intensity(*read.photometry, {0.6, 0.0, -0.8}).value) ? "" : "not finite";
}

const std::filesystem::path own_folder = std::filesystem::path{HANEI_SOURCE} / "tests/golden/luminaires/malformed";

/// The lines of the project's own index hold where two differ: they were counted in the files.
std::size_t count_answered(const std::filesystem::path& folder, std::size_t& count) {
    std::size_t answered = 0;
    const std::vector<Demand> own = demands(own_folder / "index.tsv");
    for (Demand demand : demands(folder / "index.tsv")) {
        for (const Demand& known : own) {
            if (known.file == demand.file) demand.line = known.line;
        }
        ++count;
        const auto start = std::chrono::steady_clock::now();
        const LuminaireFileRead read = read_luminaire_file(folder / demand.file);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        const std::string fault = fault_of(demand, read);
        const std::string said = read.findings.empty() ? "nothing" : to_text(read.findings.back());
        EXPECT_EQ(fault, "") << demand.file << " (" << demand.verdict << ", line " << demand.line << ") said: " << said;
        EXPECT_LT(took.count(), 1.0) << demand.file;  // s: what a user waits for without asking why
        if (fault.empty()) ++answered;
    }
    return answered;
}

TEST(LuminaireFiles, that_are_broken_are_answered_in_one_sentence_with_their_line) {
    std::size_t count = 0;
    EXPECT_EQ(count_answered(own_folder, count), count);
    EXPECT_GE(count, 70U);
}

TEST(LuminaireFiles, that_are_broken_and_large_are_answered_as_fast) {
    const auto folder = std::filesystem::path{HANEI_SHARED} / "photometry/malformed";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "skipped: no test data at " << folder;
    std::size_t count = 0;
    const std::size_t answered = count_answered(folder, count);
    std::cout << answered << " of " << count << " broken luminaire files answered as they should be\n";
    EXPECT_EQ(answered, count);
}

TEST(LuminaireFiles, that_were_found_broken_are_refused) {
    const auto folder = std::filesystem::path{HANEI_SHARED} / "photometry/public/malformed_found";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "skipped: no test data at " << folder;
    for (const auto& file : std::filesystem::directory_iterator{folder}) {
        EXPECT_FALSE(read_luminaire_file(file.path()).photometry) << file.path();
    }
}

}  // namespace
}  // namespace hanei
