#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "render/wall/FrameBarrier.h"

namespace sagara::run {

/// How evenly and how much together a wall showed its frames.
class WallStatistics {
public:
    /// As told by a channel; by the station's clock.
    void shown(const std::string& channel, std::uint64_t frame, std::int64_t at_us);
    void frameOver(std::int64_t spread_us) { m_spreads_us.push_back(spread_us); }

    std::size_t frames() const { return m_frames; }
    double rate_Hz() const;
    /// "25.0 frames/s (250 frames in 10.0 s), every 40.0 ms, p95 44.1, p99 51.0, longest 80.2; channels apart
    /// by 0.3 ms, p95 2.1, most 5.0"
    std::string text() const;
    /// A line for a channel: "port: in step, frame 250, drawn in 31.0 ms, 0.4 ms after the first; frames left
    /// out: 0 of 250, longest wait 80 ms; lost once (was killed)".
    std::string textOf(const wall::ChannelStatus& status) const;

private:
    struct Channel {
        std::uint64_t last = 0;
        std::int64_t lastAt_us = 0;
        std::int64_t longest_us = 0;  ///< between two frames in a row
    };
    std::map<std::string, Channel> m_channels;
    std::vector<std::int64_t> m_intervals_us;  ///< between the first shows of frames in a row
    std::vector<std::int64_t> m_spreads_us;
    std::size_t m_frames = 0;
    std::uint64_t m_frame = 0;
    std::int64_t m_firstAt_us = 0;
    std::int64_t m_lastAt_us = 0;
};

}  // namespace sagara::run
