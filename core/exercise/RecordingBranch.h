#pragma once

#include <span>
#include <string>

#include "core/exercise/Recording.h"

namespace sagara::core {

/// The bytes a run begins with that sails as a recorded one up to a whole second and goes another way from
/// there: the chunks of the recording up to then under a header of its own. RecordingWriter::goOn with the
/// state of that second continues them, and the whole replays from its first tick. The recording itself is
/// only read.
Result<Bytes, std::string> recordingUpTo(std::span<const std::byte> recording, const RecordingHeader& header,
                                         std::int64_t tick);

}  // namespace sagara::core
