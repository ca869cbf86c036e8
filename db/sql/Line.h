#pragma once

#include <QString>
#include <string>
#include <string_view>

namespace sagara::db {

enum class LineFault { None, Empty, TooLong, Unreadable };

/// One line that a person typed, blanks around it dropped, and what is wrong with it: not UTF-8, control
/// characters, more characters than `longest`, or none at all.
struct Line {
    std::string text;
    LineFault fault = LineFault::None;
};
Line checkedLine(std::string_view typed, int longest_characters);

}  // namespace sagara::db
