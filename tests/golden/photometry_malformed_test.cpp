// Hostile luminaire files: each is answered as its line in index.tsv asks, at once and in one sentence.

#include "engine/project/luminaire_file.h"
#include "engine/project/luminaires.h"
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
    std::string file, verdict, line, field;
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
        const std::string ending = std::filesystem::path{file}.extension().string();
        const bool read = ending == ".ies" || ending == ".ldt" || ending == ".xml" || ending == ".gldf";
        if (read) result.push_back({file, values[column("verdict")], values[column("line")], values[column("field")]});
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

/// A finding names the line and the field that are asked for; where none is there is nothing to warn of.
bool names_place(const Demand& demand, const Diagnostics& findings) {
    const bool silent = demand.verdict != "reject" && demand.line.empty() && demand.field.empty();
    return silent || std::any_of(findings.begin(), findings.end(), [&](const Diagnostic& found) {
               return holds(demand.line, found.place.line) && to_text(found).find(demand.field) != std::string::npos;
           });
}

std::string fault_of(const Demand& demand, const LuminairesRead& read) {
    const bool loaded = !read.luminaires.empty();
    if (loaded == has_errors(read.findings)) return "errors and a photometry exclude each other";
    if (demand.verdict == "reject" && loaded) return "loaded";
    if (demand.verdict == "accept" && !loaded) return "refused";
    for (const Diagnostic& found : read.findings) {
        if (found.message.empty() || found.place.field.empty()) return "no sentence";
    }
    if (!names_place(demand, read.findings)) return "not the place";
    for (const auto& [name, photometry] : read.luminaires) {
        const bool finite = std::isfinite(luminous_flux(photometry).value) &&
                            std::isfinite(intensity(photometry, {0.6, 0.0, -0.8}).value);
        if (!finite) return name + " is not finite";
    }
    return "";
}

const std::filesystem::path own_folder = std::filesystem::path{HANEI_SOURCE} / "tests/golden/luminaires/malformed";

/// Lines and fields of the project's own index hold where two differ: lines were counted in the files, and
/// fields are called by the words of the program.
std::size_t count_answered(const std::filesystem::path& folder, std::size_t& count) {
    std::size_t answered = 0;
    const std::vector<Demand> own = demands(own_folder / "index.tsv");
    for (Demand demand : demands(folder / "index.tsv")) {
        for (const Demand& known : own) {
            if (known.file != demand.file) continue;
            demand.line = known.line;
            demand.field = known.field;
        }
        if (!std::filesystem::exists(folder / demand.file)) continue;  // too large to travel with the tests
        ++count;
        const auto start = std::chrono::steady_clock::now();
        const LuminairesRead read = read_luminaires(folder / demand.file);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        const std::string fault = fault_of(demand, read);
        const std::string said = read.findings.empty() ? "nothing" : to_text(read.findings.back());
        EXPECT_EQ(fault, "") << demand.file << " (" << demand.verdict << ", line " << demand.line << ", "
                             << demand.field << ") said: " << said;
        EXPECT_LT(took.count(), 1.0) << demand.file;  // s: what a user waits for without asking why
        if (fault.empty()) ++answered;
    }
    return answered;
}

TEST(LuminaireFiles, that_are_broken_are_answered_in_one_sentence_with_their_line) {
    std::size_t count = 0;
    EXPECT_EQ(count_answered(own_folder, count), count);
    EXPECT_EQ(count, 87U);
}

TEST(LuminaireFiles, that_are_broken_and_large_are_answered_as_fast) {
    const auto folder = std::filesystem::path{HANEI_SHARED} / "photometry/malformed";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "skipped: no test data at " << folder;
    std::size_t count = 0;
    const std::size_t answered = count_answered(folder, count);
    std::cout << answered << " of " << count << " broken luminaire files answered as they should be\n";
    EXPECT_EQ(answered, count);
    EXPECT_EQ(count, 92U);
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
