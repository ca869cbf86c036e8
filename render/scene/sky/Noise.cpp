#include "render/scene/sky/Noise.h"

#include <algorithm>
#include <cmath>

#include "core/base/Random.h"

namespace sagara::render {
namespace {

/// One octave: random values on a lattice of `cells` a side, smoothly between.
std::vector<double> octave(int size, int cells, core::Random& random) {
    std::vector<double> lattice(static_cast<std::size_t>(cells * cells));
    for (double& v : lattice) v = random.uniform();
    const auto at = [&](int row, int column) {
        return lattice[static_cast<std::size_t>((row % cells) * cells + column % cells)];
    };
    std::vector<double> out;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double u = static_cast<double>(x) * cells / size, v = static_cast<double>(y) * cells / size;
            const int i = static_cast<int>(u), j = static_cast<int>(v);
            const auto smooth = [](double f) { return f * f * (3.0 - 2.0 * f); };
            const double fu = smooth(u - i), fv = smooth(v - j);
            out.push_back((1 - fv) * ((1 - fu) * at(j, i) + fu * at(j, i + 1)) +
                          fv * ((1 - fu) * at(j + 1, i) + fu * at(j + 1, i + 1)));
        }
    }
    return out;
}

}  // namespace

std::vector<std::uint32_t> cloudNoise(int size) {
    core::Random random(20270115);
    std::vector<double> sum(static_cast<std::size_t>(size * size), 0.0);
    double weight = 1.0;
    for (int cells = 4; cells <= 64; cells *= 2, weight *= 0.52) {
        const std::vector<double> one = octave(size, cells, random);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * one[i];
    }
    const auto [low, high] = std::minmax_element(sum.begin(), sum.end());
    std::vector<std::uint32_t> pixels;
    for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
            const auto at = [&](int r, int c) {
                return sum[static_cast<std::size_t>((r % size) * size + c % size)];
            };
            // Once more three times as fine, from elsewhere: it tears the edges, and saves the sky a second
            // look.
            const double v = 0.68 * at(row, column) + 0.32 * at(3 * row + size / 6, 3 * column + size / 3);
            const auto grey = static_cast<std::uint32_t>(std::lround(255.0 * (v - *low) / (*high - *low)));
            pixels.push_back(grey | grey << 8 | grey << 16 | 0xff000000u);
        }
    }
    return pixels;
}

}  // namespace sagara::render
