#include "ui/vessels/TrialPlots.h"

#include <QCoreApplication>

#include "core/base/Units.h"

namespace sagara::ui {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("sagara::ui::TrialPlots", text); }

template <typename Y>
std::vector<QPointF> against(const core::Trial& trial, Y&& y, double turns = 1e9) {
    std::vector<QPointF> points;
    for (const core::TrialSample& s : trial.samples) {
        if (std::abs(s.heading_rad) > turns) break;
        points.push_back(y(s));
    }
    return points;
}
QPointF headingAt(const core::TrialSample& s) { return {s.time_s, s.heading_rad / core::kDegree_rad}; }
QPointF rudderAt(const core::TrialSample& s) { return {s.time_s, s.rudder_rad / core::kDegree_rad}; }

}  // namespace

Plot turningPlot(const core::StandardTrials& trials) {
    Plot plot;
    plot.title = tr("Turning circles, full ahead, rudder hard over");
    plot.xLabel = tr("Transfer, ship lengths");
    plot.yLabel = tr("Advance, ship lengths");
    plot.equalScale = plot.xUp = true;
    plot.empty = tr("Run the trials to see her turning circles.");
    if (trials.turnStarboard.samples.empty()) return plot;
    const double L = trials.turnStarboard.length_m;
    const auto place = [L](const core::TrialSample& s) { return QPointF(s.x_m / L, s.y_m / L); };
    plot.series = {{tr("starboard"), 0, false, against(trials.turnStarboard, place)},
                   {tr("port"), 1, false, against(trials.turnPort, place)}};
    const core::ImoLimits limits;
    plot.limits = {{true, limits.advance_L, tr("IMO advance 4.5 L")},
                   {false, limits.tacticalDiameter_L, tr("5 L")},
                   {false, -limits.tacticalDiameter_L, tr("5 L")}};
    return plot;
}

Plot turningTimePlot(const core::Trial& trial) {
    Plot plot;
    plot.title = tr("Turn to starboard: heading, rudder and speed");
    plot.xLabel = tr("Time, s");
    plot.yLabel = tr("°, and % of approach speed");
    plot.empty = tr("Heading, rudder and speed in the turn.");
    if (trial.samples.empty()) return plot;
    const double U = trial.approach_mps;
    plot.series = {{tr("heading °"), 0, false, against(trial, headingAt, core::kTwoPi)},
                   {tr("rudder °"), 1, true, against(trial, rudderAt, core::kTwoPi)},
                   {tr("speed %"), 2, false,
                    against(
                        trial,
                        [U](const core::TrialSample& s) {
                            return QPointF(s.time_s, 100.0 * std::hypot(s.surge_mps, s.sway_mps) / U);
                        },
                        core::kTwoPi)}};
    return plot;
}

Plot zigzagPlot(const core::Trial& trial, double first_deg, double second_deg, double switch_deg) {
    Plot plot;
    plot.title = tr("Zigzag %1/%1: heading and rudder").arg(switch_deg);
    plot.xLabel = tr("Time, s");
    plot.yLabel = tr("°, to starboard positive");
    plot.empty = tr("Heading and rudder of the zigzag.");
    if (trial.samples.empty()) return plot;
    plot.series = {{tr("heading °"), 0, false, against(trial, headingAt)},
                   {tr("rudder °"), 1, true, against(trial, rudderAt)}};
    plot.limits = {{true, switch_deg + first_deg, tr("IMO 1st overshoot %1°").arg(first_deg, 0, 'f', 1)}};
    if (second_deg > 0.0)
        plot.limits.push_back(
            {true, -switch_deg - second_deg, tr("IMO 2nd overshoot %1°").arg(second_deg, 0, 'f', 1)});
    return plot;
}

Plot stoppingPlot(const core::Trial& trial) {
    Plot plot;
    plot.title = tr("Stopping, full ahead to full astern");
    plot.xLabel = tr("Head reach, ship lengths");
    plot.yLabel = tr("Speed, kn");
    plot.empty = tr("Speed against distance of the crash stop.");
    if (trial.samples.empty()) return plot;
    const double L = trial.length_m;
    plot.series = {{tr("speed"), 0, false, against(trial, [L](const core::TrialSample& s) {
                        return QPointF(s.x_m / L, s.surge_mps / core::kKnot_mps);
                    })}};
    plot.limits = {{false, core::ImoLimits().trackReach_L, tr("IMO track reach 15 L")}};
    return plot;
}

}  // namespace sagara::ui
