#include "PngReader.h"

#include <zlib.h>

#include <fstream>
#include <iterator>
#include <string>

namespace sagara::render {
namespace {

std::uint32_t number(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[i]);
    return value;
}

}  // namespace

std::optional<Picture> readOwnPng(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    const std::string file{std::istreambuf_iterator<char>(in), {}};
    constexpr std::size_t kHead = 8, kHeader = 25;  // signature; IHDR with length, type, checksum
    if (file.size() < kHead + kHeader + 12) return std::nullopt;
    Picture p;
    p.width = static_cast<int>(number(file, kHead + 8));
    p.height = static_cast<int>(number(file, kHead + 12));
    const std::size_t packed = number(file, kHead + kHeader), at = kHead + kHeader + 8;
    const auto width = static_cast<std::size_t>(p.width), height = static_cast<std::size_t>(p.height);
    if (width > 8192 || height > 8192 || file.size() < at + packed) return std::nullopt;
    std::string raw(height * (3 * width + 1), '\0');
    uLongf size = raw.size();
    if (uncompress(reinterpret_cast<Bytef*>(raw.data()), &size,
                   reinterpret_cast<const Bytef*>(file.data() + at), packed) != Z_OK ||
        size != raw.size())
        return std::nullopt;
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const auto* rgb = reinterpret_cast<const std::uint8_t*>(&raw[y * (3 * width + 1) + 1 + 3 * x]);
            for (const std::uint8_t byte : {rgb[2], rgb[1], rgb[0], std::uint8_t{255}})
                p.bgra.push_back(byte);
        }
    }
    return p;
}

}  // namespace sagara::render
