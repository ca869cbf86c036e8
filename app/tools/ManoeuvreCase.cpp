#include <algorithm>
#include <cmath>
#include <limits>

#include "app/tools/Manoeuvre.h"
#include "app/tools/ReferenceTable.h"
#include "app/tools/TrialPlot.h"
#include "app/tools/ValidationCase.h"
#include "core/base/Units.h"

namespace sagara::tools {
namespace {

using core::config::Reader;

constexpr double kNotReached = std::numeric_limits<double>::quiet_NaN();

/// Tolerances of a published trace; none where it is only drawn.
struct Trace {
    std::string file;
    std::optional<double> position_L, heading_deg, roll_deg;
};

/// One measure of the run.
struct Measure {
    std::string name;
    ValidationRow row;
    bool overDeep = false;  ///< the ratio to the same run in deep water
};

struct ManoeuvreCase {
    ManoeuvreOptions run;
    std::optional<Trace> trace;
    std::vector<Measure> measures;
};

std::optional<double> optionalNumber(Reader& in, std::string_view key, core::config::Range range) {
    return in.has(key) ? std::optional(in.number(key, range)) : std::nullopt;
}

void readRun(Reader in, ManoeuvreOptions& o) {
    using Test = ManoeuvreOptions::Test;
    o.test = in.choice<Test>("test", {{"turning", Test::Turning},
                                      {"zigzag", Test::Zigzag},
                                      {"spiral", Test::Spiral},
                                      {"stopping", Test::Stopping},
                                      {"pullout", Test::Pullout}});
    o.rudder_deg = optionalNumber(in, "rudder_deg", {-90.0, 90.0, "deg"});
    o.heading_deg = optionalNumber(in, "heading_deg", {0.1, 180.0, "deg"});
    if (in.has("first")) o.starboardFirst = in.choice<bool>("first", {{"starboard", true}, {"port", false}});
    o.look_s = in.numberOr("look_s", 0.0, {0.001, 1.0, "s"});
    o.speed_mps = optionalNumber(in, "speed_mps", {0.05, 60.0, "m/s"});
    o.shaft_rps = optionalNumber(in, "shaft_rps", {0.01, 100.0, "1/s"});
    in.rejectUnknownKeys();
}

Trace readTrace(Reader in) {
    Trace trace;
    trace.file = in.text("file");
    trace.position_L = optionalNumber(in, "position_L", {1e-6, 1.0, ""});
    trace.heading_deg = optionalNumber(in, "heading_deg", {1e-4, 90.0, "deg"});
    trace.roll_deg = optionalNumber(in, "roll_deg", {1e-4, 90.0, "deg"});
    in.rejectUnknownKeys();
    return trace;
}

Measure readMeasure(Reader in) {
    Measure m;
    m.name = in.text("name");
    m.overDeep = in.flagOr("overDeep", false);
    m.row.quantity = m.overDeep ? m.name + " over deep" : m.name;
    m.row.atMost = in.has("atMost");
    m.row.reference = in.number(m.row.atMost ? "atMost" : "reference", {-1e6, 1e6, ""});
    m.row.share = in.has("share");
    if (!m.row.atMost) m.row.tolerance = in.number(m.row.share ? "share" : "within", {0.0, 1e6, ""});
    in.rejectUnknownKeys();
    return m;
}

ManoeuvreCase readCase(const ValidationContext& context, Reader& in) {
    ManoeuvreCase c;
    c.run.ship.vessel =
        in.has("particulars") ? context.reference(in.text("particulars")).string() : in.text("vessel");
    c.run.ship.model = in.textOr("model", "");
    c.run.ship.depth_m = in.numberOr("depth_m", core::kDeepWater_m, {0.1, core::kDeepWater_m, "m"});
    readRun(Reader(in.child("run")), c.run);
    if (in.has("trace")) c.trace = readTrace(Reader(in.child("trace")));
    for (const auto& node : in.listOr("measures")) c.measures.push_back(readMeasure(Reader(node)));
    in.rejectUnknownKeys();
    return c;
}

/// The largest differences between a run and a published trace.
struct TraceError {
    double position_m = 0.0, heading_deg = 0.0, roll_deg = 0.0;
};

TraceError compare(const core::Trial& trial, const ReferenceTable& trace) {
    TraceError e;
    const bool roll = trace.has("phi");
    std::size_t i = 1;
    for (std::size_t row = 0; row < trace.rows(); ++row) {
        const double t_s = trace.at("t", row);
        while (i + 1 < trial.samples.size() && trial.samples[i].time_s < t_s) ++i;
        const core::TrialSample &a = trial.samples[i - 1], &b = trial.samples[i];
        const double f = std::clamp((t_s - a.time_s) / (b.time_s - a.time_s), 0.0, 1.0);
        const auto at = [&](double core::TrialSample::*field) {
            return a.*field + f * (b.*field - a.*field);
        };
        e.position_m = std::max(e.position_m, std::hypot(at(&core::TrialSample::x_m) - trace.at("x", row),
                                                         at(&core::TrialSample::y_m) - trace.at("y", row)));
        e.heading_deg = std::max(
            e.heading_deg,
            std::abs(std::remainder(
                at(&core::TrialSample::heading_rad) / core::kDegree_rad - trace.at("psi", row), 360.0)));
        if (roll)
            e.roll_deg = std::max(e.roll_deg, std::abs(at(&core::TrialSample::roll_rad) / core::kDegree_rad -
                                                       trace.at("phi", row)));
    }
    return e;
}

void addTraceRows(ValidationOutcome& outcome, const Trace& trace, const core::Trial& trial,
                  const ReferenceTable& published) {
    if (trial.samples.size() < 2) return;
    const TraceError e = compare(trial, published);
    const auto add = [&](const char* quantity, double error, const std::optional<double>& tolerance) {
        if (tolerance)
            outcome.rows.push_back({.quantity = quantity, .measured = error, .tolerance = *tolerance});
    };
    add("track, largest error over L", e.position_m / trial.length_m, trace.position_L);
    add("heading, largest error, deg", e.heading_deg, trace.heading_deg);
    add("roll, largest error, deg", e.roll_deg, trace.roll_deg);
}

void addMeasureRows(ValidationOutcome& outcome, const ManoeuvreCase& c, const core::Vessel& vessel,
                    const core::Trial& trial) {
    for (Measure m : c.measures) {
        m.row.measured = trial.measure(m.name).value_or(kNotReached);
        if (m.overDeep) {
            ManoeuvreOptions deep = c.run;
            deep.ship.depth_m = core::kDeepWater_m;
            m.row.measured /= tryManoeuvre(vessel, deep).measure(m.name).value_or(kNotReached);
        }
        outcome.rows.push_back(m.row);
    }
}

TrialPicture pictureOf(ManoeuvreOptions::Test test) {
    if (test == ManoeuvreOptions::Test::Zigzag) return TrialPicture::HeadingOverTime;
    if (test == ManoeuvreOptions::Test::Stopping) return TrialPicture::SpeedOverReach;
    return TrialPicture::Track;
}

}  // namespace

ValidationOutcome runManoeuvreCase(const ValidationContext& context, Reader& in) {
    ManoeuvreCase c = readCase(context, in);
    ValidationOutcome outcome;
    if (!in.sound()) return outcome;
    const auto vessel = openVessel(context.documents, c.run.ship);
    if (!vessel) return outcome.trouble = vessel.error(), outcome;
    std::optional<ReferenceTable> published;
    if (c.trace) {
        auto table = ReferenceTable::read(context.reference(c.trace->file));
        if (!table) return outcome.trouble = table.error(), outcome;
        published = std::move(table).value();
        const double last_s = published->at("t", published->rows() - 1);
        const double every_s = last_s / static_cast<double>(published->rows() - 1);
        c.run.duration_s = last_s;
        c.run.dt_s = every_s / std::ceil(every_s);  // rows at the times of the trace, a second apart at most
    }
    const core::Trial trial = tryManoeuvre(*vessel, c.run);
    if (c.trace) addTraceRows(outcome, *c.trace, trial, *published);
    addMeasureRows(outcome, c, *vessel, trial);
    outcome.plots.push_back(trialPlot(trial, pictureOf(c.run.test), published ? &*published : nullptr));
    return outcome;
}

}  // namespace sagara::tools
