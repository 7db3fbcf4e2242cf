#include "ui/view/image.h"

#include "engine/base/check.h"
#include "engine/base/whole_file.h"

#include <csetjmp>
#include <png.h>
#include <stdexcept>

namespace hanei {
namespace {

void append(png_structp png, png_bytep data, png_size_t size) {
    auto* bytes = static_cast<std::vector<char>*>(png_get_io_ptr(png));
    bytes->insert(bytes->end(), data, data + size);
}

void nothing_to_flush(png_structp) {}

std::vector<png_text> chunks_of(const std::vector<std::pair<std::string, std::string>>& text) {
    std::vector<png_text> chunks;
    for (const auto& [key, value] : text) {
        png_text chunk{};
        chunk.compression = PNG_ITXT_COMPRESSION_NONE;  // the chunk that is UTF-8
        chunk.key = const_cast<png_charp>(key.c_str());
        chunk.text = const_cast<png_charp>(value.c_str());
        chunks.push_back(chunk);
    }
    return chunks;
}

/// Everything that libpng may jump out of; it owns nothing.
bool encode(png_structp png, png_infop info, const Image& image, const std::vector<png_bytep>& rows,
            const std::vector<png_text>& chunks, std::vector<char>& bytes) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_write_fn(png, &bytes, append, nothing_to_flush);
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
                 PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    if (!chunks.empty()) png_set_text(png, info, chunks.data(), static_cast<int>(chunks.size()));
    png_write_info(png, info);
    png_write_image(png, const_cast<png_bytepp>(rows.data()));
    png_write_end(png, info);
    return true;
}

}  // namespace

std::string png_bytes(const Image& image, const std::vector<std::pair<std::string, std::string>>& text) {
    HANEI_CHECK(image.width > 0 && image.height > 0);
    HANEI_CHECK(image.rgba.size() ==
                static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4);
    const std::vector<png_text> chunks = chunks_of(text);
    std::vector<png_bytep> rows;
    for (int y = 0; y < image.height; ++y) {
        const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) * 4;
        rows.push_back(const_cast<png_bytep>(image.rgba.data() + first));
    }
    std::vector<char> bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    const bool done = info != nullptr && encode(png, info, image, rows, chunks, bytes);
    png_destroy_write_struct(&png, &info);
    if (!done) throw std::runtime_error("libpng could not encode the picture");
    return {bytes.data(), bytes.size()};
}

void write_png(const Image& image, const std::filesystem::path& file,
               const std::vector<std::pair<std::string, std::string>>& text) {
    if (const auto reason = write_whole_file(file, png_bytes(image, text)))
        throw std::runtime_error(file.string() + ": " + *reason);
}

}  // namespace hanei
