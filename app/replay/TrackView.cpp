#include "app/replay/TrackView.h"

#include <algorithm>

#include "core/assess/Mission.h"
#include "core/exercise/Replay.h"
#include "render/link/Interpolate.h"

namespace sagara::replay {
namespace {

void putShip(core::OwnShipView& view, const core::ShipSample& sample) {
    const core::Observation& o = sample.observation;
    view.motion = sample.motion;
    view.overGround_mps = o.overGround_mps;
    view.rudder_rad = sample.rudder_rad;
    for (std::size_t i = 0; i < view.shafts_rps.size(); ++i) view.shafts_rps[i] = sample.shafts_rps[i];
    view.underKeel_m = o.underKeel_m;
    for (std::size_t i = 0; i < view.lines.size(); ++i) {
        const bool fast = (o.linesFast >> i & 1U) != 0, out = (o.linesOut >> i & 1U) != 0;
        if (fast == view.lines[i].onBollard()) continue;
        view.lines[i].status = fast  ? core::LineStatus::Fast
                               : out ? core::LineStatus::CastOff
                                     : core::LineStatus::In;
    }
    for (std::size_t i = 0; i < view.anchors.size(); ++i) {
        const core::AnchorObservation& a = o.anchors[i];
        view.anchors[i].onBottom = a.down;
        if (!a.down) continue;
        view.anchors[i].position = a.position;
        view.anchors[i].cableOut_m = a.cableOut_m;
        if (view.anchors[i].status == core::AnchorStatus::Home)
            view.anchors[i].status = core::AnchorStatus::Held;
    }
}

core::Snapshot snapshotOf(const core::TrackSample& sample, core::Snapshot view) {
    view.tick = sample.tick;
    for (std::size_t i = 0; i < std::min(view.ships.size(), sample.ships.size()); ++i)
        putShip(view.ships[i], sample.ships[i]);
    if (!sample.ships.empty()) view.score = sample.ships[0].score;
    std::vector<core::TargetView> targets;
    for (std::size_t i = 0; i < sample.targets.size(); ++i) {
        const core::TargetSample& t = sample.targets[i];
        if (!t.present) continue;
        const auto known = std::find_if(view.targets.begin(), view.targets.end(),
                                        [i](const core::TargetView& v) { return v.index == i; });
        core::TargetView v;
        if (known != view.targets.end()) v = *known;
        v.index = i;
        v.position = t.position;
        v.heading_rad = t.heading_rad;
        v.speed_mps = t.speed_mps;
        targets.push_back(v);
    }
    view.targets = std::move(targets);
    return view;
}

}  // namespace

const core::Snapshot& TrackView::backgroundAt(std::int64_t tick) {
    const auto& parts = m_film->recording.states;
    const auto after = std::upper_bound(
        parts.begin(), parts.end(), tick,
        [](std::int64_t t, const core::Recording::StatePart& part) { return t < part.tick; });
    const auto part = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - parts.begin() - 1));
    if (m_background && m_part == part) return *m_background;
    m_part = part;
    const auto state = core::readState(*m_film->world, parts[part]);
    if (state) {
        m_background = core::view(*m_film->world, *state);
    } else if (!m_background) {
        const int level = std::clamp(m_film->recording.header.level, 1, core::kLevels);
        m_background = core::view(*m_film->world, core::startState(*m_film->world, level));
    }
    return *m_background;
}

core::Snapshot TrackView::at(core::SimTime time) {
    core::Snapshot background = backgroundAt(time.us / core::kTick_us);
    background.added = m_film->recording.added;
    for (core::TaskView& task : background.tasks) task = {};
    for (const core::Event& e : m_film->recording.events) {
        if (e.time() > time) break;
        const auto i = static_cast<std::size_t>(e.index);
        if (e.kind == core::EventKind::TaskDone && i < background.tasks.size())
            background.tasks[i] = {true, e.time()};
    }
    const auto& track = m_film->track;
    if (track.empty()) return background;
    const auto later = std::partition_point(track.begin(), track.end(), [time](const core::TrackSample& s) {
        return core::timeOfTick(s.tick) < time;
    });
    if (later == track.end()) return snapshotOf(track.back(), std::move(background));
    if (later == track.begin()) return snapshotOf(*later, std::move(background));
    return link::interpolated(snapshotOf(*(later - 1), background), snapshotOf(*later, background), time);
}

}  // namespace sagara::replay
