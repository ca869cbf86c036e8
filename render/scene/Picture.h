#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sagara::render {

/// A finished picture: rows from the top, four bytes a pixel in the order blue, green, red, unused. That is
/// QImage::Format_RGB32 on little-endian machines.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> bgra;

    const std::uint8_t* pixel(int x, int y) const {
        return bgra.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x));
    }
};

/// Writes a PNG file, without alpha. Returns what went wrong.
std::optional<std::string> writePng(const Picture& picture, const std::filesystem::path& path);

}  // namespace sagara::render
