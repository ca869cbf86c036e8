#include "core/base/Hash.h"

namespace sagara::core {

std::string toHex(std::uint64_t value) {
    std::string digits(16, '0');
    for (std::size_t i = 0; i < 16; ++i) digits[15 - i] = "0123456789abcdef"[(value >> (4 * i)) & 0xF];
    return digits;
}

}  // namespace sagara::core
