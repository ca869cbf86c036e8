#pragma once

#include <span>
#include <string>

#include "core/exercise/Recording.h"
#include "core/exercise/Track.h"

namespace sagara::core {

/// The bytes a run begins with that sails as a recorded one up to a whole second and goes another way from
/// there: the chunks of the recording up to then under a header of its own. RecordingWriter::goOn with the
/// state of that second continues them, and the whole replays from its first tick. The recording itself is
/// only read.
Result<Bytes, std::string> recordingUpTo(std::span<const std::byte> recording, const RecordingHeader& header,
                                         std::int64_t tick);

/// The kinematic track of a recording that is being written, from the chunks as the writer hands them on.
/// Targets that are added in the run are left out.
class GrowingTrack {
public:
    GrowingTrack(std::size_t ships, std::size_t targets) : m_ships(ships), m_targets(targets) {}
    /// Whole chunks only; what is not one of a second or a state changes nothing.
    void take(std::span<const std::byte> chunk);
    const std::vector<TrackSample>& track() const { return m_track; }

private:
    std::size_t m_ships;
    std::size_t m_targets;
    TrackCodec m_codec;
    std::vector<TrackSample> m_track;
};

}  // namespace sagara::core
