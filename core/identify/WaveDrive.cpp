#include "core/identify/WaveDrive.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/identify/TrialReplay.h"
#include "core/motion/Waterplane.h"

namespace sagara::core {
namespace {

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(values.size());
}

/// How much of a wave a motion feels, and whether it is the slope (a quarter later) or the height.
double share(Channel motion, const Hull& hull, double k_radpm, double heading_rad) {
    const double along = 0.5 * k_radpm * hull.lengthBp_m * std::cos(heading_rad),
                 across = 0.5 * k_radpm * hull.beam_m * std::sin(heading_rad),
                 smith = std::exp(-0.5 * k_radpm * hull.draught_m);
    if (motion == Channel::Heave) return smith * shapeFactors(along).mean * shapeFactors(across).mean;
    if (motion == Channel::Roll)
        return smith * k_radpm * std::sin(heading_rad) * shapeFactors(along).mean *
               shapeFactors(across).slope;
    return smith * k_radpm * std::cos(heading_rad) * shapeFactors(along).slope * shapeFactors(across).mean;
}

}  // namespace

double encounteredWaveNumber_radpm(double encounter_radps, double speed_mps, double heading_rad) {
    const double c = speed_mps * std::cos(heading_rad) / kGravity_mps2;  // encounter = w - c w^2
    double w = encounter_radps;
    if (std::abs(c) > 1e-9) {
        const double root = 1.0 - 4.0 * c * encounter_radps;
        w = root > 0.0 ? (1.0 - std::sqrt(root)) / (2.0 * c) : 0.5 / c;
    }
    return w * w / kGravity_mps2;
}

WaveDrive::WaveDrive(const SeaTrial& log, Channel motion, const Hull& hull, double fastest_radps)
    : m_from_s(log[Channel::Time].front()) {
    const std::size_t rows = log.rows();
    const double duration_s = log.duration_s(), speed_mps = approachOf_mps(log),
                 heading_rad = *log.waveHeading_rad, level_m = mean(log[Channel::Wave]);
    m_step_s = duration_s / static_cast<double>(rows - 1);
    m_inPhase.resize(rows, Values{});
    m_later.resize(rows, Values{});
    std::vector<double> wave(rows);
    for (std::size_t i = 0; i < rows; ++i)
        wave[i] = log.at(Channel::Wave, m_from_s + static_cast<double>(i) * m_step_s) - level_m;
    const double count = static_cast<double>(rows);
    const bool slope = motion != Channel::Heave;
    for (std::size_t line = 1; 2 * line < rows; ++line) {
        const double turn_rad = kTwoPi * static_cast<double>(line) / count, w_radps = turn_rad / m_step_s;
        if (w_radps > fastest_radps) break;
        const double felt =
            share(motion, hull, encounteredWaveNumber_radpm(w_radps, speed_mps, heading_rad), heading_rad);
        double a = 0.0, b = 0.0;  // the line is a cos + b sin
        const double stepCos = std::cos(turn_rad), stepSin = std::sin(turn_rad);
        const auto overRows = [&](auto&& visit) {
            double c = 1.0, s = 0.0;
            for (std::size_t i = 0; i < rows; ++i) {
                visit(i, c, s);
                const double next = c * stepCos - s * stepSin;
                s = s * stepCos + c * stepSin;
                c = next;
            }
        };
        overRows([&](std::size_t i, double c, double s) {
            a += wave[i] * c * 2.0 / count;
            b += wave[i] * s * 2.0 / count;
        });
        overRows([&](std::size_t i, double c, double s) {
            const double height = felt * (a * c + b * s), quarter = felt * (a * s - b * c);
            const double first = slope ? quarter : height, second = slope ? -height : quarter;
            // d/dt of the first is -w times what comes a quarter later, and of that w times the first
            m_inPhase[i][0] += first;
            m_inPhase[i][1] -= w_radps * second;
            m_inPhase[i][2] -= w_radps * w_radps * first;
            m_later[i][0] += second;
            m_later[i][1] += w_radps * first;
            m_later[i][2] -= w_radps * w_radps * second;
        });
    }
}

WaveDrive::Values WaveDrive::at(const std::vector<Values>& series, double time_s) const {
    const double place =
        std::clamp((time_s - m_from_s) / m_step_s, 0.0, static_cast<double>(series.size() - 1));
    const std::size_t i = std::min(static_cast<std::size_t>(place), series.size() - 2);
    const double share = place - static_cast<double>(i);
    Values v;
    for (std::size_t k = 0; k < v.size(); ++k) v[k] = (1.0 - share) * series[i][k] + share * series[i + 1][k];
    return v;
}

}  // namespace sagara::core
