#include <algorithm>
#include <iterator>
#include <set>

#include "core/base/Angle.h"
#include "core/exercise/OrderDocument.h"
#include "core/exercise/PilotDocument.h"
#include "core/exercise/ScenarioVersion.h"
#include "core/exercise/SeaDocument.h"
#include "core/exercise/StartCheck.h"
#include "core/exercise/TrafficDocument.h"
#include "core/exercise/World.h"
#include "core/seakeeping/SeaHulls.h"
#include "core/world/MarkDocument.h"

/// Reading of the scenario document and everything that is worked out from it once.
namespace sagara::core {
namespace {

const config::Range kDegrees{0.0, 360.0, "deg"};

class WorldBuilder {
public:
    /// `hulls`: null for a world to be looked at.
    WorldBuilder(config::Reader& in, Area area, const std::vector<Vessel>& vessels, SeaHulls* hulls,
                 std::uint64_t seed)
        : m_in(in),
          m_vessels(vessels),
          m_hulls(hulls),
          m_world(std::make_shared<World>(std::move(area), seed)) {}

    std::shared_ptr<World> build() {
        readIdentity();
        std::vector<Mark> marks = readScenarioMarks(m_in, m_world->area);
        std::move(marks.begin(), marks.end(), std::back_inserter(m_world->area.marks));
        m_world->tide = TidePrediction(m_world->area.meanTideLevel_m, m_world->area.tide, m_world->start);
        readWeather();
        readLevels();
        readRoute();
        for (const config::Node& node : m_in.list("ownShips")) readShip(node);
        if (m_world->ships.empty() || m_world->ships.size() > 8) {
            m_in.problem("ownShips", "has " + std::to_string(m_world->ships.size()), "1 to 8 ships");
        }
        m_world->targets = readTraffic(m_in, m_world->area.frame);
        if (!m_world->ships.empty()) {
            const MissionContext context{m_world->area, m_world->route, m_world->path,
                                         m_world->ships[0]->lineIds};
            readEvents(context);
            config::Reader mission(m_in.child("mission"));
            m_world->mission = readMission(mission, context);
            m_world->pilot = readPilotScript(m_in, context, m_world->ships[0]->vessel);
            checkStart(*m_world, m_in);
        }
        m_in.rejectUnknownKeys();
        return m_world;
    }

private:
    void readIdentity() {
        m_in.text("document");
        m_in.integer("version", 1, kScenarioDocumentVersion);
        m_world->scenarioId = m_in.id("id");
        m_world->scenarioName = m_in.text("name");
        m_in.id("area");
        const std::string start = m_in.text("startUtc");
        const auto utc = parseUtc(start);
        if (!utc && !start.empty())
            m_in.problem("startUtc", "is \"" + start + "\"", "an instant such as 2027-01-15T03:30:00Z");
        m_world->start = utc.value_or(Utc{});
        m_world->longest_s = 60.0 * m_in.number("longest_min", {1.0, 24.0 * 60.0, "min"});
    }

    void readWeather() {
        config::Reader in(m_in.child("weather"));
        Weather& w = m_world->weather;
        config::Reader wind(in.child("wind"));
        w.wind.speed_mps = kKnot_mps * wind.number("speed_kn", {0.0, 120.0, "kn"});
        w.wind.windFrom_rad = kDegree_rad * wind.number("from_deg", kDegrees);
        w.wind.gustiness = wind.number("gustiness", {0.0, 0.5, ""});
        readWindShape(wind);
        wind.rejectUnknownKeys();
        w.exposure =
            in.choice<Exposure>("exposure", {{"inshore", Exposure::Inshore}, {"ocean", Exposure::Ocean}});
        std::size_t i = 0;
        for (const config::Node& node : in.listOr("swells")) {
            if (i == kMostSwells) node.problem("is one too many", "at most two swells");
            if (i < kMostSwells) w.swells[i++] = readSwell(node);
        }
        if (in.has("current")) {
            config::Reader current(in.child("current"));
            const double speed_mps = kKnot_mps * current.number("speed_kn", {0.0, 15.0, "kn"});
            w.current = speed_mps * unitVector(kDegree_rad * current.number("to_deg", kDegrees));
            current.rejectUnknownKeys();
        }
        if (in.has("sea")) {
            config::Reader sea(in.child("sea"));
            m_world->sea = readSea(sea);
            w.windSea = 0.0;
            w.ownSea = 1.0;
        }
        readStreamsOf(in);
        w.visibility_m = kNauticalMile_m * in.number("visibility_M", {0.01, 30.0, "M"});
        w.rain = in.numberOr("rain", 0.0, {0.0, 1.0, ""});
        in.rejectUnknownKeys();
    }

