#include "core/identify/TrialMisfit.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

constexpr double kPosition_L = 0.02, kSpeed = 0.02, kYaw = 0.02;
constexpr double kHeading_rad = 1.0 * kDegree_rad, kRoll_rad = 0.5 * kDegree_rad,
                 kRudder_rad = 0.5 * kDegree_rad;

/// Trials whose rows are steady states, not moments of one run.
bool isOfSteadyRows(TrialKind kind) { return kind == TrialKind::Speed || kind == TrialKind::Spiral; }

double valueOf(const ShipMotion& m, Channel c) {
    switch (c) {
        case Channel::North:
            return m.north_m;
        case Channel::East:
            return m.east_m;
        case Channel::Heading:
            return m.heading_rad;
        case Channel::Surge:
            return m.surge_mps;
        case Channel::Sway:
            return m.sway_mps;
        case Channel::Speed:
            return std::hypot(m.surge_mps, m.sway_mps);
        case Channel::YawRate:
            return m.yawRate_radps;
        default:
            return m.roll_rad;
    }
}

}  // namespace

TrialMisfit::TrialMisfit(const SeaTrial& trial, double length_m) : m_trial(trial) {
    const double U_mps = std::max(approachOf_mps(trial), length_m / lengthTime_s(trial, length_m));
    const double yaw_radps = kYaw * U_mps / length_m;
    if (trial.kind == TrialKind::Speed)
        m_watched = {{trial.has(Channel::Speed) ? Channel::Speed : Channel::Surge, kSpeed * U_mps}};
    else if (trial.kind == TrialKind::Spiral)
        m_watched = {{Channel::Rudder, kRudder_rad}};
    else
        m_watched = {{Channel::North, kPosition_L * length_m},
                     {Channel::East, kPosition_L * length_m},
                     {Channel::Heading, kHeading_rad},
                     {Channel::Surge, kSpeed * U_mps},
                     {Channel::Sway, kSpeed * U_mps},
                     {Channel::Speed, kSpeed * U_mps},
                     {Channel::YawRate, yaw_radps},
                     {Channel::Roll, kRoll_rad}};
    for (const Watched& w : m_watched) {
        const auto& column = trial[w.channel];
        const auto there = static_cast<std::size_t>(
            std::count_if(column.begin(), column.end(), [](double v) { return std::isfinite(v); }));
        m_measurements += there;
        const double runs =
            isOfSteadyRows(trial.kind) ? 1e9 : 1.0 + trial.duration_s() / lengthTime_s(trial, length_m);
        m_independent += std::min(static_cast<double>(there), runs);
    }
}

bool TrialMisfit::operator()(ReplayShip& ship, const TrialStart& start, std::span<double> out) const {
    if (isOfSteadyRows(m_trial.kind)) return rows(ship, out);
    const std::vector<ShipMotion> motions = replay(ship, m_trial, start);
    if (motions.empty()) return false;
    std::size_t i = 0;
    for (const Watched& w : m_watched) {
        const auto& column = m_trial[w.channel];
        for (std::size_t row = 0; row < column.size(); ++row)
            if (std::isfinite(column[row]))
                out[i++] = (valueOf(motions[row], w.channel) - column[row]) / w.deviation;
    }
    return true;
}

bool TrialMisfit::rows(const ReplayShip& ship, std::span<double> out) const {
    constexpr double kNowhere = 20.0;  // standard deviations, where the model has no such steady state
    const Watched& w = m_watched.front();
    const bool spiral = m_trial.kind == TrialKind::Spiral;
    const double shaft_rps = spiral ? steadyShaft_rps(ship, m_trial) : 0.0;
    std::size_t i = 0;
    for (std::size_t row = 0; row < m_trial.rows(); ++row) {
        const double measured = m_trial[w.channel][row];
        if (!std::isfinite(measured)) continue;
        const auto found = spiral ? ship.steadyRudder_rad(m_trial[Channel::YawRate][row], shaft_rps,
                                                          approachOf_mps(m_trial), measured)
                                  : ship.steadySpeed_mps(m_trial[Channel::Shaft][row]);
        out[i++] = found ? (*found - measured) / w.deviation : kNowhere;
    }
    return true;
}

TrialMisfit::Rms TrialMisfit::rms(ReplayShip& ship, const TrialStart& start) const {
    Rms all;
    std::vector<double> misfit(m_measurements);
    if (!(*this)(ship, start, misfit)) return all;
    std::size_t i = 0;
    double north2 = 0.0;
    for (const Watched& w : m_watched) {
        double sum = 0.0, count = 0.0;
        for (const double value : m_trial[w.channel])
            if (std::isfinite(value)) {
                sum += misfit[i] * misfit[i] * w.deviation * w.deviation;
                ++i;
                ++count;
            }
        if (count == 0.0) continue;
        const double rms = std::sqrt(sum / count), length_m = ship.vessel().hull.lengthBp_m;
        if (w.channel == Channel::North) north2 = rms * rms;
        if (w.channel == Channel::East) all.position_L = std::sqrt(north2 + rms * rms) / length_m;
        if (w.channel == Channel::Heading) all.heading_rad = rms;
        if (w.channel == Channel::Surge || w.channel == Channel::Speed) all.speed_mps = rms;
        if (w.channel == Channel::YawRate) all.yawRate_radps = rms;
        if (w.channel == Channel::Roll) all.roll_rad = rms;
        if (w.channel == Channel::Rudder) all.rudder_rad = rms;
    }
    return all;
}

}  // namespace sagara::core
