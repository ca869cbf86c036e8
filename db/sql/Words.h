#pragma once

#include <optional>
#include <string_view>
#include <utility>

namespace sagara::db {

/// One value of an enumeration and its word, the same in the database, in JSON and on the command line.
template <typename E>
using Word = std::pair<E, std::string_view>;

template <typename E, std::size_t n>
constexpr std::string_view wordOf(const Word<E> (&words)[n], E value) {
    for (const Word<E>& word : words) {
        if (word.first == value) return word.second;
    }
    return {};
}

template <typename E, std::size_t n>
constexpr std::optional<E> valueOf(const Word<E> (&words)[n], std::string_view text) {
    for (const Word<E>& word : words) {
        if (word.second == text) return word.first;
    }
    return std::nullopt;
}

}  // namespace sagara::db
