#include "tests/render/support/Samples.h"

namespace sagara::test {

core::Snapshot busySnapshot(std::int64_t tick) {
    core::Snapshot s;
    s.tick = tick;
    s.level = 3;
    core::OwnShipView ship;
    ship.motion = {-1200.5, 830.25, 0.3, 0.05, -0.02, 6.1, 5.2, -0.3, 0.1, 0.01, 0.02, -0.03};
    ship.overGround_mps = {5.0, -1.0};
    ship.rudder_rad = -0.17;
    ship.shafts_rps = {3.1, 3.2};
    ship.lines = {{core::LineStatus::Fast, 31.5, 12e3}, {core::LineStatus::Parted, 3.0, 0.0}};
    core::AnchorState anchor;
    anchor.status = core::AnchorStatus::Veering;
    anchor.onBottom = true;
    anchor.cableOut_m = 82.3;
    anchor.position = {-1190.0, 845.0};
    ship.anchors = {anchor, {}};
    ship.underKeel_m = 4.5;
    ship.aground = true;
    ship.notUnderCommand = true;
    s.ships = {ship};
    s.targets = {{2, {100.0, 200.0}, 0.1, 0.02, 0.03, 1.5, 7.0, 0.01, core::Activity::Trawling},
                 {5, {-100.0, 20.0}, 0, 0, 0, 4.0, 3.0, 0}};
    core::TargetLayout added;
    added.type = core::TargetType::Ferry;
    added.activity = core::Activity::Restricted;
    added.length_m = 61.5;
    added.beam_m = 12.25;
    added.draught_m = 3.5;
    added.name = "Sea Star";
    s.added = {added};
    s.weather.wind = {8.5, 0.8, 0.12};
    s.weather.exposure = core::Exposure::Ocean;
    s.weather.swells[0] = {1.0, 12.0, 1.0, 0.7, 30.0};
    s.weather.current = {0.3, -0.2};
    s.weather.visibility_m = 9000.0;
    s.weather.rain = 0.25;
    s.wind = {9.1, 0.85};
    s.sea.systems = {core::WaveSystem{1.25, 6.5, 3.3, 3.9, 4.0}, core::WaveSystem{1.0, 12.0, 1.0, 0.7, 30.0}};
    s.sea.systems[1].family = core::SpectrumFamily::OchiHubble;
    s.sea.systems[1].law = core::SpreadingLaw::CosN;
    s.sea.systems[1].form = 2.7;
    s.tide_m = 0.42;
    return s;
}

std::vector<link::Message> oneOfEach() {
    using namespace link;
    Nonce nonce;
    nonce.fill(std::byte{7});
    Proof proof;
    proof.fill(std::byte{9});
    ChannelView view{"left", 1, {0.5, -4.0, 0.2}, -1.05, {0.6, 0.5, 0.3, 0.4}, 640, 360, Output::Offscreen};
    link::Setup setup{
        {{"scenario", "{}"}, {"galle", "{\"a\": 1}"}, {{"patrol51", "{}"}, {"esso-osaka", "{}"}}, nullptr},
        42};
    return {Greeting{{1, 2}, nonce, "build"},
            Hello{Role::Observer, "left", proof, "build", 4711},
            Refused{"the channel is taken", {1}},
            Welcome{view},
            setup,
            Ready{},
            Frame{77, {9'990'000}, busySnapshot()},
            Rendered{77, 31'000},
            Show{77, true},
            Shown{77, -123'456'789},
            Ping{3, 1000},
            Pong{3, 1000, 1100, 1200},
            Picture{77, 4, 2, std::vector<std::byte>(32, std::byte{200})},
            Bye{"the exercise is over"}};
}

}  // namespace sagara::test
