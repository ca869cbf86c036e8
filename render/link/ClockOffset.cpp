#include "render/link/ClockOffset.h"

#include <algorithm>

namespace sagara::link {

void ClockOffset::add(const Pong& pong, std::int64_t received_us) {
    const std::int64_t away_us = received_us - pong.sent_us, there_us = pong.answered_us - pong.received_us;
    if (there_us < 0 || away_us < there_us) return;
    // The mean of (t1 - t0) and (t2 - t3), each some clocks' difference, without their sum.
    const std::int64_t ahead_us = (pong.received_us - pong.sent_us) -
                                  ((pong.received_us - pong.sent_us) - (pong.answered_us - received_us)) / 2;
    m_samples[m_count++ % kWindow] = {ahead_us, away_us - there_us};
}

const ClockOffset::Sample& ClockOffset::best() const {
    const auto end = m_samples.begin() + static_cast<std::ptrdiff_t>(std::min(m_count, kWindow));
    return *std::min_element(m_samples.begin(), std::max(end, m_samples.begin() + 1),
                             [](const Sample& a, const Sample& b) { return a.delay_us < b.delay_us; });
}

std::int64_t ClockOffset::ahead_us() const { return best().ahead_us; }
std::int64_t ClockOffset::delay_us() const { return best().delay_us; }

}  // namespace sagara::link
