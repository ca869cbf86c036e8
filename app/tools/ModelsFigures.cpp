#include "app/tools/ModelsFigures.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::tools {
namespace {

/// Adds a line, or its name to a line that it lies upon.
void addLine(report::XyPlot& plot, const std::string& name, std::size_t look, std::vector<QPointF> line,
             double apart) {
    for (auto& series : plot.series) {
        if (series.points || series.at.size() != line.size()) continue;
        const auto near = [&](QPointF a, QPointF b) {
            return std::hypot(a.x() - b.x(), a.y() - b.y()) <= apart;
        };
        if (!std::equal(line.begin(), line.end(), series.at.begin(), near)) continue;
        series.name += "; " + name;
        return;
    }
    plot.series.push_back({name, false, std::move(line), look});
}

}  // namespace

report::XyPlot turnFigure(const std::vector<ModelTrials>& models, core::Trial ModelTrials::*turn,
                          const TrialMarks& marks) {
    report::XyPlot plot;
    plot.xTitle = "to starboard, ship lengths";
    plot.yTitle = "ahead, ship lengths";
    plot.sameScale = true;
    double side = 1.0;
    std::size_t look = 0;
    for (const ModelTrials& t : models) {
        std::vector<QPointF> line;
        for (const core::TrialSample& s : (t.*turn).samples) {
            line.emplace_back(s.y_m / t.length_m, s.x_m / t.length_m);
            side = s.y_m < 0.0 ? -1.0 : 1.0;
        }
        addLine(plot, t.name, look++, std::move(line), 1e-6);
    }
    const auto advance = marks.at("advance_over_L"), transfer = marks.at("transfer_over_L");
    if (advance && transfer && side > 0.0)
        plot.series.push_back({"at 90 deg, " + marks.from, true, {{*transfer, *advance}}});
    return plot;
}

report::XyPlot zigzagFigure(const std::vector<ModelTrials>& models) {
    report::XyPlot plot;
    plot.xTitle = "time, lengths run at the approach speed";
    plot.yTitle = "heading, deg to starboard";
    std::size_t look = 0;
    for (const ModelTrials& t : models) {
        std::vector<QPointF> line;
        for (const core::TrialSample& s : t.zigzag.samples)
            line.emplace_back(s.time_s * t.zigzag.approach_mps / t.length_m,
                              s.heading_rad / core::kDegree_rad);
        addLine(plot, t.name, look++, std::move(line), 1e-6);
    }
    return plot;
}

report::XyPlot speedFigure(const std::vector<ModelTrials>& models) {
    report::XyPlot plot;
    plot.xTitle = "heading change, deg";
    plot.yTitle = "speed over that of the approach";
    std::size_t look = 0;
    for (const ModelTrials& t : models) {
        std::vector<QPointF> line;
        for (const core::TrialSample& s : t.turn.samples)
            line.emplace_back(s.heading_rad / core::kDegree_rad,
                              std::hypot(s.surge_mps, s.sway_mps) / t.turn.approach_mps);
        addLine(plot, t.name, look++, std::move(line), 1e-6);
    }
    return plot;
}

report::XyPlot responseFigure(const std::vector<ModelTrials>& models, double WaveAnswer::*motion, bool beam,
                              const report::XyPlot::Series& strip) {
    report::XyPlot plot;
    plot.xTitle = "wave frequency, rad/s";
    plot.yTitle = motion == &WaveAnswer::heave ? "over wave amplitude" : "over wave slope";
    double most = 0.0;
    std::size_t look = 0;
    for (const ModelTrials& t : models) {
        std::vector<QPointF> line;
        for (const auto& w : t.waves) line.emplace_back(w.omega_radps, (beam ? w.beam : w.head).*motion);
        addLine(plot, t.name, look++, std::move(line), 1e-3);
    }
    for (const QPointF p : strip.at) most = std::max(most, p.y());
    plot.yMost = std::max(1.5, 1.3 * most);
    plot.series.push_back(strip);
    return plot;
}

}  // namespace sagara::tools
