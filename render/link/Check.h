#pragma once

#include <cmath>
#include <cstddef>
#include <string>

namespace sagara::link {

/// Guards the numbers of one message while it is decoded. Notes the first thing wrong and hands out harmless
/// values, so that decoding reads like copying.
class Check {
public:
    /// Finite and not beyond `limit` either way. The default is far beyond any place, force or time of an
    /// exercise and still squares without overflow.
    double number(double value, const char* what, double limit = 1e9) {
        return between(value, -limit, limit, what);
    }
    double between(double value, double low, double high, const char* what) {
        if (value >= low && value <= high) return value;  // false for NaN
        refuse(std::string(what) + " is " + std::to_string(value));
        return low > 0.0 ? low : 0.0;
    }
    /// The length of a list, or 0 when it is too long.
    int count(int length, std::size_t most, const char* what) {
        if (length >= 0 && static_cast<std::size_t>(length) <= most) return length;
        refuse(std::to_string(length) + " " + what + ", at most " + std::to_string(most) + " are accepted");
        return 0;
    }
    std::uint32_t whole(std::uint32_t value, std::uint32_t low, std::uint32_t high, const char* what) {
        if (value >= low && value <= high) return value;
        refuse(std::string(what) + " is " + std::to_string(value));
        return low;
    }
    template <typename Enum>
    Enum choice(std::uint32_t value, Enum last, const char* what) {
        return static_cast<Enum>(whole(value, 0, static_cast<std::uint32_t>(last), what));
    }
    /// Control characters become blanks: the text may be printed to a terminal.
    std::string text(std::string value, std::size_t most_bytes, const char* what) {
        if (value.size() <= most_bytes) {
            for (char& c : value) {
                if ((c >= 0 && c < ' ') || c == 127) c = ' ';
            }
            return value;
        }
        refuse(std::string(what) + " of " + std::to_string(value.size()) + " bytes");
        return {};
    }
    void refuse(std::string reason) {
        if (m_reason.empty()) m_reason = std::move(reason);
    }
    bool sound() const { return m_reason.empty(); }
    const std::string& reason() const { return m_reason; }

private:
    std::string m_reason;
};

}  // namespace sagara::link
