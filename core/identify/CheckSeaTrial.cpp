#include "core/identify/CheckSeaTrial.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

/// Notes what is not there.
class Needs {
public:
    explicit Needs(const SeaTrial& trial) : m_trial(trial) {}

    bool has(Channel c) const {
        const auto& column = m_trial[c];
        return std::any_of(column.begin(), column.end(), [](double v) { return std::isfinite(v); });
    }
    bool speed() const { return has(Channel::Speed) || has(Channel::Surge); }
    void need(bool there, const char* what) {
        if (!there) m_lacking.push_back(what);
    }
    /// Before a turn she makes way.
    void approach() {
        if (m_trial.approach_mps) need(*m_trial.approach_mps > 0.0, "a \"# approach_mps\" of more than 0");
        need(speed() || m_trial.approach_mps,
             "surge_mps, speed_mps or speed_kn, or a line \"# approach_mps: ...\"");
    }
    std::vector<const char*> take() { return std::move(m_lacking); }

private:
    const SeaTrial& m_trial;
    std::vector<const char*> m_lacking;
};

void needTurn(Needs& n, const SeaTrial& trial) {
    n.need(
        n.has(Channel::Heading) || n.has(Channel::YawRate) || (n.has(Channel::North) && n.has(Channel::East)),
        "heading_deg, yaw_rate_degps, or x_m and y_m");
    n.need(n.has(Channel::Rudder) || trial.rudder_rad, "a column rudder_deg or a line \"# rudder_deg: ...\"");
    if (trial.kind == TrialKind::Zigzag)
        n.need(n.has(Channel::Rudder) || trial.switch_rad,
               "a column rudder_deg or a line \"# heading_deg: ...\"");
    n.approach();
}

void needStop(Needs& n, const SeaTrial& trial) {
    n.approach();
    n.need(n.speed() || n.has(Channel::North), "surge_mps, speed_mps, speed_kn, or x_m");
    n.need(n.has(Channel::Shaft) || trial.shaft_rps, "shaft_rps or shaft_rpm");
}

void needLog(Needs& n, const SeaTrial& trial) {
    n.need(n.has(Channel::Roll) || n.has(Channel::Pitch) || n.has(Channel::Heave),
           "roll_deg, pitch_deg or heave_m");
    n.need(n.has(Channel::Wave), "wave_m");
    n.need(trial.waveHeading_rad.has_value(), "a line \"# wave_heading_deg: ...\"");
}

void needRows(Needs& n, TrialKind kind) {
    if (kind == TrialKind::Speed) {
        n.need(n.has(Channel::Shaft), "shaft_rps or shaft_rpm");
        n.need(n.speed(), "speed_mps, speed_kn or surge_mps");
        return;
    }
    n.approach();
    n.need(n.has(Channel::Rudder), "rudder_deg");
    n.need(n.has(Channel::YawRate), "yaw_rate_degps");
}

void unwrap(std::vector<double>& headings_rad) {
    std::optional<double> last_rad;
    for (double& heading_rad : headings_rad) {
        if (!std::isfinite(heading_rad)) continue;
        if (last_rad) heading_rad -= kTwoPi * std::round((heading_rad - *last_rad) / kTwoPi);
        last_rad = heading_rad;
    }
}

void fillGaps(std::vector<double>& values) {
    std::optional<std::size_t> known;  // the last row with a number
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) continue;
        const double from = known ? values[*known] : values[i];
        const std::size_t first = known ? *known + 1 : 0;
        for (std::size_t j = first; j < i; ++j)
            values[j] = from + (values[i] - from) * static_cast<double>(j + 1 - first) /
                                   static_cast<double>(i + 1 - first);
        known = i;
    }
    for (std::size_t j = known ? *known + 1 : values.size(); j < values.size(); ++j)
        values[j] = values[*known];
}

}  // namespace

std::vector<const char*> lackingIn(const SeaTrial& trial) {
    Needs n(trial);
    const TrialKind kind = trial.kind;
    if (kind == TrialKind::Speed || kind == TrialKind::Spiral) {
        needRows(n, kind);
        return n.take();
    }
    n.need(n.has(Channel::Time), "time_s");
    if (kind == TrialKind::Turning || kind == TrialKind::Zigzag) needTurn(n, trial);
    if (kind == TrialKind::Stopping) needStop(n, trial);
    if (kind == TrialKind::Decay) n.need(n.has(Channel::Roll), "roll_deg");
    if (kind == TrialKind::MotionLog) needLog(n, trial);
    return n.take();
}

void tidy(SeaTrial& trial) {
    unwrap(trial[Channel::Heading]);
    for (const Channel c : {Channel::Rudder, Channel::Shaft, Channel::Wave}) fillGaps(trial[c]);
}

}  // namespace sagara::core
