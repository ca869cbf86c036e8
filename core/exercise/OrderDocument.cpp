#include "core/exercise/OrderDocument.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/Angle.h"
#include "core/exercise/State.h"
#include "core/exercise/TrafficDocument.h"

namespace sagara::core {
namespace {

/// Index of a name, or nothing and a problem.
template <typename Index = std::uint8_t>
std::optional<Index> indexOf(config::Reader& in, const char* key, const std::vector<std::string>& names) {
    const std::string name = in.text(key);
    const auto it = std::find(names.begin(), names.end(), name);
    if (it != names.end()) return static_cast<Index>(it - names.begin());
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

Order readPitch(config::Reader& in, const OrderNames::Ship& ship) {
    return PitchOrder{readShaft(in, ship), 0.01 * in.number("pitch_percent", {-120.0, 150.0, "%"})};
}

Order readAzimuth(config::Reader& in, const OrderNames::Ship& ship) {
    return AzimuthOrder{readShaft(in, ship), kDegree_rad * in.number("angle_deg", {-180.0, 360.0, "deg"})};
}

Order readThruster(config::Reader& in, const OrderNames::Ship& ship) {
    ThrusterOrder order;
    order.thruster = indexOf(in, "thruster", ship.thrusters).value_or(std::uint8_t{0});
    order.share = 0.01 * in.number("thrust_percent", {-100.0, 100.0, "%"});
    return order;
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
                                             {"engine", Fault::Engine},
                                             {"thruster", Fault::Thruster}});
    if (order.fault == Fault::SteeringPump)
        order.number = static_cast<std::uint8_t>(in.integerOr("pumps", 1, 1, 2));
    if (order.fault == Fault::Engine)
        order.number = indexOf(in, "shaft", ship.shafts).value_or(std::uint8_t{0});
    if (order.fault == Fault::Thruster)
        order.number = indexOf(in, "thruster", ship.thrusters).value_or(std::uint8_t{0});
    order.mended = in.flagOr("mended", false);
    return order;
}

/// A target of the scenario by its id, or "added-N": the Nth that is added in the run.
std::uint32_t readTargetIndex(config::Reader& in, const OrderNames& names) {
    constexpr std::string_view kAdded = "added-";
    const std::string id = in.textOr("target", "");
    const auto known = static_cast<std::uint32_t>(names.targets.size());
    const bool isKnown = std::find(names.targets.begin(), names.targets.end(), id) != names.targets.end();
    std::uint32_t number = 0;
    if (!isKnown && id.starts_with(kAdded)) {
        const auto read = std::from_chars(id.data() + kAdded.size(), id.data() + id.size(), number);
        const bool whole = read.ec == std::errc() && read.ptr == id.data() + id.size();
        if (whole && number >= 1 && number <= kMostAddedTargets) return known + number - 1;
    }
    return indexOf<std::uint32_t>(in, "target", names.targets).value_or(0);
}

NorthEast readPlace(config::Reader& in, const char* key, const OrderNames& names) {
    const GeoPoint at = in.geoPoint(key);
    return names.frame ? names.frame->toLocal(at) : NorthEast{};
}

const config::Range kTargetSpeed{0.0, kFastestTarget_mps / kKnot_mps, "kn"};

std::vector<TargetLayout::Waypoint> readPoints(config::Reader& in, const char* key,
                                               const std::vector<config::Node>& nodes,
                                               const OrderNames& names) {
    std::vector<TargetLayout::Waypoint> points;
    if (nodes.size() > kLongestTargetRoute)
        in.problem(key, "has " + std::to_string(nodes.size()) + " points",
                   "at most " + std::to_string(kLongestTargetRoute));
    for (const config::Node& node : nodes) {
        config::Reader item(node);
        const NorthEast at = readPlace(item, "at", names);
        points.push_back({at, kKnot_mps * item.number("speed_kn", kTargetSpeed)});
        item.rejectUnknownKeys();
    }
    return points;
}

Order readAddTarget(config::Reader& in, const OrderNames& names) {
    AddTargetOrder order;
    order.name = in.text("name");
    if (order.name.size() > 60)
        in.problem("name", "has " + std::to_string(order.name.size()) + " bytes", "at most 60");
    order.type = readTargetType(in);
    const auto named = [](Activity a) { return config::Reader::Choice<Activity>{activityName(a), a}; };
    using enum Activity;
    if (in.has("activity"))
        order.activity = in.choice<Activity>(
            "activity", {named(UnderWay), named(Anchored), named(Fishing), named(Trawling), named(Towing),
                         named(NotUnderCommand), named(Restricted), named(Moored), named(Sailing)});
    order.hostile = in.flagOr("hostile", false);
    order.position = readPlace(in, "at", names);
    order.heading_rad = kDegree_rad * in.number("heading_deg", kDegrees);
    order.speed_mps = kKnot_mps * in.number("speed_kn", kTargetSpeed);
    order.length_m = in.number("length_m", {3.0, 400.0, "m"});
    order.beam_m = in.number("beam_m", {1.0, 70.0, "m"});
    order.draught_m = in.number("draught_m", {0.2, 25.0, "m"});
    order.route = readPoints(in, "route", in.listOr("route"), names);
    return order;
}

Order readMoveTarget(config::Reader& in, const OrderNames& names) {
    MoveTargetOrder order;
    order.target = readTargetIndex(in, names);
    order.position = readPlace(in, "at", names);
    order.heading_rad = kDegree_rad * in.number("heading_deg", kDegrees);
    return order;
}

Order readSteerTarget(config::Reader& in, const OrderNames& names) {
    SteerTargetOrder order;
    order.target = readTargetIndex(in, names);
    order.heading_rad = kDegree_rad * in.number("heading_deg", kDegrees);
    order.speed_mps = kKnot_mps * in.number("speed_kn", kTargetSpeed);
    return order;
}

Order readRouteTarget(config::Reader& in, const OrderNames& names) {
    RouteTargetOrder order;
    order.target = readTargetIndex(in, names);
    order.points = readPoints(in, "route", in.list("route"), names);
    return order;
}

Order readNote(config::Reader& in) {
    NoteOrder order;
    order.bookmark = in.flagOr("bookmark", false);
    order.text = order.bookmark ? in.textOr("text", "") : in.text("text");
    if (order.text.size() > kLongestNote_bytes)
        in.problem("text", "has " + std::to_string(order.text.size()) + " bytes",
                   "at most " + std::to_string(kLongestNote_bytes));
    return order;
}

Order readReport(config::Reader& in) {
    const auto named = [](ReportKind k) { return config::Reader::Choice<ReportKind>{reportKindName(k), k}; };
    return ReportOrder{in.choice<ReportKind>(
        "report",
        {named(ReportKind::PortControl), named(ReportKind::Anchored), named(ReportKind::ManOverboard)})};
}

Order readFreeMotions(config::Reader& in) {
    const std::vector<std::string> known{"surge", "sway", "heave", "roll", "pitch", "yaw"};
    FreezeMotionOrder order{0};
    for (const std::string& name : in.texts("free")) {
        const auto it = std::find(known.begin(), known.end(), name);
        if (it == known.end())
            in.problem("free", "names \"" + name + "\"", "surge, sway, heave, roll, pitch, yaw");
        else
            order.free |= static_cast<std::uint8_t>(1U << (it - known.begin()));
    }
    return order;
}

Order readTarget(config::Reader& in, const OrderNames& names) {
    TargetOrder order;
    order.target = readTargetIndex(in, names);
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
        Finish,
        Note,
        Report,
        AddTarget,
        MoveTarget,
        SteerTarget,
        RouteTarget,
        FreeMotions,
        Thruster,
        Pitch,
        Azimuth
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
                                                       {"finish", Kind::Finish},
                                                       {"note", Kind::Note},
                                                       {"report", Kind::Report},
                                                       {"addTarget", Kind::AddTarget},
                                                       {"moveTarget", Kind::MoveTarget},
                                                       {"steerTarget", Kind::SteerTarget},
                                                       {"routeTarget", Kind::RouteTarget},
                                                       {"freeMotions", Kind::FreeMotions},
                                                       {"thruster", Kind::Thruster},
                                                       {"pitch", Kind::Pitch},
                                                       {"azimuth", Kind::Azimuth}});
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
        case Kind::Note:
            named.order = readNote(in);
            break;
        case Kind::Report:
            named.order = readReport(in);
            break;
        case Kind::AddTarget:
            named.order = readAddTarget(in, names);
            break;
        case Kind::MoveTarget:
            named.order = readMoveTarget(in, names);
            break;
        case Kind::SteerTarget:
            named.order = readSteerTarget(in, names);
            break;
        case Kind::RouteTarget:
            named.order = readRouteTarget(in, names);
            break;
        case Kind::FreeMotions:
            named.order = readFreeMotions(in);
            break;
        case Kind::Thruster:
            named.order = readThruster(in, ship);
            break;
        case Kind::Pitch:
            named.order = readPitch(in, ship);
            break;
        case Kind::Azimuth:
            named.order = readAzimuth(in, ship);
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
