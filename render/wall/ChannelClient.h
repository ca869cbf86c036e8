#pragma once

#include <functional>

#include "render/link/Handshake.h"
#include "render/wall/FrameRenderer.h"

namespace sagara::wall {

/// Where the station is and who this channel is.
struct ChannelOptions {
    std::string host = "127.0.0.1";
    std::uint16_t port = 0;
    link::Introduction who;
    /// How long it tries to find the station, at first and again after the connection was lost.
    double patience_s = 5.0;
};

/// How a channel ended.
struct ChannelEnd {
    bool failed = false;
    std::string reason;  ///< for people
};

/// One channel of a wall, view side: connects, builds the world it is sent, draws and shows in step until the
/// station says goodbye, is gone for good, or the window is closed. Blocks; needs no event loop. `tell` gets
/// messages for people.
ChannelEnd runChannel(const ChannelOptions& options, FrameRenderer& renderer,
                      const std::function<void(const std::string&)>& tell);

/// Whether every ship and target of the frame is one of this world.
bool fits(const core::Snapshot& snapshot, const core::World& world);

}  // namespace sagara::wall
