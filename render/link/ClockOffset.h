#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "render/link/Messages.h"

namespace sagara::link {

/// How far the peer's clock is ahead of ours, from pings and pongs: ((t1 - t0) + (t2 - t3)) / 2, after RFC
/// 5905. Of the last samples the one with the least delay counts, for delay is what makes the error: at most
/// half of it. Clocks drift apart by some 50 us a second at worst, so ping at least twice a second.
class ClockOffset {
public:
    /// `received_us`: when the pong came, by our clock. A pong that answers before it was asked is dropped.
    void add(const Pong& pong, std::int64_t received_us);

    bool known() const { return m_count > 0; }
    std::int64_t ahead_us() const;  ///< peer's clock minus ours; 0 while unknown
    std::int64_t delay_us() const;  ///< round trip of the sample that counts
    std::int64_t toOurs_us(std::int64_t theirs_us) const { return theirs_us - ahead_us(); }

private:
    struct Sample {
        std::int64_t ahead_us = 0;
        std::int64_t delay_us = 0;
    };
    const Sample& best() const;
    static constexpr std::size_t kWindow = 16;
    std::array<Sample, kWindow> m_samples{};
    std::size_t m_count = 0;  ///< of all samples ever
};

}  // namespace sagara::link
