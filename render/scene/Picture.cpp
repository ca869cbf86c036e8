#include "render/scene/Picture.h"

#include <zlib.h>

#include <array>
#include <fstream>
#include <string_view>

namespace sagara::render {
namespace {

void append(std::string& out, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<char>((value >> shift) & 0xff));
}

void appendChunk(std::string& out, std::string_view type, std::string_view data) {
    append(out, static_cast<std::uint32_t>(data.size()));
    const std::size_t from = out.size();
    out += type;
    out += data;
    append(out, static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(out.data() + from),
                                                 static_cast<uInt>(out.size() - from))));
}

/// Rows as PNG wants them: a filter byte (none), then red, green, blue.
std::string rows(const Picture& p) {
    std::string raw;
    raw.reserve(static_cast<std::size_t>(p.height) * (3 * static_cast<std::size_t>(p.width) + 1));
    for (int y = 0; y < p.height; ++y) {
        raw.push_back('\0');
        for (int x = 0; x < p.width; ++x) {
            const std::uint8_t* bgra = p.pixel(x, y);
            for (int channel = 2; channel >= 0; --channel) raw.push_back(static_cast<char>(bgra[channel]));
        }
    }
    return raw;
}

}  // namespace

std::optional<std::string> writePng(const Picture& picture, const std::filesystem::path& path) {
    const std::string raw = rows(picture);
    uLongf size = compressBound(raw.size());
    std::string packed(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(raw.data()),
                  raw.size(), 3) != Z_OK)
        return path.string() + " cannot be compressed";
    packed.resize(size);

    std::string head;
    append(head, static_cast<std::uint32_t>(picture.width));
    append(head, static_cast<std::uint32_t>(picture.height));
    head += std::string_view("\x08\x02\x00\x00\x00", 5);  // 8 bits, RGB
    std::string file("\x89PNG\r\n\x1a\n");
    appendChunk(file, "IHDR", head);
    appendChunk(file, "IDAT", packed);
    appendChunk(file, "IEND", "");
    std::ofstream out(path, std::ios::binary);
    out.write(file.data(), static_cast<std::streamsize>(file.size()));
    if (!out) return path.string() + " cannot be written";
    return std::nullopt;
}

}  // namespace sagara::render
