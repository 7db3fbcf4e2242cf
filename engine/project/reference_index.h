/// The list of the reference cases that come with the program, and what each of them proves.
#pragma once

#include "engine/base/diagnostic.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hanei {

struct ReferenceEntry {
    std::filesystem::path file;
    std::string proves;  ///< a few words
    std::string source;  ///< of what is expected: "closed form", "own reference", "CIE 171, 5.8"
};

struct ReferenceIndex {
    std::vector<ReferenceEntry> entries;  ///< none when there are errors
    Diagnostics findings;
};

/// An index.json (hanei-reference-index/1); files are named relative to it.
ReferenceIndex read_reference_index(const std::filesystem::path& file);
ReferenceIndex read_reference_index_text(std::string_view json, const std::filesystem::path& file);

}  // namespace hanei
