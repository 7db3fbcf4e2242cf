#include "engine/project/reference_index.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

TEST(ReferenceIndex, names_files_beside_itself_and_what_they_prove) {
    const ReferenceIndex index = read_reference_index_text(
        R"({"schema": "hanei-reference-index/1", "cases": [{"file": "a.json", "proves": "P", "source": "S"}]})",
        "folder/index.json");
    ASSERT_EQ(index.entries.size(), 1U);
    EXPECT_EQ(index.entries[0].file, "folder/a.json");
    EXPECT_EQ(index.entries[0].proves, "P");
    EXPECT_EQ(index.entries[0].source, "S");
}

TEST(ReferenceIndex, of_something_else_is_empty_and_says_so) {
    for (const char* text : {"", "[]", "{}", R"({"schema": "other/1", "cases": []})",
                             R"({"schema": "hanei-reference-index/1", "cases": [{"proves": "P"}]})",
                             R"({"schema": "hanei-reference-index/1", "cases": 3})"}) {
        const ReferenceIndex index = read_reference_index_text(text, "index.json");
        EXPECT_TRUE(index.entries.empty()) << text;
        ASSERT_FALSE(index.findings.empty()) << text;
        EXPECT_EQ(index.findings[0].place.file, "index.json") << text;
    }
}

TEST(ReferenceIndex, of_a_missing_file_is_a_finding) {
    EXPECT_TRUE(has_errors(read_reference_index("nowhere/index.json").findings));
}

}  // namespace
}  // namespace hanei
