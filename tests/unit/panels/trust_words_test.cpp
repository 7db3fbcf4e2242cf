#include "source_texts.h"
#include "ui/view/japanese.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace hanei {
namespace {

TEST(TrustWords, are_all_known_in_japanese) {
    const std::set<std::string> of_figures{"luminaire {}"};
    for (const char* name : {"trust_rows.cpp"}) {
        std::ifstream stream(std::filesystem::path(HANEI_SOURCE) / "engine/report" / name, std::ios::binary);
        std::ostringstream text;
        text << stream.rdbuf();
        const auto literals = literals_of(text.str(), name);
        EXPECT_GT(literals.size(), 20U);
        for (const SourceText& each : literals) {
            if (!reads_like_words(each.text) || of_figures.contains(each.text)) continue;
            const auto table = japanese();
            EXPECT_TRUE(std::any_of(table.begin(), table.end(),
                                    [&](const Translation& entry) { return entry.english == each.text; }))
                << each.place << " " << each.text;
        }
    }
}

}  // namespace
}  // namespace hanei
