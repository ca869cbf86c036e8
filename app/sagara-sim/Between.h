#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <string>

namespace sagara::sim {

/// A number from least to most. CLI11 lets NaN pass, and takes a seed of -1 for another one.
template <typename T>
CLI::Validator between(T least, T most) {
    const std::string accepted = fmt::format("{} to {}", least, most);
    return {[=](std::string& text) {
                T value{};
                const char* end = text.data() + text.size();
                const auto [stop, error] = std::from_chars(text.data(), end, value);
                const bool good = error == std::errc() && stop == end && value >= least && value <= most;
                return good ? std::string() : "is " + text + ", expected " + accepted;
            },
            accepted};
}

inline constexpr double kLongest_s = 7.0 * 86400.0;

}  // namespace sagara::sim
