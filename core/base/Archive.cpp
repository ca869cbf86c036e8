#include "core/base/Archive.h"

namespace sagara::core {

void append(Bytes& bytes, std::span<const std::byte> piece) {
    bytes.insert(bytes.end(), piece.begin(), piece.end());
}

}  // namespace sagara::core
