#include "app/tools/ModelsTables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::tools {
namespace {

using Cell = report::SectionTable::Cell;

// What counts as yes. Each is said in the note below its table.
constexpr double kMoves = 0.01;       ///< of a wave's amplitude or slope
constexpr double kLosesSpeed = 0.98;  ///< least ratio that is no loss
constexpr double kDrifts_deg = 0.5;   ///< bow inside
constexpr double kHeels_deg = 0.05;
constexpr double kTurnsByDrift = 0.01;  ///< of (U/L)^2
constexpr double kSameCircle = 0.05;    ///< of the tactical diameter
constexpr double kWider = 1.05;
constexpr double kRidesLongWave = 0.05;  ///< heave from one
constexpr double kShownWave_L = 2.0;     ///< wavelength of the table's responses

Cell yesNo(bool yes, std::string note) { return {yes ? "yes" : "no", std::move(note), !yes}; }

/// Of the wave nearest to a wavelength over the length.
const ModelTrials::InWave& waveNear(const ModelTrials& t, double lambdaOverL) {
    return *std::min_element(t.waves.begin(), t.waves.end(), [&](const auto& a, const auto& b) {
        return std::abs(std::log(a.lambdaOverL / lambdaOverL)) <
               std::abs(std::log(b.lambdaOverL / lambdaOverL));
    });
}

const ModelTrials::InWave& longestWave(const ModelTrials& t) {
    return *std::max_element(t.waves.begin(), t.waves.end(),
                             [](const auto& a, const auto& b) { return a.lambdaOverL < b.lambdaOverL; });
}

double mostHeel_deg(const core::Trial& turn) {
    return std::max(turn.measure("max_heel_to_port_deg").value_or(0.0),
                    turn.measure("max_heel_to_starboard_deg").value_or(0.0));
}

/// "+4.1", "0": never "-0".
std::string signedNumber(double value, int decimals) {
    const double scale = std::pow(10.0, decimals);
    const double rounded = std::round(value * scale) / scale;
    return rounded == 0.0 ? "0" : fmt::format("{:+.{}f}", rounded, decimals);
}

Cell driftCell(const ModelTrials& t) {
    const double drift_deg = t.turn.measure("steady_drift_deg").value_or(0.0);
    if (drift_deg < -kDrifts_deg) return {"wrong way", fmt::format("{:.1f} deg", drift_deg), true};
    return yesNo(drift_deg > kDrifts_deg, fmt::format("{:.1f} deg", std::abs(drift_deg)));
}

Cell longWaveCell(const WaveAnswer& answer) {
    if (!std::isfinite(answer.heave)) return {"no", "without bound", true};
    if (answer.risePerPeriod > kRidesLongWave)
        return {"no", fmt::format("rises {:.2g} a wave", answer.risePerPeriod), true};
    return yesNo(std::abs(answer.heave - 1.0) < kRidesLongWave, fmt::format("heave {:.2f}", answer.heave));
}

Cell resultCell(const core::Trial& trial, const char* name, const TrialMarks& marks, bool share) {
    const auto value = trial.measure(name);
    if (!value) return {"not reached", {}, true};
    Cell cell{fmt::format("{:.2f}", *value + 0.0), {}, false};
    if (const auto mark = marks.at(name))
        cell.note =
            share ? signedNumber(100.0 * (*value / *mark - 1.0), 0) + " %" : signedNumber(*value - *mark, 1);
    return cell;
}

struct Result {
    const char* title;
    const char* name;
    bool share;  ///< its error over the mark; else a difference
    core::Trial ModelTrials::*trial;
};
constexpr Result kResults[] = {
    {"Advance / L", "advance_over_L", true, &ModelTrials::turn},
    {"Transfer / L", "transfer_over_L", true, &ModelTrials::turn},
    {"Tactical diameter / L", "tactical_diameter_over_L", true, &ModelTrials::turn},
    {"Speed left in the turn", "steady_speed_ratio", true, &ModelTrials::turn},
    {"Drift in the turn, deg", "steady_drift_deg", false, &ModelTrials::turn},
    {"Overshoot 1, deg", "overshoot_1_deg", false, &ModelTrials::zigzag},
    {"Overshoot 2, deg", "overshoot_2_deg", false, &ModelTrials::zigzag}};

}  // namespace

std::optional<double> TrialMarks::at(std::string_view name) const {
    for (const TrialMark& mark : marks)
        if (mark.name == name) return mark.value;
    return std::nullopt;
}

