#include "ui/input/Calibration.h"

#include <algorithm>
#include <cmath>

namespace sagara::ui {
namespace {

/// Smallest movement that counts: a fifth of a degree of a 35 degree rudder.
constexpr double kFlicker = 0.006;

}  // namespace

bool usable(const AxisCalibration& c) {
    for (const double value : {c.least, c.centre, c.most, c.deadZone})
        if (!std::isfinite(value)) return false;
    return c.least >= -1.0 && c.most <= 1.0 && c.deadZone >= 0.0 && c.deadZone <= kMostDeadZone &&
           c.centre - c.least >= kLeastTravel && c.most - c.centre >= kLeastTravel;
}

double calibrated(const AxisCalibration& c, double raw) {
    const double way = raw >= c.centre ? c.most - c.centre : c.centre - c.least;
    const double value = std::clamp((raw - c.centre) / way, -1.0, 1.0);
    const double beyond = std::max(0.0, std::abs(value) - c.deadZone) / (1.0 - c.deadZone);
    if (beyond <= 0.0) return 0.0;
    return (value > 0.0) == c.inverted ? -beyond : beyond;
}

void CalibrationRun::feed(double raw) {
    m_last = raw;
    if (m_step != Step::Ends) return;
    m_found.least = std::min(m_found.least, raw);
    m_found.most = std::max(m_found.most, raw);
}

bool CalibrationRun::mayGoOn() const {
    if (m_step == Step::Middle) return m_last.has_value();
    return m_step == Step::Ends && usable(m_found);
}

void CalibrationRun::next() {
    if (!mayGoOn()) return;
    if (m_step == Step::Middle) {
        m_found.least = m_found.centre = m_found.most = *m_last;
        m_step = Step::Ends;
    } else {
        m_step = Step::Done;
    }
}

std::optional<double> AxisGate::moved(double value) {
    if (!m_last) {
        m_last = value;
        return std::nullopt;
    }
    const bool exact = value == 0.0 || std::abs(value) == 1.0;  // the middle and the ends are reached
    if (value == *m_last || (!exact && std::abs(value - *m_last) < kFlicker)) return std::nullopt;
    m_last = value;
    return value;
}

}  // namespace sagara::ui
