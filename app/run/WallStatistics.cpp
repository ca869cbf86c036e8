#include "app/run/WallStatistics.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/run/Quantile.h"

namespace sagara::run {
namespace {

std::string times(int count) {
    return count == 0 ? "never" : count == 1 ? "once" : std::to_string(count) + " times";
}

}  // namespace

void WallStatistics::shown(const std::string& channel, std::uint64_t frame, std::int64_t at_us) {
    Channel& c = m_channels[channel];
    if (c.last + 1 == frame) c.longest_us = std::max(c.longest_us, at_us - c.lastAt_us);
    c.last = frame;
    c.lastAt_us = at_us;
    if (frame <= m_frame) return;  // another channel was first
    if (m_frames == 0) m_firstAt_us = at_us;
    if (m_frames > 0) m_intervals_us.push_back(at_us - m_lastAt_us);
    ++m_frames;
    m_frame = frame;
    m_lastAt_us = at_us;
}

double WallStatistics::rate_Hz() const {
    const double span_s = 1e-6 * static_cast<double>(m_lastAt_us - m_firstAt_us);
    return span_s > 0.0 ? static_cast<double>(m_frames - 1) / span_s : 0.0;
}

std::string WallStatistics::text() const {
    return fmt::format(
        "{:.1f} frames/s ({} frames in {:.1f} s), every {:.1f} ms, p95 {:.1f}, p99 {:.1f}, longest {:.1f}; "
        "channels apart by {:.1f} ms, p95 {:.1f}, most {:.1f}",
        rate_Hz(), m_frames, 1e-6 * static_cast<double>(m_lastAt_us - m_firstAt_us),
        quantile_ms(m_intervals_us, 0.5), quantile_ms(m_intervals_us, 0.95),
        quantile_ms(m_intervals_us, 0.99), quantile_ms(m_intervals_us, 1.0), quantile_ms(m_spreads_us, 0.5),
        quantile_ms(m_spreads_us, 0.95), quantile_ms(m_spreads_us, 1.0));
}

std::string WallStatistics::textOf(const wall::ChannelStatus& s) const {
    const auto found = m_channels.find(s.name);
    const std::int64_t longest_us = found == m_channels.end() ? 0 : found->second.longest_us;
    return fmt::format(
        "{}: {}, frame {}, drawn in {:.1f} ms, {:.1f} ms after the first; frames left out: {} of {}, told to "
        "show "
        "but not heard of: {}, longest wait {:.0f} ms; lost {}{}",
        s.name, wall::channelStateName(s.state), s.frame, 1e-3 * static_cast<double>(s.took_us),
        1e-3 * static_cast<double>(s.skew_us), s.framesMissed, s.framesShown + s.framesMissed, s.framesUntold,
        1e-3 * static_cast<double>(longest_us), times(s.timesLost),
        s.reason.empty() ? "" : " (" + s.reason + ")");
}

}  // namespace sagara::run
