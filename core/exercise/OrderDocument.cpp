#include "core/exercise/OrderDocument.h"

#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"

namespace sagara::core {
namespace {

/// Index of a name, or nothing and a problem.
std::optional<std::uint8_t> indexOf(config::Reader& in, const char* key,
                                    const std::vector<std::string>& names) {
    const std::string name = in.text(key);
    const auto it = std::find(names.begin(), names.end(), name);
    if (it != names.end()) return static_cast<std::uint8_t>(it - names.begin());
    std::string known;
    for (const std::string& n : names) known += (known.empty() ? "" : ", ") + n;
    if (!name.empty())
        in.problem(key, "is \"" + name + "\"", known.empty() ? "nothing: there are none" : "one of " + known);
    return std::nullopt;
}

const config::Range kRudder{-70.0, 70.0, "deg"}, kDegrees{0.0, 360.0, "deg"};

Order readHelm(config::Reader& in, const OrderNames::Ship&) {
    return HelmOrder{kDegree_rad * in.number("rudder_deg", kRudder)};
}

std::uint8_t readShaft(config::Reader& in, const OrderNames::Ship& ship) {
    return in.has("shaft") ? indexOf(in, "shaft", ship.shafts).value_or(std::uint8_t{0}) : kAllShafts;
}

Order readTelegraph(config::Reader& in, const OrderNames::Ship& ship) {
    TelegraphOrder order{readShaft(in, ship), TelegraphStep::Stop};
    std::vector<std::string> steps;
    for (std::size_t i = 0; i < kTelegraphSteps; ++i)
        steps.emplace_back(telegraphStepName(static_cast<TelegraphStep>(i)));
    if (const auto step = indexOf(in, "step", steps)) order.step = static_cast<TelegraphStep>(*step);
    return order;
}

Order readShaftSpeed(config::Reader& in, const OrderNames::Ship& ship) {
    return ShaftOrder{readShaft(in, ship), kRpm_rps * in.number("speed_rpm", {-3000.0, 3000.0, "rpm"})};
}

Order readAutopilot(config::Reader& in, const OrderNames::Ship&) {
    AutopilotOrder order;
    order.mode = in.choice<AutopilotMode>(
        "mode",
        {{"off", AutopilotMode::Off}, {"heading", AutopilotMode::Heading}, {"track", AutopilotMode::Track}});
    if (order.mode == AutopilotMode::Heading)
        order.heading_rad = kDegree_rad * in.number("heading_deg", kDegrees);
    return order;
}

Order readPilot(config::Reader& in, const OrderNames::Ship&) { return PilotOrder{in.flagOr("engage", true)}; }

Order readLine(config::Reader& in, const OrderNames::Ship& ship) {
    LineOrder order;
    order.line = indexOf(in, "line", ship.lines).value_or(std::uint8_t{0});
    order.action = in.choice<LineAction>("action", {{"hold", LineAction::Hold},
                                                    {"slack", LineAction::Slack},
                                                    {"heave", LineAction::Heave},
                                                    {"letGo", LineAction::LetGo}});
    return order;
}

Order readAnchor(config::Reader& in, const OrderNames::Ship& ship) {
    AnchorOrder order;
    order.anchor = indexOf(in, "anchor", ship.anchors).value_or(std::uint8_t{0});
    order.action = in.choice<AnchorAction>("action", {{"letGo", AnchorAction::LetGo},
                                                      {"veer", AnchorAction::Veer},
                                                      {"hold", AnchorAction::Hold},
                                                      {"heaveIn", AnchorAction::HeaveIn}});
    if (order.action != AnchorAction::Hold)
        order.cable_m = kShackle_m * in.number("shackles", {0.0, 20.0, "shackles"});
    return order;
}

std::optional<double> numberIfGiven(config::Reader& in, const char* key, config::Range range, double unit) {
    if (!in.has(key)) return std::nullopt;
    return unit * in.number(key, range);
}

WaveSystem readSwellOf(const config::Node& node) {
    config::Reader in(node);
    WaveSystem swell;
    swell.significantHeight_m = in.number("height_m", {0.0, 20.0, "m"});
    swell.peakPeriod_s = in.number("period_s", {2.0, 25.0, "s"});
    swell.wavesTo_rad = wrapTwoPi(kDegree_rad * in.number("from_deg", kDegrees) + kPi);
    swell.gamma = in.numberOr("gamma", 3.3, {1.0, 7.0, ""});
    swell.spreading = in.numberOr("spreading", 25.0, {1.0, 100.0, ""});
    in.rejectUnknownKeys();
    return swell;
}

Order readWeather(config::Reader& in, const OrderNames::Ship&) {
    WeatherOrder order;
    order.windSpeed_mps = numberIfGiven(in, "wind_kn", {0.0, 120.0, "kn"}, kKnot_mps);
    order.windFrom_rad = numberIfGiven(in, "windFrom_deg", kDegrees, kDegree_rad);
    order.gustiness = numberIfGiven(in, "gustiness", {0.0, 0.5, ""}, 1.0);
    std::size_t i = 0;
    for (const config::Node& node : in.listOr("swells")) {
        if (i == kMostSwells) node.problem("is one too many", "at most two swells");
        if (i < kMostSwells) order.swells[i++] = readSwellOf(node);
    }
    if (in.has("current_kn")) {
        const double speed_mps = kKnot_mps * in.number("current_kn", {0.0, 15.0, "kn"});
        order.current = speed_mps * unitVector(kDegree_rad * in.number("currentTo_deg", kDegrees));
    }
    order.visibility_m = numberIfGiven(in, "visibility_M", {0.01, 30.0, "M"}, kNauticalMile_m);
    order.rain = numberIfGiven(in, "rain", {0.0, 1.0, ""}, 1.0);
    order.ramp_s = in.numberOr("ramp_s", 60.0, {0.0, 24 * 3600.0, "s"});
    return order;
}

Order readFault(config::Reader& in, const OrderNames::Ship& ship) {
    FaultOrder order;
    order.fault = in.choice<Fault>("fault", {{"steeringPump", Fault::SteeringPump},
                                             {"steeringJam", Fault::SteeringJam},
                                             {"engine", Fault::Engine}});
    if (order.fault == Fault::SteeringPump)
        order.number = static_cast<std::uint8_t>(in.integerOr("pumps", 1, 1, 2));
    if (order.fault == Fault::Engine)
        order.number = indexOf(in, "shaft", ship.shafts).value_or(std::uint8_t{0});
    order.mended = in.flagOr("mended", false);
    return order;
}

Order readTarget(config::Reader& in, const OrderNames& names) {
    TargetOrder order;
    order.target = indexOf(in, "target", names.targets).value_or(std::uint8_t{0});
    order.action = in.choice<TargetAction>("action", {{"appear", TargetAction::Appear},
                                                      {"remove", TargetAction::Remove},
                                                      {"stop", TargetAction::Stop},
                                                      {"resume", TargetAction::Resume},
                                                      {"setSpeed", TargetAction::SetSpeed}});
    if (order.action == TargetAction::SetSpeed)
        order.speed_mps = kKnot_mps * in.number("speed_kn", {0.0, 60.0, "kn"});
    return order;
}

}  // namespace

WaveSystem readSwell(const config::Node& node) { return readSwellOf(node); }

std::optional<NamedOrder> readOrder(config::Reader& in, const OrderNames& names) {
    enum class Kind {
        Helm,
        Telegraph,
        Shaft,
        Autopilot,
        Pilot,
        Line,
        Anchor,
        Weather,
        Fault,
        Target,
        Difficulty,
        Event,
        Finish
    };
    // A new kind of order: its value in Command.h, its reader above and one line here and below.
    const auto kind = in.choiceIfKnown<Kind>("order", {{"helm", Kind::Helm},
                                                       {"telegraph", Kind::Telegraph},
                                                       {"shaft", Kind::Shaft},
                                                       {"autopilot", Kind::Autopilot},
                                                       {"pilot", Kind::Pilot},
                                                       {"line", Kind::Line},
                                                       {"anchor", Kind::Anchor},
                                                       {"weather", Kind::Weather},
                                                       {"fault", Kind::Fault},
                                                       {"target", Kind::Target},
                                                       {"difficulty", Kind::Difficulty},
                                                       {"event", Kind::Event},
                                                       {"finish", Kind::Finish}});
    std::vector<std::string> shipIds;
    for (const auto& ship : names.ships) shipIds.push_back(ship.id);
    NamedOrder named;
    if (in.has("ship")) named.ship = indexOf(in, "ship", shipIds).value_or(std::uint8_t{0});
    if (!kind || names.ships.empty()) return std::nullopt;
    const OrderNames::Ship& ship = names.ships[named.ship];
    switch (*kind) {
        case Kind::Helm:
            named.order = readHelm(in, ship);
            break;
        case Kind::Telegraph:
            named.order = readTelegraph(in, ship);
            break;
        case Kind::Shaft:
            named.order = readShaftSpeed(in, ship);
            break;
        case Kind::Autopilot:
            named.order = readAutopilot(in, ship);
            break;
        case Kind::Pilot:
            named.order = readPilot(in, ship);
            break;
        case Kind::Line:
            named.order = readLine(in, ship);
            break;
        case Kind::Anchor:
            named.order = readAnchor(in, ship);
            break;
        case Kind::Weather:
            named.order = readWeather(in, ship);
            break;
        case Kind::Fault:
            named.order = readFault(in, ship);
            break;
        case Kind::Target:
            named.order = readTarget(in, names);
            break;
        case Kind::Difficulty:
            named.order = DifficultyOrder{static_cast<std::uint8_t>(in.integer("level", 1, 5))};
            break;
        case Kind::Event:
            named.order = TriggerOrder{indexOf(in, "event", names.events).value_or(std::uint8_t{0})};
            break;
        case Kind::Finish:
            named.order = FinishOrder{};
            break;
    }
    return named;
}

Result<std::vector<Command>, config::Problems> loadCommands(const std::string& name, std::string_view text,
                                                            const OrderNames& names) {
    config::Document document(name, text);
    if (!document.isKind("commands", 1)) return document.problems();
    config::Reader in(document.root());
    in.text("document");
    in.integer("version", 1, 1);
    in.textOr("about", "");
    in.textOr("scenario", "");
    std::vector<Command> commands;
    double last_s = 0.0;
    for (const config::Node& node : in.list("commands")) {
        config::Reader item(node);
        const double time_s = item.number("time_s", {0.0, 7 * 24 * 3600.0, "s"});
        if (time_s < last_s) {
            item.problem("time_s", "is " + config::formatNumber(time_s),
                         "not before the command above, " + config::formatNumber(last_s) + " s");
        }
        last_s = time_s;
        const auto order = readOrder(item, names);
        item.rejectUnknownKeys();
        if (order) commands.push_back({std::llround(time_s * kTicksPerSecond), order->ship, order->order});
    }
    in.rejectUnknownKeys();
    return document.finish(std::move(commands));
}

}  // namespace sagara::core
