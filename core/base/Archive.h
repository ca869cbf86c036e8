#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "core/base/Hash.h"

/// The one binary archive: `State`, recordings and everything inside them. Little-endian, no padding,
/// versioned by whoever writes the outermost block. A type joins by a static `fields(archive, self)` that
/// lists its members once, for writing and for reading.
namespace sagara::core {

static_assert(std::endian::native == std::endian::little, "the archive writes native bytes");

using Bytes = std::vector<std::byte>;

namespace detail {
template <typename T>
concept Scalar =
    std::is_arithmetic_v<T> || std::is_enum_v<T>;  // std::byte is an enumeration; vector<bool> is not used
}

/// Sink is called with a span of bytes.
template <typename Sink>
class ArchiveWriter {
public:
    explicit ArchiveWriter(Sink sink) : m_sink(std::move(sink)) {}

    template <typename... T>
    void operator()(const T&... values) {
        (write(values), ...);
    }

private:
    template <typename T>
    void write(const T& value) {
        if constexpr (detail::Scalar<T>) {
            m_sink(std::as_bytes(std::span(&value, 1)));
        } else {
            T::fields(*this, value);
        }
    }
    void write(const std::string& text) {
        write(static_cast<std::uint32_t>(text.size()));
        m_sink(std::as_bytes(std::span(text)));
    }
    template <typename T>
    void write(const std::vector<T>& list) {
        write(static_cast<std::uint32_t>(list.size()));
        if constexpr (detail::Scalar<T>) {
            m_sink(std::as_bytes(std::span(list)));
        } else {
            for (const T& item : list) write(item);
        }
    }
    template <typename T, std::size_t N>
    void write(const std::array<T, N>& list) {
        for (const T& item : list) write(item);
    }
    template <typename T>
    void write(const std::optional<T>& value) {
        write(value.has_value());
        if (value) write(*value);
    }
    template <typename... T>
    void write(const std::variant<T...>& value) {
        write(static_cast<std::uint8_t>(value.index()));
        std::visit([this](const auto& held) { write(held); }, value);
    }

    Sink m_sink;
};

/// Total: any bytes give values or `ok() == false`, never a throw and never a huge allocation. After the
/// first failure everything reads as zero or empty.
class ArchiveReader {
public:
    explicit ArchiveReader(std::span<const std::byte> bytes) : m_rest(bytes) {}

    template <typename... T>
    void operator()(T&... values) {
        (read(values), ...);
    }

    bool ok() const { return m_ok; }
    bool atEnd() const { return m_rest.empty(); }
    std::size_t remaining_bytes() const { return m_rest.size(); }
    /// For a reader of a field with a narrower range than its type.
    void fail() { m_ok = false; }

private:
    template <typename T>
    void read(T& value) {
        if constexpr (std::is_same_v<T, bool>) {
            std::uint8_t byte = 0;
            read(byte);
            if (byte > 1) fail();
            value = byte == 1;
        } else if constexpr (detail::Scalar<T>) {
            value = T{};
            if (!take(sizeof value)) return;
            std::memcpy(&value, m_rest.data(), sizeof value);
            m_rest = m_rest.subspan(sizeof value);
        } else {
            T::fields(*this, value);
        }
    }
    void read(std::string& text) {
        text.clear();
        const std::uint32_t size = readSize(1);
        text.resize(size);
        if (size > 0) std::memcpy(text.data(), m_rest.data(), size);
        m_rest = m_rest.subspan(size);
    }
    template <typename T>
    void read(std::vector<T>& list) {
        list.clear();
        if constexpr (detail::Scalar<T>) {
            const std::uint32_t size = readSize(sizeof(T));
            list.resize(size);
            if (size > 0) std::memcpy(list.data(), m_rest.data(), size * sizeof(T));
            m_rest = m_rest.subspan(size * sizeof(T));
        } else {
            const std::uint32_t size = readSize(1);  // every item takes a byte at least
            for (std::uint32_t i = 0; i < size && m_ok; ++i) read(list.emplace_back());
            if (!m_ok) list.clear();
        }
    }
    template <typename T, std::size_t N>
    void read(std::array<T, N>& list) {
        for (T& item : list) read(item);
    }
    template <typename T>
    void read(std::optional<T>& value) {
        bool present = false;
        read(present);
        value.reset();
        if (present && m_ok) read(value.emplace());
    }
    template <typename... T>
    void read(std::variant<T...>& value) {
        std::uint8_t index = 0;
        read(index);
        if (index >= sizeof...(T)) fail();
        if (m_ok) readAlternative<0>(index, value);
    }
    template <std::size_t I, typename... T>
    void readAlternative(std::size_t index, std::variant<T...>& value) {
        if constexpr (I < sizeof...(T)) {
            if (index != I) return readAlternative<I + 1>(index, value);
            read(value.template emplace<I>());
        }
    }
    std::uint32_t readSize(std::size_t itemBytes) {
        std::uint32_t size = 0;
        read(size);
        return take(static_cast<std::size_t>(size) * itemBytes) ? size : 0;
    }
    bool take(std::size_t bytes) {
        if (bytes > m_rest.size()) fail();
        return m_ok;
    }

    std::span<const std::byte> m_rest;
    bool m_ok = true;
};

void append(Bytes& bytes, std::span<const std::byte> piece);

template <typename T>
void appendTo(Bytes& bytes, const T& value) {
    ArchiveWriter writer([&bytes](std::span<const std::byte> piece) { append(bytes, piece); });
    writer(value);
}

template <typename T>
Bytes toBytes(const T& value) {
    Bytes bytes;
    appendTo(bytes, value);
    return bytes;
}

/// Same as hashing `toBytes(value)`, without the copy.
template <typename T>
std::uint64_t archiveHash(const T& value) {
    Hash64 hash;
    ArchiveWriter writer([&hash](std::span<const std::byte> piece) { hash.add(piece); });
    writer(value);
    return hash.value();
}

/// The whole of `bytes`, or nothing: left-over bytes are damage too.
template <typename T>
std::optional<T> fromBytes(std::span<const std::byte> bytes) {
    std::optional<T> value(std::in_place);
    ArchiveReader reader(bytes);
    reader(*value);
    if (!reader.ok() || !reader.atEnd()) value.reset();
    return value;
}

}  // namespace sagara::core
