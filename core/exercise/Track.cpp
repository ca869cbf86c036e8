#include "core/exercise/Track.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/Angle.h"
#include "core/exercise/Observe.h"
#include "core/exercise/SecondExtras.h"

namespace sagara::core {
namespace {

/// Calls visit(field, step) for every number of a sample, in the order of the format; flags count as numbers.
template <typename Visit>
void visitShip(ShipSample& s, Visit&& visit) {
    constexpr double kLength_m = 0.01, kSpeed_mps = 0.001, kAngle_rad = 1e-4;
    ShipMotion& m = s.motion;
    visit(m.north_m, kLength_m);
    visit(m.east_m, kLength_m);
    visit(m.down_m, kLength_m);
    visit(m.roll_rad, kAngle_rad);
    visit(m.pitch_rad, kAngle_rad);
    visit(m.heading_rad, kAngle_rad);
    visit(m.surge_mps, kSpeed_mps);
    visit(m.sway_mps, kSpeed_mps);
    visit(m.yawRate_radps, 1e-5);
    visit(s.rudder_rad, kAngle_rad);
    for (double& shaft : s.shafts_rps) visit(shaft, 1e-3);
    visit(s.score, 0.01);
    Observation& o = s.observation;
    visit(o.level, 1.0);
    visit(o.overGround_mps.north_m, kSpeed_mps);
    visit(o.overGround_mps.east_m, kSpeed_mps);
    visit(o.momentarySpeed_mps, kSpeed_mps);
    visit(o.alongGround_mps, kSpeed_mps);
    visit(o.underKeel_m, kLength_m);
    visit(o.clearOfShore_m, kLength_m);
    visit(o.clearOfShips_m, 0.1);
    visit(o.windFrom_rad, 1e-3);
    visit(o.linesFast, 1.0);
    visit(o.linesOut, 1.0);
    for (AnchorObservation& a : o.anchors) {
        visit(a.down, 1.0);
        visit(a.position.north_m, kLength_m);
        visit(a.position.east_m, kLength_m);
        visit(a.cableOut_m, kLength_m);
        visit(a.dragged_m, kLength_m);
        visit(a.dragSpeed_mps, kSpeed_mps);
    }
}

template <typename Visit>
void visitTarget(TargetSample& t, Visit&& visit) {
    visit(t.present, 1.0);
    visit(t.position.north_m, 0.1);
    visit(t.position.east_m, 0.1);
    visit(t.heading_rad, 1e-3);
    visit(t.speed_mps, 0.01);
}

template <typename Visit>
void visitSample(TrackSample& sample, Visit&& visit) {
    visit(sample.tick, 1.0);
    for (ShipSample& s : sample.ships) visitShip(s, visit);
    for (TargetSample& t : sample.targets) visitTarget(t, visit);
}

/// A number of the track as the type of its field; damaged bytes may give any number.
template <typename Field>
Field fieldOf(double number) {
    if constexpr (std::is_same_v<Field, bool>) return number != 0.0;
    if constexpr (std::is_integral_v<Field>) {
        constexpr double kLow = static_cast<double>(std::numeric_limits<std::int32_t>::min());
        constexpr double kHigh = static_cast<double>(std::numeric_limits<std::int32_t>::max());
        return static_cast<Field>(static_cast<std::int64_t>(std::clamp(number, kLow, kHigh)));
    }
    return static_cast<Field>(number);
}

/// Zigzag (small magnitudes of either sign become small numbers) and seven bits to a byte.
void putVarint(std::int64_t value, Bytes& out) {
    auto rest = (static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63);
    for (; rest >= 0x80; rest >>= 7) out.push_back(static_cast<std::byte>((rest & 0x7f) | 0x80));
    out.push_back(static_cast<std::byte>(rest));
}

bool takeVarint(std::span<const std::byte>& bytes, std::int64_t& value) {
    std::uint64_t rest = 0;
    for (unsigned shift = 0; shift < 64 && !bytes.empty(); shift += 7) {
        const auto byte = static_cast<std::uint64_t>(bytes.front());
        bytes = bytes.subspan(1);
        rest |= (byte & 0x7f) << shift;
        if (byte < 0x80) {
            value = static_cast<std::int64_t>(rest >> 1) ^ -static_cast<std::int64_t>(rest & 1);
            return true;
        }
    }
    return false;
}

}  // namespace

TrackSample sampleOf(const World& world, const State& state) {
    TrackSample sample;
    sample.tick = state.tick;
    for (std::size_t i = 0; i < state.ships.size(); ++i) {
        const OwnShipState& s = state.ships[i];
        ShipSample ship;
        ship.motion = s.motion;
        ship.rudder_rad = s.steering.angle_rad;
        for (std::size_t k = 0; k < kMostShafts; ++k) ship.shafts_rps[k] = s.shafts[k].speed_rps;
        ship.score = i == 0 ? scoreOf(state.assessment) : 100.0;
        ship.observation = observe(world, state, i);
        sample.ships.push_back(ship);
    }
    for (const TargetState& t : state.targets)
        sample.targets.push_back({t.present, t.position, t.heading_rad, t.speed_mps});
    return sample;
}

void sampleAdded(const World& world, const State& state, std::uint32_t sample,
                 std::vector<SecondExtras::Sample>& out) {
    const auto rounded = [](double value, double step, double most) {
        return std::clamp(std::round(value / step), -most, most);
    };
    for (std::size_t i = world.targets.size(); i < state.targets.size(); ++i) {
        const TargetState& t = state.targets[i];
        if (!t.present) continue;
        out.push_back({sample, static_cast<std::uint8_t>(i - world.targets.size()),
                       static_cast<std::int32_t>(rounded(t.position.north_m, 0.1, 2e9)),
                       static_cast<std::int32_t>(rounded(t.position.east_m, 0.1, 2e9)),
                       static_cast<std::int16_t>(rounded(wrapPi(t.heading_rad), 0.001, 32767.0)),
                       static_cast<std::uint16_t>(std::max(0.0, rounded(t.speed_mps, 0.01, 65535.0)))});
    }
}

void TrackCodec::encode(const TrackSample& sample, Bytes& out) {
    TrackSample copy = sample;  // one visitor serves both ways, and reading needs it to be changeable
    std::size_t i = 0;
    visitSample(copy, [&](auto& field, double step) {
        const std::int64_t value = std::llround(static_cast<double>(field) / step);
        if (i == m_last.size()) m_last.push_back(0);
        putVarint(value - m_last[i], out);
        m_last[i++] = value;
    });
}

bool TrackCodec::decode(std::span<const std::byte>& bytes, std::size_t ships, std::size_t targets,
                        TrackSample& sample) {
    sample.ships.resize(ships);
    sample.targets.resize(targets);
    std::size_t i = 0;
    bool ok = true;
    visitSample(sample, [&](auto& field, double step) {
        std::int64_t change = 0;
        ok = ok && takeVarint(bytes, change);
        if (i == m_last.size()) m_last.push_back(0);
        // in unsigned arithmetic: damaged bytes may overflow
        m_last[i] = static_cast<std::int64_t>(static_cast<std::uint64_t>(m_last[i]) +
                                              static_cast<std::uint64_t>(change));
        field = fieldOf<std::remove_reference_t<decltype(field)>>(static_cast<double>(m_last[i++]) * step);
    });
    for (ShipSample& ship : sample.ships) {
        ship.observation.time = timeOfTick(sample.tick);
        ship.observation.position = ship.motion.position();
        ship.observation.heading_rad = ship.motion.heading_rad;
        ship.observation.level = std::clamp(ship.observation.level, 1, kLevels);  // criteria index by it
    }
    return ok;
}

}  // namespace sagara::core