report::SectionTable tableOfFreedoms(const std::vector<ModelTrials>& models) {
    report::SectionTable table;
    table.title = "Table I: degrees of freedom that move";
    table.columns = {{"Model"},       {"Surge", 21.0}, {"Sway", 21.0},  {"Yaw", 21.0},
                     {"Heave", 19.0}, {"Roll", 19.0},  {"Pitch", 19.0}, {"Together", 17.0}};
    for (const ModelTrials& t : models) {
        const auto& wave = waveNear(t, kShownWave_L);
        const double rate_dps = t.turn.measure("steady_r_dps").value_or(0.0);
        const double drift_deg = t.turn.measure("steady_drift_deg").value_or(0.0);
        const bool moves[] = {t.speedLeft<kLosesSpeed, std::abs(drift_deg)> kDrifts_deg, rate_dps > 0.0,
                              wave.head.heave > kMoves, wave.beam.roll_k > kMoves,
                              wave.head.pitch_k > kMoves};
        const auto count = std::count(std::begin(moves), std::end(moves), true);
        table.rows.push_back({{t.name, t.of},
                              yesNo(moves[0], fmt::format("{:.0f} % left", 100.0 * t.speedLeft)),
                              yesNo(moves[1], fmt::format("{:.1f} deg", drift_deg + 0.0)),
                              yesNo(moves[2], fmt::format("{:.2f} deg/s", rate_dps)),
                              yesNo(moves[3], fmt::format("{:.2f}", wave.head.heave)),
                              yesNo(moves[4], fmt::format("{:.2f}", wave.beam.roll_k)),
                              yesNo(moves[5], fmt::format("{:.2f}", wave.head.pitch_k)),
                              {fmt::format("{} of 6", count)}});
    }
    table.note = fmt::format(
        "Surge: speed left ten lengths' time after the shafts are stopped. Sway: drift angle in the steady "
        "turn, "
        "yes from {} deg. Yaw: rate in the steady turn. Heave and pitch in head waves, roll in beam waves of "
        "{:.1f} lengths, over amplitude and slope, yes from {}.",
        kDrifts_deg, waveNear(models.front(), kShownWave_L).lambdaOverL, kMoves);
    return table;
}

report::SectionTable tableOfFeatures(const std::vector<ModelTrials>& models) {
    report::SectionTable table;
    table.title = "Table II: what acts on what";
    table.columns = {{"Model"},
                     {"Loses speed in a turn", 18.0},
                     {"Slides outward in it", 19.0},
                     {"Drift turns her", 17.0},
                     {"Heels in a turn", 17.0},
                     {"Same circle at half speed", 20.0},
                     {"Wider in shallow water", 19.0},
                     {"Rides a long wave", 20.0},
                     {"Times real time", 18.0}};
    for (const ModelTrials& t : models) {
        const double left = t.turn.measure("steady_speed_ratio").value_or(1.0);
        const double heel_deg = mostHeel_deg(t.turn), half = t.halfSpeedDiameter.value_or(0.0),
                     shallow = t.shallowDiameter.value_or(0.0);
        table.rows.push_back(
            {{t.name},
             yesNo(left < kLosesSpeed, fmt::format("{:.0f} % left", 100.0 * left)),
             driftCell(t),
             yesNo(std::abs(t.yawFromDrift) > kTurnsByDrift, fmt::format("{:.2f}", t.yawFromDrift + 0.0)),
             yesNo(heel_deg > kHeels_deg, fmt::format("{:.2f} deg", heel_deg)),
             yesNo(std::abs(half - 1.0) < kSameCircle,
                   t.halfSpeedDiameter ? fmt::format("x {:.2f}", half) : "not reached"),
             yesNo(shallow > kWider, t.shallowDiameter ? fmt::format("x {:.2f}", shallow) : "not reached"),
             longWaveCell(longestWave(t).head),
             {fmt::format("{:.0f} 000", std::max(1.0, 1e-3 * t.timesRealTime))}});
    }
    table.note = fmt::format(
        "Loses speed: less than {:.0f} % of the approach left in the steady turn. Slides outward: the bow "
        "points "
        "into the circle; wrong way: out of it. Drift turns her: yaw acceleration over (U/L)² at 5 deg of "
        "drift, "
        "rudder midship, yes from {}. Heels: most heel, yes from {} deg. Same circle: tactical diameter at "
        "half "
        "the approach speed over that at full, yes within {:.0f} %. Wider: tactical diameter at 1.2 draughts "
        "of "
        "water over that in deep, yes from {}. Long wave: heave over amplitude in head waves of {:.0f} "
        "lengths, "
        "yes from {:.2f} to {:.2f} with less than {} of the amplitude gained in each wave. Times real time: "
        "seconds of the turn each second on the machine that "
        "made this "
        "report.",
        100.0 * kLosesSpeed, kTurnsByDrift, kHeels_deg, 100.0 * kSameCircle, kWider,
        longestWave(models.front()).lambdaOverL, 1.0 - kRidesLongWave, 1.0 + kRidesLongWave, kRidesLongWave);
    return table;
}

report::SectionTable tableOfResults(const std::vector<ModelTrials>& models, const TrialMarks& marks) {
    report::SectionTable table;
    table.title = "Table IV: results against " + marks.from;
    table.columns = {{"Model"}};
    std::vector<Cell> first{{marks.from}};
    for (const Result& r : kResults) {
        table.columns.push_back({r.title, 19.5});
        const auto mark = marks.at(r.name);
        first.push_back(mark ? Cell{fmt::format("{:.2f}", *mark)} : Cell{"not at hand", {}, true});
    }
    table.rows.push_back(std::move(first));
    for (const ModelTrials& t : models) {
        std::vector<Cell> row{{t.name}};
        for (const Result& r : kResults) row.push_back(resultCell(t.*r.trial, r.name, marks, r.share));
        table.rows.push_back(std::move(row));
    }
    table.note =
        "Small: error against the first row, in per cent or degrees. Drift at midship, positive with the bow "
        "inside the circle.";
    return table;
}

}  // namespace sagara::tools
