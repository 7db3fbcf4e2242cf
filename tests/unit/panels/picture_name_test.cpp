#include "ui/panels/picture_name.h"

#include <gtest/gtest.h>

namespace hanei {
namespace {

NameParts parts() {
    return {"office", "from the door", "total", 1280, 800, 3, std::chrono::system_clock::from_time_t(1'700'000'000)};
}

TEST(PictureNames, replace_what_stands_in_braces) {
    EXPECT_EQ(picture_name("{project} {view} {part} {size} {number}.png", parts()).name,
              "office from the door total 1280x800 3.png");
    const std::string date = picture_name("{date}", parts()).name;
    EXPECT_EQ(date.size(), std::string("2023-11-14.png").size());
    EXPECT_EQ(date.substr(0, 5), "2023-");
}

TEST(PictureNames, hold_nothing_that_is_no_part_of_a_file_name) {
    NameParts odd = parts();
    odd.project = "../..\nA/B: \"C\"";
    odd.view = "";
    EXPECT_EQ(picture_name("{project} {view} {part}", odd).name, "..-..-A-B- -C- total.png");
    EXPECT_EQ(picture_name("a.png", odd).name, "a.png");
}

TEST(PictureNames, are_refused_with_a_sentence_when_they_make_no_sense) {
    EXPECT_NE(picture_name("{lux}.png", parts()).fault.find("{lux} means nothing"), std::string::npos);
    for (const char* const text : {"", " ", ".png", "..", "{project"}) {
        EXPECT_FALSE(picture_name(text, parts()).fault.empty()) << text;
        EXPECT_EQ(picture_name(text, parts()).name, "") << text;
    }
    EXPECT_FALSE(picture_name(std::string(500, 'x'), parts()).fault.empty());
}

}  // namespace
}  // namespace hanei
