#include "render/link/FrameCodec.h"

#include "render/link/schema/link.pb.h"

namespace sagara::link {
namespace {

/// Twelve years: its seconds are exact as doubles.
constexpr std::int64_t kLongest_us = 400'000'000'000'000;

/// Lines and cables are drawn by their length: longer than any ship has.
constexpr double kLongestRope_m = 10'000.0;

void write(core::NorthEast p, wire::NorthEast& w) {
    w.set_north(p.north_m);
    w.set_east(p.east_m);
}
core::NorthEast read(const wire::NorthEast& w, Check& check, const char* what) {
    return {check.number(w.north(), what), check.number(w.east(), what)};
}

void write(const core::ShipMotion& m, wire::Motion& w) {
    w.set_north_m(m.north_m);
    w.set_east_m(m.east_m);
    w.set_down_m(m.down_m);
    w.set_roll_rad(m.roll_rad);
    w.set_pitch_rad(m.pitch_rad);
    w.set_heading_rad(m.heading_rad);
    w.set_surge_mps(m.surge_mps);
    w.set_sway_mps(m.sway_mps);
    w.set_heave_rate_mps(m.heaveRate_mps);
    w.set_roll_rate_radps(m.rollRate_radps);
    w.set_pitch_rate_radps(m.pitchRate_radps);
    w.set_yaw_rate_radps(m.yawRate_radps);
}
core::ShipMotion read(const wire::Motion& w, Check& check) {
    core::ShipMotion m;
    m.north_m = check.number(w.north_m(), "ship.north_m");
    m.east_m = check.number(w.east_m(), "ship.east_m");
    m.down_m = check.number(w.down_m(), "ship.down_m");
    m.roll_rad = check.number(w.roll_rad(), "ship.roll_rad");
    m.pitch_rad = check.number(w.pitch_rad(), "ship.pitch_rad");
    m.heading_rad = check.number(w.heading_rad(), "ship.heading_rad");
    m.surge_mps = check.number(w.surge_mps(), "ship.surge_mps");
    m.sway_mps = check.number(w.sway_mps(), "ship.sway_mps");
    m.heaveRate_mps = check.number(w.heave_rate_mps(), "ship.heaveRate_mps");
    m.rollRate_radps = check.number(w.roll_rate_radps(), "ship.rollRate_radps");
    m.pitchRate_radps = check.number(w.pitch_rate_radps(), "ship.pitchRate_radps");
    m.yawRate_radps = check.number(w.yaw_rate_radps(), "ship.yawRate_radps");
    return m;
}

core::LineState read(const wire::Line& w, Check& check) {
    return {check.choice(w.status(), core::LineStatus::Parted, "line.status"),
            check.between(w.length_m(), 0.0, kLongestRope_m, "line.length_m"),
            check.number(w.tension_n(), "line.tension_N")};
}

core::AnchorState read(const wire::Anchor& w, Check& check) {
    core::AnchorState a;
    a.status = check.choice(w.status(), core::AnchorStatus::CableParted, "anchor.status");
    a.onBottom = w.on_bottom();
    a.cableOut_m = check.between(w.cable_out_m(), 0.0, kLongestRope_m, "anchor.cableOut_m");
    a.position = read(w.position(), check, "anchor.position_m");
    return a;
}

void write(const core::OwnShipView& s, wire::OwnShip& w) {
    write(s.motion, *w.mutable_motion());
    write(s.overGround_mps, *w.mutable_over_ground_mps());
    w.set_rudder_rad(s.rudder_rad);
    for (const double shaft_rps : s.shafts_rps) w.add_shafts_rps(shaft_rps);
    for (const core::LineState& line : s.lines) {
        wire::Line& l = *w.add_lines();
        l.set_status(static_cast<std::uint32_t>(line.status));
        l.set_length_m(line.length_m);
        l.set_tension_n(line.tension_N);
    }
    for (const core::AnchorState& anchor : s.anchors) {
        wire::Anchor& a = *w.add_anchors();
        a.set_status(static_cast<std::uint32_t>(anchor.status));
        a.set_on_bottom(anchor.onBottom);
        a.set_cable_out_m(anchor.cableOut_m);
        write(anchor.position, *a.mutable_position());
    }
    w.set_aground(s.aground);
    w.set_under_keel_m(s.underKeel_m);
    w.set_not_under_command(s.notUnderCommand);
}
core::OwnShipView read(const wire::OwnShip& w, Check& check) {
    core::OwnShipView s;
    s.motion = read(w.motion(), check);
    s.overGround_mps = read(w.over_ground_mps(), check, "ship.overGround_mps");
    s.rudder_rad = check.number(w.rudder_rad(), "ship.rudder_rad");
    for (int i = 0; i < check.count(w.shafts_rps_size(), core::kMostShafts, "shafts"); ++i)
        s.shafts_rps.push_back(check.number(w.shafts_rps(i), "ship.shafts_rps"));
    for (int i = 0; i < check.count(w.lines_size(), core::kMostLines, "lines"); ++i)
        s.lines.push_back(read(w.lines(i), check));
    for (int i = 0; i < check.count(w.anchors_size(), core::kMostAnchors, "anchors"); ++i)
        s.anchors.push_back(read(w.anchors(i), check));
    s.aground = w.aground();
    s.underKeel_m = check.number(w.under_keel_m(), "ship.underKeel_m");
    s.notUnderCommand = w.not_under_command();
    return s;
}

void write(const core::TargetView& t, wire::Target& w) {
    w.set_index(static_cast<std::uint32_t>(t.index));
    write(t.position, *w.mutable_position());
    w.set_down_m(t.down_m);
    w.set_roll_rad(t.roll_rad);
    w.set_pitch_rad(t.pitch_rad);
    w.set_heading_rad(t.heading_rad);
    w.set_speed_mps(t.speed_mps);
    w.set_yaw_rate_radps(t.yawRate_radps);
    w.set_activity(static_cast<std::uint32_t>(t.activity));
}
core::TargetView read(const wire::Target& w, Check& check) {
    core::TargetView t;
    t.index = check.whole(w.index(), 0, kMostTargets - 1, "target.index");
    t.position = read(w.position(), check, "target.position_m");
    t.down_m = check.number(w.down_m(), "target.down_m");
    t.roll_rad = check.number(w.roll_rad(), "target.roll_rad");
    t.pitch_rad = check.number(w.pitch_rad(), "target.pitch_rad");
    t.heading_rad = check.number(w.heading_rad(), "target.heading_rad");
    t.speed_mps = check.number(w.speed_mps(), "target.speed_mps");
    t.yawRate_radps = check.number(w.yaw_rate_radps(), "target.yawRate_radps");
    t.activity = check.choice(w.activity(), core::kLastActivity, "target.activity");
    return t;
}

void write(const core::TargetLayout& t, wire::AddedTarget& w) {
    w.set_type(static_cast<std::uint32_t>(t.type));
    w.set_activity(static_cast<std::uint32_t>(t.activity));
    w.set_length_m(t.length_m);
    w.set_beam_m(t.beam_m);
    w.set_draught_m(t.draught_m);
    w.set_name(t.name);
}
core::TargetLayout read(const wire::AddedTarget& w, Check& check) {
    core::TargetLayout t;
    t.type = check.choice(w.type(), core::kLastTargetType, "added.type");
    t.activity = check.choice(w.activity(), core::kLastActivity, "added.activity");
    t.length_m = check.between(w.length_m(), 3.0, 400.0, "added.length_m");
    t.beam_m = check.between(w.beam_m(), 1.0, 70.0, "added.beam_m");
    t.draught_m = check.between(w.draught_m(), 0.2, 25.0, "added.draught_m");
    t.name = check.text(w.name(), 60, "added.name");
    return t;
}

void write(const core::WaveSystem& s, wire::WaveSystem& w) {
    w.set_significant_height_m(s.significantHeight_m);
    w.set_peak_period_s(s.peakPeriod_s);
    w.set_gamma(s.gamma);
    w.set_waves_to_rad(s.wavesTo_rad);
    w.set_spreading(s.spreading);
}
/// The spectra divide by the period and take powers of the others, hence the limits.
core::WaveSystem read(const wire::WaveSystem& w, Check& check) {
    return {check.between(w.significant_height_m(), 0.0, 50.0, "sea.significantHeight_m"),
            check.between(w.peak_period_s(), 0.01, 100.0, "sea.peakPeriod_s"),
            check.between(w.gamma(), 0.1, 20.0, "sea.gamma"),
            check.number(w.waves_to_rad(), "sea.wavesTo_rad"),
            check.between(w.spreading(), 0.0, 1000.0, "sea.spreading")};
}

void write(const core::SeaSystem& s, wire::WaveSystem& w) {
    write(static_cast<const core::WaveSystem&>(s), w);
    w.set_family(static_cast<std::uint32_t>(s.family));
    w.set_law(static_cast<std::uint32_t>(s.law));
    w.set_form(s.form);
}
core::SeaSystem readSea(const wire::WaveSystem& w, Check& check) {
    core::SeaSystem s(read(w, check));
    s.family = check.choice(w.family(), core::SpectrumFamily::Band, "sea.family");
    s.law = check.choice(w.law(), core::SpreadingLaw::CosN, "sea.law");
    if (s.family != core::SpectrumFamily::Jonswap) s.form = check.between(w.form(), 1e-3, 20.0, "sea.form");
    return s;
}

void write(const core::Weather& s, wire::Weather& w) {
    w.set_wind_mps(s.wind.speed_mps);
    w.set_wind_from_rad(s.wind.windFrom_rad);
    w.set_gustiness(s.wind.gustiness);
    w.set_exposure(static_cast<std::uint32_t>(s.exposure));
    for (const core::WaveSystem& swell : s.swells) write(swell, *w.add_swells());
    write(s.current, *w.mutable_current_mps());
    w.set_visibility_m(s.visibility_m);
    w.set_rain(s.rain);
}
core::Weather read(const wire::Weather& w, Check& check) {
    core::Weather s;
    s.wind = {check.between(w.wind_mps(), 0.0, 200.0, "weather.wind_mps"),
              check.number(w.wind_from_rad(), "weather.windFrom_rad"),
              check.number(w.gustiness(), "weather.gustiness")};
    s.exposure = check.choice(w.exposure(), core::Exposure::Inshore, "weather.exposure");
    for (int i = 0; i < check.count(w.swells_size(), core::kMostSwells, "swells"); ++i)
        s.swells[static_cast<std::size_t>(i)] = read(w.swells(i), check);
    s.current = read(w.current_mps(), check, "weather.current_mps");
    s.visibility_m = check.between(w.visibility_m(), 0.0, 1e6, "weather.visibility_m");
    s.rain = check.between(w.rain(), 0.0, 1.0, "weather.rain");
    return s;
}

}  // namespace

Kind write(const Frame& frame, wire::Frame& w) {
    const core::Snapshot& s = frame.snapshot;
    w.set_number(frame.number);
    w.set_time_us(frame.time.us);
    w.set_tick(s.tick);
    w.set_level(static_cast<std::uint32_t>(s.level));
    for (const core::OwnShipView& ship : s.ships) write(ship, *w.add_ships());
    for (const core::TargetView& target : s.targets) write(target, *w.add_targets());
    for (const core::TargetLayout& target : s.added) write(target, *w.add_added());
    write(s.weather, *w.mutable_weather());
    w.set_wind_mps(s.wind.speed_mps);
    w.set_wind_from_rad(s.wind.windFrom_rad);
    for (const core::SeaSystem& system : s.sea.systems) write(system, *w.add_sea());
    w.set_tide_m(s.tide_m);
    return Kind::Frame;
}

Frame read(const wire::Frame& w, Check& check) {
    const auto beyond = [](std::int64_t value) { return value > kLongest_us || value < -kLongest_us; };
    Frame frame;
    core::Snapshot& s = frame.snapshot;
    frame.number = w.number();
    frame.time.us = w.time_us();
    s.tick = w.tick();
    if (beyond(frame.time.us) || beyond(s.tick)) {
        check.refuse("the time is beyond all exercises");
    }
    s.level = static_cast<int>(check.whole(w.level(), 1, core::kLevels, "level"));
    for (int i = 0; i < check.count(w.ships_size(), kMostShips, "own ships"); ++i)
        s.ships.push_back(read(w.ships(i), check));
    for (int i = 0; i < check.count(w.targets_size(), kMostTargets, "targets"); ++i)
        s.targets.push_back(read(w.targets(i), check));
    for (int i = 0; i < check.count(w.added_size(), core::kMostAddedTargets, "added targets"); ++i)
        s.added.push_back(read(w.added(i), check));
    s.weather = read(w.weather(), check);
    s.wind = {check.between(w.wind_mps(), 0.0, 500.0, "wind_mps"),
              check.number(w.wind_from_rad(), "windFrom_rad")};
    for (int i = 0; i < check.count(w.sea_size(), kMostSeaSystems, "wave systems"); ++i)
        s.sea.systems.push_back(readSea(w.sea(i), check));
    s.tide_m = check.number(w.tide_m(), "tide_m");
    return frame;
}

}  // namespace sagara::link
