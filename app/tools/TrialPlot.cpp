#include "app/tools/TrialPlot.h"

#include "core/base/Units.h"

namespace sagara::tools {

report::XyPlot trialPlot(const core::Trial& trial, TrialPicture picture, const ReferenceTable* published) {
    using Sample = core::TrialSample;
    report::XyPlot plot;
    const auto add = [&](const char* name, auto&& x, auto&& y) {
        report::XyPlot::Series series{name, false, {}};
        for (const Sample& s : trial.samples) series.at.emplace_back(x(s), y(s));
        plot.series.push_back(std::move(series));
    };
    const auto addPublished = [&](const char* x, const char* y) {
        if (!published) return;
        report::XyPlot::Series points{"published", true, {}};
        for (std::size_t i = 0; i < published->rows(); ++i)
            points.at.emplace_back(published->at(x, i), published->at(y, i));
        plot.series.push_back(std::move(points));
    };
    const auto time = [](const Sample& s) { return s.time_s; };
    const auto ahead = [](const Sample& s) { return s.x_m; };
    switch (picture) {
        case TrialPicture::Track:
            plot.xTitle = "to starboard, m";
            plot.yTitle = "ahead, m";
            plot.sameScale = true;
            add(
                "Sagara", [](const Sample& s) { return s.y_m; }, ahead);
            addPublished("y", "x");
            break;
        case TrialPicture::HeadingOverTime:
            plot.xTitle = "time, s";
            plot.yTitle = "deg, to starboard";
            add("heading", time, [](const Sample& s) { return s.heading_rad / core::kDegree_rad; });
            add("rudder", time, [](const Sample& s) { return s.rudder_rad / core::kDegree_rad; });
            addPublished("t", "psi");
            break;
        case TrialPicture::SpeedOverReach:
            plot.xTitle = "ahead, m";
            plot.yTitle = "speed ahead, kn";
            add("Sagara", ahead, [](const Sample& s) { return s.surge_mps / core::kKnot_mps; });
            break;
    }
    return plot;
}

}  // namespace sagara::tools
