#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace sagara::core {

/// How many bytes of a recording hold the run up to a tick, which is a whole second: what a run that goes
/// back to that second keeps, to be gone on with by RecordingWriter::goOn. None when the bytes are no
/// recording or do not reach that second.
std::optional<std::size_t> bytesUpTo(std::span<const std::byte> recording, std::int64_t tick);

}  // namespace sagara::core
