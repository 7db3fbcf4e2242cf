#include "ui/view/png_text.h"

#include "ui/view/image.h"
#include "ui/view/picture_text.h"

#include <fstream>
#include <gtest/gtest.h>

namespace hanei {
namespace {

std::filesystem::path scratch(const std::string& name) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "hanei png text";
    std::filesystem::create_directories(folder);
    return folder / name;
}

Image small() { return {2, 2, std::vector<std::uint8_t>(16, 200)}; }

TEST(PngText, comes_back_as_it_was_written) {
    const PngText text{{"Title", "Büro – 事務所"}, {"Description", "lx, ± 2"}, {"Empty", ""}};
    write_png(small(), scratch("a.png"), text);
    EXPECT_EQ(read_png_text(scratch("a.png")), text);
    write_png(small(), scratch("b.png"));
    EXPECT_EQ(read_png_text(scratch("b.png")), PngText{});
}

TEST(PngText, of_a_broken_file_is_none_wherever_it_breaks_off) {
    const std::string whole = png_bytes(small(), {{"Title", "A"}, {"Software", "B"}});
    for (std::size_t size = 0; size + 12 < whole.size(); ++size) {
        std::ofstream(scratch("broken.png"), std::ios::binary) << whole.substr(0, size);
        EXPECT_FALSE(read_png_text(scratch("broken.png"))) << size;
    }
    EXPECT_FALSE(read_png_text(scratch("none.png")));
    EXPECT_FALSE(read_png_text(scratch("")));
}

TEST(Hashes, of_texts_are_the_same_everywhere_and_differ_by_a_letter) {
    EXPECT_EQ(short_hash(""), "cbf29ce484222325");
    EXPECT_EQ(short_hash("a"), "af63dc4c8601ec8c");
    EXPECT_NE(short_hash("room 1"), short_hash("room 2"));
}

}  // namespace
}  // namespace hanei