    void readWindShape(config::Reader& wind) {
        if (wind.has("gustSpectrum")) {
            const auto spectrum =
                wind.choice<GustSpectrum>("gustSpectrum", {{"davenport", GustSpectrum::Davenport},
                                                           {"harris", GustSpectrum::Harris},
                                                           {"kaimal", GustSpectrum::Kaimal},
                                                           {"froya", GustSpectrum::Froya}});
            m_world->gusts = GustTable(m_world->seed, spectrum);
        }
        if (wind.has("profile"))
            m_world->windProfile =
                wind.choice<WindProfile>("profile", {{"uniform", WindProfile::Uniform},
                                                     {"power", WindProfile::Power},
                                                     {"logarithmic", WindProfile::Logarithmic},
                                                     {"froya", WindProfile::Froya}});
    }

    /// The scenario's own streams, or else the area's.
    void readStreamsOf(config::Reader& weather) {
        m_world->streams = m_world->area.streams;
        if (weather.has("streams")) {
            config::Reader in(weather.child("streams"));
            m_world->streams = readStreams(in, m_world->area.frame);
            if (m_world->streams.isTidal() && m_world->area.tide.empty())
                weather.problem("streams", "go by the hour",
                                "an area with a tide, or fields without \"byHour\"");
        }
        if (m_world->streams.isTidal()) m_world->highWaters = highWatersOf(m_world->tide, m_world->longest_s);
    }

    void readLevels() {
        const std::vector<config::Node> nodes = m_in.list("levels");
        if (m_in.has("levels") && nodes.size() != kLevels) {
            m_in.problem("levels", "has " + std::to_string(nodes.size()), "5, one for each difficulty");
        }
        for (std::size_t i = 0; i < std::min<std::size_t>(nodes.size(), kLevels); ++i) {
            config::Reader in(nodes[i]);
            const config::Range factor{0.05, 10.0, ""};
            m_world->levels[i] = {in.number("windFactor", factor), in.number("seaFactor", factor),
                                  in.number("visibilityFactor", factor)};
            in.rejectUnknownKeys();
        }
    }

    void readRoute() {
        if (!m_in.has("route")) return;
        config::Reader in(m_in.child("route"));
        m_world->route.name = in.text("name");
        for (const config::Node& node : in.list("waypoints")) {
            config::Reader item(node);
            Route::Waypoint w;
            w.name = item.text("name");
            w.position = m_world->area.frame.toLocal(item.geoPoint("at"));
            w.turnRadius_m = kNauticalMile_m * item.numberOr("radius_M", 0.0, {0.0, 5.0, "M"});
            w.portLimit_m = kNauticalMile_m * item.numberOr("portXtd_M", 0.1, {0.001, 10.0, "M"});
            w.starboardLimit_m = kNauticalMile_m * item.numberOr("starboardXtd_M", 0.1, {0.001, 10.0, "M"});
            w.speedMax_mps = kKnot_mps * item.numberOr("speedMax_kn", 60.0, {0.1, 60.0, "kn"});
            item.rejectUnknownKeys();
            const auto& all = m_world->route.waypoints;
            if (!all.empty() && distance(all.back().position, w.position) < 1.0) {
                item.problem("at", "is the place of the waypoint before", "waypoints at least 1 m apart");
            } else {
                m_world->route.waypoints.push_back(w);
            }
        }
        in.rejectUnknownKeys();
        if (m_world->route.waypoints.size() < 2) {
            in.problem("waypoints", "has " + std::to_string(m_world->route.waypoints.size()), "at least two");
            m_world->route.waypoints.clear();
            return;
        }
        m_world->path = RoutePath(m_world->route);
    }

