/// A picture in memory and on disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace hanei {

/// Rows from the top, four bytes a pixel (red, green, blue, alpha), sRGB.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

/// The same as a file's bytes.
std::string png_bytes(const Image& image, const std::vector<std::pair<std::string, std::string>>& text = {});

/// Text chunks travel with the PNG (Title, Software, Comment, ...): nothing that changes from run
/// to run is added by itself. Written beside its target and renamed; throws std::runtime_error
/// naming the file when the disk refuses.
void write_png(const Image& image, const std::filesystem::path& file,
               const std::vector<std::pair<std::string, std::string>>& text = {});

}  // namespace hanei
