#pragma once

#include "render/scene/sea/SeaTiles.h"

namespace sagara::render {

template <typename T>
MipChain<T> emptyChain(int size) {
    MipChain<T> chain;
    for (; size >= kSmallestMip; size /= 2) {
        chain.sizes.push_back(size);
        chain.levels.emplace_back(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    }
    return chain;
}

inline float meanOf(float a, float b, float c, float d) { return 0.25f * ((a + b) + (c + d)); }
/// Of four bytes at a time, rounded.
inline std::uint32_t meanOf(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    constexpr std::uint32_t kEven = 0x00ff00ffu, kHalf = 0x00020002u;
    const std::uint32_t even = (a & kEven) + (b & kEven) + (c & kEven) + (d & kEven) + kHalf;
    const std::uint32_t odd =
        ((a >> 8) & kEven) + ((b >> 8) & kEven) + ((c >> 8) & kEven) + ((d >> 8) & kEven) + kHalf;
    return ((even >> 2) & kEven) | (((odd >> 2) & kEven) << 8);
}

/// Every level from the one before: the mean of four.
template <typename T>
void halveAll(MipChain<T>& chain) {
    for (std::size_t n = 1; n < chain.levels.size(); ++n) {
        const auto& from = chain.levels[n - 1];
        const auto width = static_cast<std::size_t>(chain.sizes[n - 1]);
        std::size_t out = 0;
        for (std::size_t row = 0; row < width; row += 2) {
            for (std::size_t column = 0; column < width; column += 2) {
                const std::size_t i = row * width + column;
                chain.levels[n][out++] = meanOf(from[i], from[i + 1], from[i + width], from[i + width + 1]);
            }
        }
    }
}

}  // namespace sagara::render
