#include "app/run/CommandDelay.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/run/Quantile.h"

namespace sagara::run {

void CommandDelay::given(std::int64_t at_us) {
    m_given_us = at_us;
    m_carriedOut.reset();
    m_frame.reset();
    m_lastShown_us = 0;
}

void CommandDelay::sent(std::uint64_t frame, core::SimTime moment) {
    if (m_given_us && m_carriedOut && !m_frame && moment >= *m_carriedOut) m_frame = frame;
}

void CommandDelay::shown(std::uint64_t frame, std::int64_t at_us) {
    if (m_frame == frame) m_lastShown_us = std::max(m_lastShown_us, at_us);
}

void CommandDelay::frameOver(std::uint64_t frame) {
    if (!m_given_us || m_frame != frame) return;
    if (m_lastShown_us > 0) m_delays_us.push_back(m_lastShown_us - *m_given_us);
    m_given_us.reset();
}

std::string CommandDelay::text() const {
    return fmt::format("{} orders, seen on all channels after {:.0f} ms, p95 {:.0f}, most {:.0f}", count(),
                       quantile_ms(m_delays_us, 0.5), quantile_ms(m_delays_us, 0.95),
                       quantile_ms(m_delays_us, 1.0));
}

}  // namespace sagara::run
