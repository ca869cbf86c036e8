#include "render/scene/shape/TexturedSolid.h"

#include <png.h>

#include <algorithm>

namespace sagara::render {
namespace {

constexpr unsigned kMostPixelsAcross = 2048;
constexpr int kSameWithin = 6;  // of 255

/// libpng's simplified reading; frees what it holds.
struct PngImage {
    png_image image{};
    PngImage() { image.version = PNG_IMAGE_VERSION; }
    ~PngImage() { png_image_free(&image); }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;
};

int channel(std::uint32_t abgr, int shift) { return static_cast<int>(abgr >> shift & 0xffu); }

}  // namespace

std::optional<Paint> TextureImage::onlyColour() const {
    for (const int shift : {0, 8, 16}) {
        const auto [low, high] = std::minmax_element(
            abgr.begin(), abgr.end(),
            [&](std::uint32_t a, std::uint32_t b) { return channel(a, shift) < channel(b, shift); });
        if (low == abgr.end() || channel(*high, shift) - channel(*low, shift) > kSameWithin)
            return std::nullopt;
    }
    const std::uint32_t c = abgr.front();
    return Paint{channel(c, 0) / 255.0, channel(c, 8) / 255.0, channel(c, 16) / 255.0};
}

core::Result<TextureImage, std::string> readTexture(const std::filesystem::path& file) {
    PngImage png;
    const auto trouble = [&](const std::string& what) { return "texture " + file.string() + " " + what; };
    if (png_image_begin_read_from_file(&png.image, file.c_str()) == 0)
        return trouble("cannot be read: " + std::string(png.image.message));
    if (std::max(png.image.width, png.image.height) > kMostPixelsAcross) {
        return trouble("has " + std::to_string(png.image.width) + " x " + std::to_string(png.image.height) +
                       " pixels, expected at most " + std::to_string(kMostPixelsAcross) + " across");
    }
    png.image.format = PNG_FORMAT_RGBA;  // bytes: on a little-endian machine red is the lowest
    TextureImage texture{static_cast<int>(png.image.width), static_cast<int>(png.image.height), {}};
    texture.abgr.resize(std::size_t{png.image.width} * png.image.height);
    if (png_image_finish_read(&png.image, nullptr, texture.abgr.data(), 0, nullptr) == 0)
        return trouble("cannot be read: " + std::string(png.image.message));
    return texture;
}

}  // namespace sagara::render