    void readShip(const config::Node& node) {
        config::Reader in(node);
        const std::string id = in.id("id"), name = in.text("name"), vesselId = in.id("vessel");
        const auto it = std::find_if(m_vessels.begin(), m_vessels.end(),
                                     [&](const Vessel& v) { return v.id == vesselId; });
        if (it == m_vessels.end()) return;  // the missing document is reported where documents are collected
        if (!m_shipIds.insert(id).second) in.problem("id", "is \"" + id + "\" again", "each id once");
        std::string model = in.textOr("model", "");
        if (const auto known = it->model(model); !known) {
            in.problem("model", "is \"" + model + "\"", known.error());
            model.clear();
        }
        auto ship =
            std::make_unique<OwnShip>(id, name, *it, model, m_hulls ? m_hulls->of(it->hull) : nullptr);
        if (in.has("berth")) {
            readBerth(in, *ship);
        } else {
            readPosition(in, *ship);
        }
        in.rejectUnknownKeys();
        m_world->ships.push_back(std::move(ship));
    }

    /// Alongside: "berth" names it, "along_m" is midship's distance from the face's first point, "side" the
    /// side at the quay.
    void readBerth(config::Reader& in, OwnShip& ship) {
        config::Reader at(in.child("berth"));
        const std::string berthId = at.text("id");
        const Berth* berth = m_world->area.findBerth(berthId);
        if (!berth && !berthId.empty())
            at.problem("id", "is \"" + berthId + "\"", "a berth of area " + m_world->area.id);
        const double along_m = at.number("along_m", {0.0, 5000.0, "m"});
        const bool port = at.choice<bool>("side", {{"port", true}, {"starboard", false}});
        at.rejectUnknownKeys();
        const std::vector<config::Node> lines = in.listOr("lines");
        if (!berth) return;
        double fender_m = 0.0;
        for (const Fender& f : berth->fenders) fender_m = std::max(fender_m, f.thickness_m);
        const double off_m = fender_m + 0.5 * ship.vessel.hull.beam_m;
        const NorthEast midship = berth->face.a + along_m * berth->along() + off_m * berth->outward();
        ship.start.north_m = midship.north_m;
        ship.start.east_m = midship.east_m;
        // the face runs with the water on the right: along it she has the quay to port
        ship.start.heading_rad = wrapTwoPi(bearing_rad(berth->face.a, berth->face.b) + (port ? 0.0 : kPi));
        for (const config::Node& node : lines) readLine(node, ship);
    }

    void readLine(const config::Node& node, OwnShip& ship) {
        config::Reader in(node);
        const std::string id = in.id("id"), fairleadId = in.text("fairlead"), bollardId = in.text("bollard");
        const Fairlead* fairlead = ship.vessel.mooring.find(fairleadId);
        if (!fairlead && !fairleadId.empty())
            in.problem("fairlead", "is \"" + fairleadId + "\"", "a fairlead of vessel " + ship.vessel.id);
        const Berth::Bollard* bollard = m_world->area.findBollard(bollardId);
        if (!bollard && !bollardId.empty())
            in.problem("bollard", "is \"" + bollardId + "\"", "a bollard of area " + m_world->area.id);
        if (std::count(ship.lineIds.begin(), ship.lineIds.end(), id))
            in.problem("id", "is \"" + id + "\" again", "each id once");
        if (ship.lines.size() == kMostLines)
            node.problem("is one too many", "at most " + std::to_string(kMostLines) + " lines");
        in.rejectUnknownKeys();
        if (!fairlead || !bollard || ship.lines.size() == kMostLines) return;
        ship.lineIds.push_back(id);
        ship.lines.push_back({fairlead->position, bollard->position});
    }

    /// Under way or adrift: "at", "heading_deg", "speed_kn" through the water.
    void readPosition(config::Reader& in, OwnShip& ship) {
        const NorthEast at = m_world->area.frame.toLocal(in.geoPoint("at"));
        ship.start.north_m = at.north_m;
        ship.start.east_m = at.east_m;
        ship.start.heading_rad = kDegree_rad * in.number("heading_deg", kDegrees);
        ship.start.surge_mps = kKnot_mps * in.numberOr("speed_kn", 0.0, {0.0, 60.0, "kn"});
        ship.startShafts_rps.fill(ship.start.surge_mps / ship.advancePerRev_m);
    }

