#pragma once

#include <span>

#include "core/base/Archive.h"
#include "render/link/Messages.h"
#include "render/link/Protocol.h"

namespace sagara::link {

/// Header and payload, ready to be sent.
core::Bytes encode(const Message& message);

/// Total: any bytes give a message or a reason, never a throw and never half a message. Numbers are finite
/// and within reason, lists are bounded, enumerations known.
core::Result<Message, DecodeError> decode(Kind kind, std::span<const std::byte> payload);

}  // namespace sagara::link
