#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/SimTime.h"

namespace sagara::core {

/// A light as charts abbreviate it: "Fl(2) W 15s", "Q(6)+LFl W 15s", "Iso R 4s", "F G", "Mo(A) W 8s". When it
/// is lit is a pure function of simulation time: a period begins at time zero.
class LightCharacter {
public:
    /// Nothing for a text that is none of these.
    static std::optional<LightCharacter> parse(std::string_view text);

    bool lit(core::SimTime time) const;
    double period_s() const { return static_cast<double>(m_period_us) * 1e-6; }
    const std::array<double, 3>& colour() const { return m_colour; }

private:
    struct Flash {
        std::int64_t from_us;
        std::int64_t to_us;
    };
    std::vector<Flash> m_flashes;
    std::int64_t m_period_us = 1;
    std::array<double, 3> m_colour{1.0, 1.0, 1.0};
};

}  // namespace sagara::core