    void readEvents(const MissionContext& context) {
        OrderNames names = orderNames(*m_world);
        const std::vector<config::Node> nodes = m_in.listOr("events");
        for (const config::Node& node : nodes) {
            config::Reader in(node);
            if (in.has("id")) names.events.push_back(in.textOr("id", ""));
        }
        for (const config::Node& node : nodes) m_world->events.push_back(readEvent(node, context, names));
    }

    ScenarioEvent readEvent(const config::Node& node, const MissionContext& context,
                            const OrderNames& names) {
        config::Reader in(node);
        ScenarioEvent event;
        event.id = in.id("id");
        event.title = in.text("title");
        config::Reader when(in.child("when"));
        if (when.has("time_s")) event.trigger.time_s = when.number("time_s", {0.0, 24 * 3600.0, "s"});
        if (when.has("near")) {
            event.trigger.zone = true;
            event.trigger.centre = context.readPlace(when, "near");
            event.trigger.radius_m = kNauticalMile_m * when.number("within_M", {0.01, 50.0, "M"});
        }
        if (!event.trigger.time_s && !event.trigger.zone && !when.flagOr("command", false)) {
            when.problem("command", "is missing", "time_s, near with within_M, or command: true");
        }
        when.rejectUnknownKeys();
        for (const config::Node& item : in.list("orders")) {
            config::Reader order(item);
            const auto given = readOrder(order, names);
            order.rejectUnknownKeys();
            if (given) event.orders.push_back({given->ship, given->order});
        }
        in.rejectUnknownKeys();
        return event;
    }

    config::Reader& m_in;
    const std::vector<Vessel>& m_vessels;
    SeaHulls* m_hulls;
    std::set<std::string> m_shipIds;
    std::shared_ptr<World> m_world;
};

}  // namespace

World::World(Area worldArea, std::uint64_t worldSeed)
    : seed(worldSeed), area(std::move(worldArea)), waves(worldSeed, area.waveDepth_m), gusts(worldSeed) {}

OrderNames orderNames(const World& world) {
    OrderNames names;
    names.frame = world.area.frame;
    for (const auto& ship : world.ships) {
        OrderNames::Ship s{ship->id, ship->lineIds, {}, {}, {}};
        for (const PropulsionUnit& unit : ship->vessel.propulsion.units) s.shafts.push_back(unit.id);
        for (const AnchorGear& anchor : ship->vessel.groundTackle.anchors) s.anchors.push_back(anchor.id);
        for (const Thruster& thruster : ship->vessel.thrusters.units) s.thrusters.push_back(thruster.id);
        names.ships.push_back(std::move(s));
    }
    for (const TargetLayout& target : world.targets) names.targets.push_back(target.id);
    for (const ScenarioEvent& event : world.events) names.events.push_back(event.id);
    return names;
}

Result<std::shared_ptr<const World>, config::Problems> buildWorld(const ExerciseDocuments& documents,
                                                                  std::uint64_t seed, WorldUse use) {
    config::Document scenario(documents.scenario.name, documents.scenario.text);
    scenario.isKind("scenario", kScenarioDocumentVersion);
    auto area = loadArea(documents.area.name, documents.area.text);
    if (!area) scenario.problems().append(area.error());
    std::vector<Vessel> vessels;
    for (const NamedText& text : documents.vessels) {
        auto vessel = loadVessel(text.name, text.text);
        if (vessel) vessels.push_back(std::move(vessel).value());
        if (!vessel) scenario.problems().append(vessel.error());
    }
    if (!scenario.problems().empty()) return scenario.problems();
    config::Reader in(scenario.root());
    const std::shared_ptr<SeaHulls> hulls = documents.hulls ? documents.hulls : std::make_shared<SeaHulls>();
    auto world = WorldBuilder(in, std::move(area).value(), vessels,
                              use == WorldUse::Sail ? hulls.get() : nullptr, seed)
                     .build();
    world->use = use;
    world->documents = documents;
    return scenario.finish(std::shared_ptr<const World>(std::move(world)));
}

}  // namespace sagara::core
