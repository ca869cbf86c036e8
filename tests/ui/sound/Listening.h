#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "ui/sound/Synthesis.h"

/// What the ear would notice, in numbers.
namespace sagara::test {

inline double loudness(const std::vector<float>& s) {
    double sum = 0.0;
    for (const float x : s) sum += static_cast<double>(x) * static_cast<double>(x);
    return s.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(s.size()));
}
inline double peak(const std::vector<float>& s) {
    double most = 0.0;
    for (const float x : s) most = std::max(most, static_cast<double>(std::abs(x)));
    return most;
}
inline double largestStep(const std::vector<float>& s) {
    double most = 0.0;
    for (std::size_t i = 1; i < s.size(); ++i)
        most = std::max(most, static_cast<double>(std::abs(s[i] - s[i - 1])));
    return most;
}
/// Amplitude at one frequency (Goertzel).
inline double at(const std::vector<float>& s, double frequency_Hz) {
    std::complex<double> sum;
    const double w = 2.0 * std::numbers::pi * frequency_Hz / ui::kSampleRate_Hz;
    for (std::size_t i = 0; i < s.size(); ++i)
        sum += static_cast<double>(s[i]) * std::polar(1.0, -w * static_cast<double>(i));
    return 2.0 * std::abs(sum) / static_cast<double>(s.size());
}
/// Where half the power lies below, roughly: zero crossings a second over two.
inline double crossings_Hz(const std::vector<float>& s) {
    std::size_t count = 0;
    for (std::size_t i = 1; i < s.size(); ++i) count += (s[i] > 0.0F) != (s[i - 1] > 0.0F) ? 1 : 0;
    return 0.5 * static_cast<double>(count) * ui::kSampleRate_Hz / static_cast<double>(s.size());
}
/// So many seconds in blocks, as a player asks for them.
template <typename Fill>
std::vector<float> seconds(double length_s, Fill&& fill, std::size_t block = 1024) {
    std::vector<float> all(static_cast<std::size_t>(length_s * ui::kSampleRate_Hz));
    for (std::size_t from = 0; from < all.size(); from += block)
        fill(ui::Samples(all).subspan(from, std::min(block, all.size() - from)));
    return all;
}

}  // namespace sagara::test
