#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "core/exercise/World.h"
#include "render/link/Messages.h"
#include "render/wall/FrameBarrier.h"
#include "render/wall/Layout.h"

namespace sagara::wall {

/// What is to be drawn: asked for when a frame is due.
struct Moment {
    core::SimTime time;
    core::Snapshot snapshot;
};
using MomentSource = std::function<Moment()>;

struct WallOptions {
    bool everywhere = false;  ///< listen to other PCs too; needs a token
    std::uint16_t port = 0;   ///< 0: any
    std::string token;        ///< of link::kShortestToken characters or more, or empty on loopback
    double rate_Hz = 60.0;    ///< frames a second at most; 0: as fast as the channels draw
    BarrierRules rules;
};

/// What becomes known about a running wall. Called from the event loop of the server; none of these may
/// destroy it.
class WallObserver {
public:
    virtual ~WallObserver() = default;
    virtual void inStep(const std::string& /*channel*/) {}
    virtual void lost(const std::string& /*channel*/, const std::string& /*reason*/) {}
    /// The channel was disconnected because it hangs: restart its program if it is ours.
    virtual void hangs(const std::string& /*channel*/, const std::string& /*reason*/) {}
    virtual void shown(const std::string& /*channel*/, std::uint64_t /*frame*/, std::int64_t /*at_us*/) {}
    /// `spread_us`: from the first to the last channel that showed it.
    virtual void frameOver(std::uint64_t /*frame*/, std::int64_t /*spread_us*/) {}
    virtual void picture(const std::string& /*channel*/, const link::Picture& /*picture*/) {}
    /// Anything else worth a line.
    virtual void note(const std::string& /*message*/) {}
};

/// The station's side of a wall: takes channels in, sends them frames in step. Belongs to a thread with a Qt
/// event loop and works from there. The rules are FrameBarrier's; here are the sockets.
class WallServer {
public:
    WallServer(Layout layout, WallOptions options, std::shared_ptr<const core::World> world,
               MomentSource source, WallObserver& observer);
    ~WallServer();

    /// The port, or why not, for people.
    core::Result<std::uint16_t, std::string> listen();
    /// Says goodbye to all and takes nobody in any more.
    void stop(const std::string& reason);

    /// Asks every channel in step for its picture of the next frame.
    void askForPictures();
    /// Cuts the connection, as if the cable had been pulled.
    void cut(const std::string& channel);

    std::vector<ChannelStatus> status() const;
    std::uint64_t frame() const;

private:
    class Impl;
    std::unique_ptr<Impl> m_impl;
};

}  // namespace sagara::wall
