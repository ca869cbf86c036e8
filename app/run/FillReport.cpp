#include "app/run/FillReport.h"

#include <fmt/format.h>

#include <array>

#include "core/base/Angle.h"
#include "ui/chart/Contours.h"
#include "ui/chart/Marks.h"

namespace sagara::run {
namespace {

std::string weatherLine(const core::World& world, int level) {
    const core::Weather w = core::scaled(world.weather, world.level(level));
    const int force = core::beaufortOfWind(w.wind.speed_mps);
    std::string line =
        fmt::format("wind {:03.0f}°, {:.0f} kn (Beaufort {}, {})", w.wind.windFrom_rad / core::kDegree_rad,
                    w.wind.speed_mps / core::kKnot_mps, force, core::beaufortName(force));
    for (const core::WaveSystem& swell : w.swells) {
        if (swell.significantHeight_m == 0.0) continue;
        line += fmt::format("; swell {:03.0f}°, {:.1f} m, {:.0f} s",
                            core::wrapTwoPi(swell.wavesTo_rad + core::kPi) / core::kDegree_rad,
                            swell.significantHeight_m, swell.peakPeriod_s);
    }
    return line + fmt::format("; visibility {:.1f} M", w.visibility_m / core::kNauticalMile_m);
}

void fillTracks(report::RunReport& r, const core::World& world, const core::Mission& mission,
                const core::Recording& recording) {
    const auto track = recording.track(world.ships.size(), world.targets.size());
    std::vector<report::OtherTrack> others;
    for (const auto* list : {&world.targets, &recording.added}) {
        for (const core::TargetLayout& t : *list)
            others.push_back({t.name, t.behaviour == core::TargetBehaviour::Hostile, {}});
    }
    core::RouteProgress progress;
    constexpr std::int64_t kOthersEvery_ticks = 10 * core::kTicksPerSecond;
    for (const core::TrackSample& sample : track) {
        if (sample.tick % core::kTicksPerSecond != 0 || sample.ships.empty()) continue;
        const core::ShipSample& s = sample.ships[0];
        core::follow(world.path, s.motion.position(), progress);
        const core::Limits limits = core::limitsAt(mission, s.observation, progress);
        const std::size_t shafts = world.ships[0]->shaftCount();
        r.track.push_back({core::timeOfTick(sample.tick).seconds(),
                           s.motion.position(),
                           s.motion.heading_rad,
                           core::length(s.observation.overGround_mps),
                           s.rudder_rad,
                           {s.shafts_rps.begin(), s.shafts_rps.begin() + static_cast<std::ptrdiff_t>(shafts)},
                           s.motion.roll_rad,
                           s.observation.underKeel_m,
                           limits.speedOverGround_mps});
        r.underKeelLimit_m = limits.underKeel_m;
        if (sample.tick % kOthersEvery_ticks != 0) continue;
        for (std::size_t i = 0; i < sample.targets.size(); ++i) {
            if (sample.targets[i].present) others[i].points.push_back(sample.targets[i].position);
        }
    }
    for (report::OtherTrack& other : others) {
        if (!other.points.empty()) r.others.push_back(std::move(other));
    }
    for (const core::Event& e : recording.events) {
        if (e.ship == 0 && e.kind == core::EventKind::AnchorLetGo)
            r.anchors.push_back({e.place, e.time().seconds()});
    }
}

void fillChart(report::RunReport& r, const core::World& world) {
    const core::Area& area = world.area;
    r.route = world.route;
    r.path = world.path;
    r.frame = area.frame;
    r.areaName = area.name;
    r.chartNotice = area.notice;
    r.depthDatum = area.depthDatum;
    r.attribution = area.attribution;
    r.land = area.land;
    r.contours = chart::contoursOf(area, std::array{2.0, 5.0, 10.0, 20.0});
    for (const core::Mark& m : area.marks) {
        r.marks.push_back(chart::chartMarkOf(m, area.ialaRegion));
    }
}

void fillResult(report::RunReport& r, const core::Mission& mission, const RunSummary& summary) {
    r.passed = summary.passed;
    r.whyNot = summary.whyNot;
    r.score = summary.score;
    r.passScore = mission.passScore;
    r.duration_s = summary.simTime_s;
    r.gradedFrom = summary.gradedFrom.empty() ? "the run itself, to the bit" : summary.gradedFrom;
    r.stateHash = summary.stateHash;
    for (const RunSummary::Task& t : summary.tasks) r.tasks.push_back({t.title, t.done, t.time_s});
    for (const RunSummary::Loss& l : summary.losses) {
        r.deductions.push_back(
            {l.time_s, l.title, l.quantity, l.unit, l.value, l.limit, l.points, l.fails, l.place});
    }
    for (const auto& criterion : mission.criteria) {
        double lost = 0.0;
        for (const RunSummary::Loss& l : summary.losses)
            lost += l.id == criterion->terms().id ? l.points : 0.0;
        r.criteria.push_back({criterion->terms().title, criterion->terms().weight, lost});
    }
}

}  // namespace

report::RunReport fillReport(const core::World& world, const core::Mission& mission,
                             const core::Recording& recording, const RunSummary& summary) {
    const core::RecordingHeader& header = recording.header;
    const core::OwnShip& ship = *world.ships[0];
    report::RunReport r;
    r.scenarioName = world.scenarioName;
    r.objective = mission.objective;
    r.competenceCode = mission.competenceCode;
    r.shipName = ship.name;
    r.vesselName = ship.vessel.name;
    r.trainee = header.trainee;
    r.runType = header.runType;
    r.level = header.level;
    r.seed = header.seed;
    r.start = world.start;
    r.utcOffset_min = world.area.utcOffset_min;
    r.timeZone = world.area.timeZone;
    r.weather = weatherLine(world, header.level);
    r.buildId = header.buildId;
    r.shipLength_m = ship.vessel.hull.lengthOverall_m;
    r.shipBeam_m = ship.vessel.hull.beam_m;
    fillResult(r, mission, summary);
    fillTracks(r, world, mission, recording);
    fillChart(r, world);
    return r;
}

}  // namespace sagara::run
