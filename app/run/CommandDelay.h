#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/SimTime.h"

namespace sagara::run {

/// How long it takes from an order to the first frame that shows what came of it: given, carried out in a
/// tick, drawn in a frame of that moment or a later one, shown by the first channel and by the last.
class CommandDelay {
public:
    void given(std::int64_t at_us);
    bool waiting() const { return m_given_us.has_value(); }
    /// The tick the order was carried out in.
    void carriedOut(core::SimTime at) { m_carriedOut = at; }
    /// Every frame that is sent out, with the moment it shows.
    void sent(std::uint64_t frame, core::SimTime moment);
    void shown(std::uint64_t frame, std::int64_t at_us);
    void frameOver(std::uint64_t frame);

    std::size_t count() const { return m_delays_us.size(); }
    /// "12 orders, seen on all channels after 71 ms, p95 90, most 95"
    std::string text() const;

private:
    std::optional<std::int64_t> m_given_us;
    std::optional<core::SimTime> m_carriedOut;
    std::optional<std::uint64_t> m_frame;  ///< the first that shows it
    std::int64_t m_lastShown_us = 0;
    std::vector<std::int64_t> m_delays_us;
};

}  // namespace sagara::run
