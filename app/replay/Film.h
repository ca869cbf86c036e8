#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/exercise/Recording.h"
#include "core/exercise/World.h"

namespace sagara::replay {

/// A recording opened: immutable, and shared by whoever plays it.
struct Film {
    std::filesystem::path file;
    core::Recording recording;
    std::shared_ptr<const core::World> world;
    std::vector<core::TrackSample> track;
    bool exact = false;  ///< this build can run it again to the bit
    std::string remark;  ///< what a person must know of it; empty when all is well

    std::int64_t beginTick() const { return recording.states.front().tick; }
    std::int64_t endTick() const { return recording.endTick; }
};

/// Tells how far it is, 0 to 1; false: call it off.
using KeepOn = std::function<bool(double)>;

/// Reads a recording as far as it is whole; `hulls`: where those of its ships may be. Takes seconds for one
/// of many hours. The error is for the person who chose the file; empty when it was called off.
core::Result<std::shared_ptr<const Film>, std::string> openFilm(
    const std::filesystem::path& file, const KeepOn& keepOn, std::shared_ptr<core::SeaHulls> hulls = nullptr);

}  // namespace sagara::replay
