#include <gtest/gtest.h>

#include "core/base/Units.h"
#include "core/exercise/Advance.h"
#include "core/exercise/OrderDocument.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::core {
namespace {

class Orders : public ::testing::Test {
protected:
    const std::shared_ptr<const World> world = test::lessonWorld();
    const OrderNames names = orderNames(*world);

    Result<std::vector<Command>, config::Problems> load(const std::string& commands) const {
        return loadCommands(
            "c.json", R"({"document": "commands", "version": 1, "commands": [)" + commands + "]}", names);
    }
    Order one(const std::string& order) const {
        const auto loaded = load("{\"time_s\": 1.5, " + order + "}");
        if (!loaded) throw std::runtime_error(loaded.error().text());
        EXPECT_EQ((*loaded)[0].tick, 75);
        return (*loaded)[0].order;
    }
    std::string problems(const std::string& order) const {
        const auto loaded = load("{\"time_s\": 1.5, " + order + "}");
        return loaded ? "" : loaded.error().text();
    }
};

TEST_F(Orders, EveryKindIsRead) {
    EXPECT_NEAR(std::get<HelmOrder>(one(R"("order": "helm", "rudder_deg": -10)")).rudder_rad,
                -10 * kDegree_rad, 1e-12);
    const auto telegraph =
        std::get<TelegraphOrder>(one(R"("order": "telegraph", "shaft": "starboard", "step": "halfAhead")"));
    EXPECT_EQ(telegraph.shaft, 1);
    EXPECT_EQ(telegraph.step, TelegraphStep::HalfAhead);
    EXPECT_EQ(std::get<ShaftOrder>(one(R"("order": "shaft", "speed_rpm": 120)")).shaft, kAllShafts);
    EXPECT_EQ(std::get<AutopilotOrder>(one(R"("order": "autopilot", "mode": "track")")).mode,
              AutopilotMode::Track);
    EXPECT_FALSE(std::get<PilotOrder>(one(R"("order": "pilot", "engage": false)")).engage);
    EXPECT_EQ(std::get<LineOrder>(one(R"("order": "line", "line": "fore-spring", "action": "letGo")")).line,
              2);
    EXPECT_NEAR(
        std::get<AnchorOrder>(one(R"("order": "anchor", "anchor": "port", "action": "veer", "shackles": 4)"))
            .cable_m,
        4 * kShackle_m, 1e-9);
    EXPECT_NEAR(*std::get<WeatherOrder>(one(R"("order": "weather", "wind_kn": 20)")).windSpeed_mps,
                20 * kKnot_mps, 1e-9);
    EXPECT_EQ(std::get<FaultOrder>(one(R"("order": "fault", "fault": "engine", "shaft": "port")")).fault,
              Fault::Engine);
    EXPECT_EQ(
        std::get<TargetOrder>(one(R"("order": "target", "target": "coaster", "action": "stop")")).target, 0u);
    EXPECT_EQ(std::get<DifficultyOrder>(one(R"("order": "difficulty", "level": 4)")).level, 4);
    EXPECT_EQ(std::get<TriggerOrder>(one(R"("order": "event", "event": "rudder-jams")")).event, 2u);
    EXPECT_TRUE(std::holds_alternative<FinishOrder>(one(R"("order": "finish")")));
    const auto note = std::get<NoteOrder>(one(R"("order": "note", "text": "Late", "bookmark": true)"));
    EXPECT_EQ(note.text, "Late");
    EXPECT_TRUE(note.bookmark);
    EXPECT_EQ(std::get<ReportOrder>(one(R"("order": "report", "report": "manOverboard")")).kind,
              ReportKind::ManOverboard);
    const auto added = std::get<AddTargetOrder>(
        one(R"("order": "addTarget", "name": "Sea Star", "type": "ferry", "at": {"lat": 6.0, "lon": 80.2},
               "heading_deg": 90, "speed_kn": 8, "length_m": 40, "beam_m": 9, "draught_m": 2.5, "hostile": true,
               "route": [{"at": {"lat": 6.01, "lon": 80.2}, "speed_kn": 6}])"));
    EXPECT_EQ(added.type, TargetType::Ferry);
    EXPECT_EQ(added.position, world->area.frame.toLocal({6.0, 80.2}));
    EXPECT_TRUE(added.hostile);
    EXPECT_NEAR(added.route.at(0).speed_mps, 6 * kKnot_mps, 1e-9);
    const auto moved = std::get<MoveTargetOrder>(one(
        R"("order": "moveTarget", "target": "coaster", "at": {"lat": 6.0, "lon": 80.2}, "heading_deg": 180)"));
    EXPECT_EQ(moved.target, 0u);
    const auto steered = std::get<SteerTargetOrder>(
        one(R"("order": "steerTarget", "target": "added-2", "heading_deg": 180, "speed_kn": 5)"));
    EXPECT_EQ(steered.target, world->targets.size() + 1);
    const auto routed = std::get<RouteTargetOrder>(one(
        R"("order": "routeTarget", "target": "coaster", "route": [{"at": {"lat": 6, "lon": 80}, "speed_kn": 5}])"));
    EXPECT_EQ(routed.points.size(), 1u);
    const auto thruster =
        std::get<ThrusterOrder>(one(R"("order": "thruster", "thruster": "bow", "thrust_percent": -40)"));
    EXPECT_EQ(thruster.thruster, 0);
    EXPECT_DOUBLE_EQ(thruster.share, -0.4);
    EXPECT_DOUBLE_EQ(std::get<PitchOrder>(one(R"("order": "pitch", "pitch_percent": -50)")).pitch, -0.5);
    const auto azimuth =
        std::get<AzimuthOrder>(one(R"("order": "azimuth", "shaft": "starboard", "angle_deg": 180)"));
    EXPECT_EQ(azimuth.shaft, 1);
    EXPECT_DOUBLE_EQ(azimuth.angle_rad, kPi);
    EXPECT_EQ(std::get<FaultOrder>(one(R"("order": "fault", "fault": "thruster", "thruster": "bow")")).fault,
              Fault::Thruster);
    EXPECT_EQ(std::get<FreezeMotionOrder>(one(R"("order": "freeMotions", "free": ["surge", "yaw"])")).free,
              33);
}

TEST_F(Orders, WrongOnesSayWhereAndWhatIsAccepted) {
    EXPECT_EQ(problems(R"("order": "line", "line": "breast", "action": "letGo")"),
              "c.json: commands[0].line is \"breast\", expected one of head, stern, fore-spring, aft-spring");
    EXPECT_EQ(problems(R"("order": "shaft", "shaft": "middle", "speed_rpm": 1)"),
              "c.json: commands[0].shaft is \"middle\", expected one of port, starboard");
    EXPECT_EQ(problems(R"("order": "thruster", "thruster": "stern", "thrust_percent": 120)"),
              "c.json: commands[0].thruster is \"stern\", expected one of bow\n"
              "c.json: commands[0].thrust_percent is 120, expected -100 to 100 %");
    EXPECT_EQ(problems(R"("order": "helm", "rudder_deg": 99)"),
              "c.json: commands[0].rudder_deg is 99, expected -70 to 70 deg");
    EXPECT_EQ(problems(R"("order": "helm", "rudder_deg": 5, "speed": 3)"),
              "c.json: commands[0].speed is unknown, expected one of order, rudder_deg, time_s");
    EXPECT_EQ(problems(R"("order": "steerTarget", "target": "added-33", "heading_deg": 1, "speed_kn": 5)")
                  .rfind("c.json: commands[0].target is \"added-33\", expected one of coaster", 0),
              0u);
    EXPECT_EQ(problems(R"("order": "freeMotions", "free": ["jump"])"),
              "c.json: commands[0].free names \"jump\", expected surge, sway, heave, roll, pitch, yaw");
    EXPECT_EQ(problems("\"order\": \"note\", \"text\": \"" + std::string(501, 'x') + "\""),
              "c.json: commands[0].text has 501 bytes, expected at most 500");
    EXPECT_NE(problems(R"("order": "dive")").find("is \"dive\", expected one of helm, telegraph"),
              std::string::npos);
    EXPECT_EQ(load(R"({"time_s": 9, "order": "finish"}, {"time_s": 3, "order": "finish"})").error().text(),
              "c.json: commands[1].time_s is 3, expected not before the command above, 9 s");
}

TEST_F(Orders, FinishEndsTheExerciseGradedAsItStands) {
    State state = startState(*world, 1);
    const std::vector<Command> finish{{0, 0, FinishOrder{}}};
    const auto events = advance(*world, state, finish);
    EXPECT_EQ(events.back().kind, EventKind::Finished);
    EXPECT_TRUE(state.finished);
    EXPECT_TRUE(state.assessment.closed);
    EXPECT_FALSE(passed(world->mission, state.assessment));
}

TEST_F(Orders, OrdersForWhatIsNotThereDoNothing) {
    State state = startState(*world, 1), same = state;
    const std::vector<Command> nonsense{{0, 9, HelmOrder{0.1}},
                                        {0, 0, LineOrder{7, LineAction::LetGo}},
                                        {0, 0, AnchorOrder{5, AnchorAction::LetGo, 50.0}},
                                        {0, 0, TargetOrder{999, TargetAction::Stop, 0.0}},
                                        {0, 0, TriggerOrder{99}},
                                        {0, 0, FaultOrder{Fault::Engine, 9, false}},
                                        {0, 0, TelegraphOrder{kAllShafts, static_cast<TelegraphStep>(77)}}};
    (void)advance(*world, state, nonsense);
    (void)advance(*world, same, {});
    EXPECT_EQ(stateHash(state), stateHash(same));
}

}  // namespace
}  // namespace sagara::core
