#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/exercise/Recording.h"

namespace sagara::run {

/// A run that was broken off, as far as its recording is whole: to be gone on with from there.
struct TakenUp {
    std::shared_ptr<const core::World> world;
    core::State state;  ///< at the last whole second
    core::RecordingHeader header;
    std::vector<core::Event> events;  ///< so far
    std::vector<core::TrackSample> track;
    std::size_t whole_bytes = 0;  ///< of the file that are kept
    std::size_t lost_bytes = 0;   ///< after these
    std::string damage;           ///< what the reader says of the end
};

/// Fails, with a message that names the file, when it cannot be read, when the run has ended, or when it is
/// of another build.
core::Result<TakenUp, std::string> takeUp(const std::filesystem::path& recording,
                                          std::shared_ptr<core::SeaHulls> hulls);

/// A run in this world that goes back to a whole second it has sailed, whether it has ended or not.
struct SetBack {
    TakenUp run;
    core::Bytes recording;  ///< up to then
};
core::Result<SetBack, std::string> takeUpAt(std::shared_ptr<const core::World> world,
                                            const std::filesystem::path& recording, std::int64_t tick);

}  // namespace sagara::run
