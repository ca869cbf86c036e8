#include "app/tools/TrialPlot.h"

#include "core/base/Units.h"

namespace sagara::tools {

report::XyPlot trialPlot(const std::string& ship, const core::Trial& trial, bool overTime,
                         const ReferenceTable* published) {
    report::XyPlot plot;
    plot.title = ship + ": " + trial.title;
    plot.xTitle = overTime ? "time, s" : "to starboard, m";
    plot.yTitle = overTime ? "deg, to starboard" : "ahead, m";
    plot.sameScale = !overTime;
    const auto add = [&](const char* name, auto&& x, auto&& y) {
        report::XyPlot::Series series{name, false, {}};
        for (const core::TrialSample& s : trial.samples) series.at.emplace_back(x(s), y(s));
        plot.series.push_back(std::move(series));
    };
    using Sample = core::TrialSample;
    if (overTime) {
        const auto time = [](const Sample& s) { return s.time_s; };
        add("heading", time, [](const Sample& s) { return s.heading_rad / core::kDegree_rad; });
        add("rudder", time, [](const Sample& s) { return s.rudder_rad / core::kDegree_rad; });
    } else {
        add(
            "Sagara", [](const Sample& s) { return s.y_m; }, [](const Sample& s) { return s.x_m; });
    }
    if (!published) return plot;
    report::XyPlot::Series points{"published", true, {}};
    for (std::size_t i = 0; i < published->rows(); ++i)
        points.at.emplace_back(published->at(overTime ? "t" : "y", i),
                               published->at(overTime ? "psi" : "x", i));
    plot.series.push_back(std::move(points));
    return plot;
}

}  // namespace sagara::tools
