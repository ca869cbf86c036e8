#pragma once

#include <string>

#include "core/base/Result.h"

namespace sagara::link {

/// Why bytes are no message. The reason is for people.
struct DecodeError {
    std::string reason;
    bool otherVersion = false;  ///< the peer speaks another protocol version; say which are spoken here
};

}  // namespace sagara::link
