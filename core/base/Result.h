#pragma once

#include <cassert>
#include <utility>
#include <variant>

namespace sagara::core {

/// A value, or the reason there is none. For errors of files, packets and people; never for broken
/// preconditions (assert) or a failing machine (exception of the module).
template <typename T, typename E>
class [[nodiscard]] Result {
public:
    Result(T value)
        : m_content(std::in_place_index<0>, std::move(value)) {}  // NOLINT: `return value;` is the use
    Result(E error)
        : m_content(std::in_place_index<1>, std::move(error)) {}  // NOLINT: `return error;` is the use

    explicit operator bool() const { return m_content.index() == 0; }

    const T& value() const& {
        assert(m_content.index() == 0);
        return std::get<0>(m_content);
    }
    T&& value() && {
        assert(m_content.index() == 0);
        return std::get<0>(std::move(m_content));
    }
    const E& error() const {
        assert(m_content.index() == 1);
        return std::get<1>(m_content);
    }
    const T& operator*() const& { return value(); }
    const T* operator->() const { return &value(); }

private:
    std::variant<T, E> m_content;
};

}  // namespace sagara::core
