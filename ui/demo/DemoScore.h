#pragma once

#include <cstdint>

#include "core/exercise/Event.h"
#include "ui/hints/Hints.h"

namespace sagara::ui {

/// How well a visitor steered, kindly judged. No Qt.
class DemoScore final {
public:
    /// The worst that is worth a word, or else the best.
    enum class Verdict : std::uint8_t {
        TookALook,
        RanAground,
        Touched,
        LeftTheChannel,
        TooFast,
        Drifted,
        Good,
        Perfect
    };

    /// She has sailed so long as the hints see her now.
    void add(double elapsed_s, const core::Snapshot& now, const Hints& hints);
    void happened(const core::Event& event);

    int stars() const;  ///< 1 to 5
    Verdict verdict() const;
    bool spoilt() const { return m_aground || m_touched; }
    double sailed_m() const { return m_sailed_m; }

private:
    double share(double part_s) const { return m_all_s > 0.0 ? part_s / m_all_s : 0.0; }

    double m_all_s = 0.0;
    double m_inside_s = 0.0;   ///< the corridor, or no corridor to keep to
    double m_moving_s = 0.0;   ///< two knots and more
    double m_tooFast_s = 0.0;  ///< above the limit
    double m_sailed_m = 0.0;
    bool m_aground = false;
    bool m_touched = false;
};

}  // namespace sagara::ui
