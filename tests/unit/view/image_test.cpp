#include "ui/view/image.h"

#include "ui/view/legend.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <png.h>

namespace hanei {
namespace {

namespace fs = std::filesystem;

class PngFile : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() /
                  (std::string("hanei_image_") + testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    static Image checkered() {
        Image image{5, 3, {}};
        for (int k = 0; k < 5 * 3 * 4; ++k) image.rgba.push_back(static_cast<std::uint8_t>(k * 37));
        return image;
    }
    static std::string content(const fs::path& file) {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    fs::path folder_;
};

TEST_F(PngFile, read_back_has_the_same_pixels) {
    const Image image = checkered();
    const fs::path file = folder_ / "a.png";
    write_png(image, file);
    png_image read{};
    read.version = PNG_IMAGE_VERSION;
    ASSERT_NE(png_image_begin_read_from_file(&read, file.c_str()), 0);
    read.format = PNG_FORMAT_RGBA;
    std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(read));
    ASSERT_NE(png_image_finish_read(&read, nullptr, pixels.data(), 0, nullptr), 0);
    EXPECT_EQ(read.width, 5U);
    EXPECT_EQ(read.height, 3U);
    EXPECT_EQ(pixels, image.rgba);
}

TEST_F(PngFile, carries_its_text_and_nothing_that_changes_from_run_to_run) {
    const fs::path first = folder_ / "a.png", second = folder_ / "b.png";
    write_png(checkered(), first, {{"Title", "Büro 影"}, {"Software", "Hanei"}});
    write_png(checkered(), second, {{"Title", "Büro 影"}, {"Software", "Hanei"}});
    EXPECT_EQ(content(first), content(second));
    EXPECT_NE(content(first).find("Büro 影"), std::string::npos);
    EXPECT_EQ(content(first).find("tIME"), std::string::npos);
}

TEST_F(PngFile, leaves_nothing_but_the_target_behind) {
    write_png(checkered(), folder_ / "a.png");
    write_png(checkered(), folder_ / "a.png");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(PngFile, that_cannot_be_written_is_named) {
    try {
        write_png(checkered(), folder_ / "no such folder" / "a.png");
        FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& fault) {
        EXPECT_NE(std::string(fault.what()).find("no such folder"), std::string::npos);
    }
}

TEST(Legend, has_the_height_asked_for_and_grows_with_the_scale) {
    const ViewOptions view;
    const Image normal = legend_image(view, 500), large = legend_image(view, 1000, 2.0);
    EXPECT_EQ(normal.height, 500);
    EXPECT_EQ(normal.width, legend_width(view));
    EXPECT_EQ(large.width, legend_width(view, 2.0));
    EXPECT_GT(large.width, 3 * normal.width / 2);
    EXPECT_TRUE(legend_image(view, 500).rgba == normal.rgba);
}

TEST(Legend, of_another_range_looks_different) {
    ViewOptions view;
    const Image one = legend_image(view, 400);
    view.range = {100.0, 5000.0};
    EXPECT_FALSE(legend_image(view, 400).rgba == one.rgba);
}

TEST(Caption, says_title_part_method_and_error) {
    Solution solution;
    auto scene = std::make_shared<Scene>();
    scene->title = "Archive";
    solution.scene = scene;
    solution.bounces = 4;
    solution.iteration_bound = 0.25;
    ViewOptions view;
    view.part = LightPart::direct;
    const Caption caption = caption_of(solution, view);
    EXPECT_EQ(caption.title, "Archive – Direct light only");
    EXPECT_NE(caption.detail.find("patch"), std::string::npos);
    EXPECT_NE(caption.detail.find("4 interreflections so far"), std::string::npos) << caption.detail;
    EXPECT_NE(caption.detail.find("0.25 lx"), std::string::npos);
    solution.refusal = "All light comes back.";
    const Caption refused = caption_of(solution, view);
    EXPECT_EQ(refused.detail.find("Error"), std::string::npos) << refused.detail;
    EXPECT_NE(refused.detail.find("has no end here"), std::string::npos) << refused.detail;
}

}  // namespace
}  // namespace hanei
