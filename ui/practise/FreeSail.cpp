#include "ui/practise/FreeSail.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QString>
#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "core/exercise/ScenarioVersion.h"

namespace sagara::ui {
namespace {

using core::NorthEast;

constexpr double kBerthClearance_m = 0.5, kSeaClearance_m = 2.0;
constexpr double kBerthEnds_m = 5.0;
constexpr double kFarFromLand_m = 0.4 * core::kNauticalMile_m;

QString q(const std::string& utf8) { return QString::fromStdString(utf8); }
QJsonObject geo(core::GeoPoint p) {
    return {{QStringLiteral("lat"), p.lat_deg}, {QStringLiteral("lon"), p.lon_deg}};
}
std::string written(const QJsonObject& document) {
    return QJsonDocument(document).toJson(QJsonDocument::Indented).toStdString();
}
QJsonObject read(const std::string& text) {
    return QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
}
double wholeDegrees(double rad) {
    return std::fmod(std::round(core::wrapTwoPi(rad) / core::kDegree_rad), 360.0);
}

/// Water enough in a ship's length all round, and land far enough off.
double leastDepth_m(const core::Area& area, NorthEast place, double radius_m) {
    double least_m = area.isLand(place) ? -1.0 : area.depth_m(place);
    for (const double share : {0.5, 1.0})
        for (int i = 0; i < 16; ++i) {
            const NorthEast at = place + share * radius_m * core::unitVector(core::kTwoPi * i / 16.0);
            least_m = std::min(least_m, area.isLand(at) ? -1.0 : area.depth_m(at));
        }
    return least_m;
}

/// The bollard nearest to that point of a ship's side; none when all are far from it.
const core::Berth::Bollard* bollardNear(const core::Berth& berth, NorthEast point, double atMost_m) {
    const core::Berth::Bollard* best = nullptr;
    double nearest_m = atMost_m;
    for (const core::Berth::Bollard& bollard : berth.bollards) {
        const double distance_m = core::distance(bollard.position, point);
        if (distance_m >= nearest_m) continue;
        nearest_m = distance_m;
        best = &bollard;
    }
    return best;
}

/// Head and stern line leading outward, two springs leading inward, from the fairleads of her port side.
std::vector<SailPlace::Line> linesTo(const core::Berth& berth, const core::Vessel& vessel, NorthEast midship,
                                     double heading_rad) {
    std::vector<core::Fairlead> side;
    for (const core::Fairlead& fairlead : vessel.mooring.fairleads)
        if (fairlead.position.y_m < 0.0) side.push_back(fairlead);
    std::sort(side.begin(), side.end(),
              [](const auto& a, const auto& b) { return a.position.x_m > b.position.x_m; });
    if (side.size() < 2) return {};
    const core::HeadingFrame frame(midship, heading_rad);
    const double length_m = vessel.hull.lengthOverall_m;
    const std::size_t last = side.size() - 1;
    struct Wanted {
        const char* id;
        std::size_t fairlead;
        double lead;  ///< ahead of the fairlead, in lengths
    };
    const Wanted wanted[] = {{"head", 0, 0.15},
                             {"stern", last, -0.15},
                             {"fore-spring", std::min<std::size_t>(1, last), -0.4},
                             {"aft-spring", last == 0 ? 0 : last - 1, 0.4}};
    std::vector<SailPlace::Line> lines;
    for (const Wanted& w : wanted) {
        const core::Fairlead& from = side[w.fairlead];
        const NorthEast aim = frame.point({from.position.x_m + w.lead * length_m, -0.6 * vessel.hull.beam_m});
        if (const auto* const bollard = bollardNear(berth, aim, 0.3 * length_m))
            lines.push_back({w.id, from.id, bollard->id});
    }
    return lines;
}

void addBerths(const core::Area& area, const core::Vessel& vessel, std::vector<SailPlace>& places) {
    const core::Hull& hull = vessel.hull;
    for (const core::Berth& berth : area.berths) {
        const double length_m = core::distance(berth.face.a, berth.face.b);
        if (length_m < hull.lengthOverall_m + 2.0 * kBerthEnds_m) continue;
        if (berth.depth_m < hull.draught_m + kBerthClearance_m) continue;
        const NorthEast middle = berth.face.a + 0.5 * length_m * berth.along();
        const double heading_rad = core::bearing_rad(berth.face.a, berth.face.b);
        SailPlace place;
        place.id = place.berth = berth.id;
        place.name = "Alongside: " + berth.name;
        place.along_m = 0.5 * length_m;
        place.at = area.frame.toGeo(middle);
        place.heading_deg = wholeDegrees(heading_rad);
        place.depth_m = berth.depth_m;
        place.lines = linesTo(berth, vessel, middle + 0.5 * hull.beam_m * berth.outward(), heading_rad);
        places.push_back(std::move(place));
    }
}

void addAtSea(const core::Area& area, const core::Vessel& vessel, NorthEast at, double radius_m,
              std::string id, std::string name, std::vector<SailPlace>& places) {
    const double depth_m = leastDepth_m(area, at, radius_m);
    if (depth_m < vessel.hull.draught_m + kSeaClearance_m) return;
    SailPlace place;
    place.id = std::move(id);
    place.name = std::move(name);
    place.at = area.frame.toGeo(at);
    place.depth_m = depth_m;
    place.heading_deg = wholeDegrees(core::bearing_rad(at, {}));
    places.push_back(std::move(place));
}

void addOpenSea(const core::Area& area, const core::Vessel& vessel, std::vector<SailPlace>& places) {
    constexpr const char* kNames[] = {"north", "north-east", "east", "south-east",
                                      "south", "south-west", "west", "north-west"};
    for (const double miles : {2.0, 4.0})
        for (int i = 0; i < 8; ++i) {
            const NorthEast at = miles * core::kNauticalMile_m * core::unitVector(core::kPi / 4.0 * i);
            const std::string distance = std::to_string(static_cast<int>(miles));
            addAtSea(area, vessel, at, kFarFromLand_m, std::string("sea-") + kNames[i] + "-" + distance,
                     "Open sea, " + distance + " M " + kNames[i] + " of the harbour", places);
        }
}

QJsonObject weatherJson(const SailWeather& w) {
    QJsonObject wind{{QStringLiteral("speed_kn"), w.wind_kn},
                     {QStringLiteral("from_deg"), w.windFrom_deg},
                     {QStringLiteral("gustiness"), 0.12}};
    QJsonArray swells;
    if (w.swell_m > 0.0)
        swells.append(QJsonObject{{QStringLiteral("height_m"), w.swell_m},
                                  {QStringLiteral("period_s"), w.swellPeriod_s},
                                  {QStringLiteral("from_deg"), w.swellFrom_deg}});
    return {{QStringLiteral("wind"), wind},
            {QStringLiteral("exposure"), QStringLiteral("inshore")},
            {QStringLiteral("swells"), swells},
            {QStringLiteral("visibility_M"), w.visibility_M},
            {QStringLiteral("rain"), w.rain}};
}

/// As in Basic Navigation, but clear weather stays clear up to level 3.
QJsonArray levelsJson() {
    QJsonArray levels;
    for (const auto& [wind, sea, visibility] :
         {std::array{0.8, 0.8, 1.0}, {0.9, 0.9, 1.0}, {1.0, 1.0, 1.0}, {1.2, 1.2, 0.6}, {1.4, 1.4, 0.4}})
        levels.append(QJsonObject{{QStringLiteral("windFactor"), wind},
                                  {QStringLiteral("seaFactor"), sea},
                                  {QStringLiteral("visibilityFactor"), visibility}});
    return levels;
}

QJsonObject shipJson(const FreeSail& sail) {
    QJsonObject ship{{QStringLiteral("id"), QStringLiteral("own")},
                     {QStringLiteral("name"), q(sail.shipName)},
                     {QStringLiteral("vessel"), q(sail.vessel)}};
    if (sail.place.alongside()) {
        ship[QStringLiteral("berth")] = QJsonObject{{QStringLiteral("id"), q(sail.place.berth)},
                                                    {QStringLiteral("along_m"), sail.place.along_m},
                                                    {QStringLiteral("side"), QStringLiteral("port")}};
        QJsonArray lines;
        for (const SailPlace::Line& line : sail.place.lines)
            lines.append(QJsonObject{{QStringLiteral("id"), q(line.id)},
                                     {QStringLiteral("fairlead"), q(line.fairlead)},
                                     {QStringLiteral("bollard"), q(line.bollard)}});
        ship[QStringLiteral("lines")] = lines;
    } else {
        ship[QStringLiteral("at")] = geo(sail.place.at);
        ship[QStringLiteral("heading_deg")] = sail.heading_deg;
        ship[QStringLiteral("speed_kn")] = sail.speed_kn;
    }
    return ship;
}

QJsonObject missionJson(const FreeSail& sail) {
    return {
        {QStringLiteral("objective"), QStringLiteral("Free sailing: no task, no limits, nothing is graded.")},
        {QStringLiteral("competenceCode"), QStringLiteral("none")},
        {QStringLiteral("briefing"),
         QStringLiteral("You have %1 to yourself. %2. Sail as you like and end when you have had enough.")
             .arg(q(sail.shipName), q(sail.place.name))},
        {QStringLiteral("passScore"), 0},
        {QStringLiteral("tasks"), QJsonArray()},
        {QStringLiteral("criteria"), QJsonArray()}};
}

}  // namespace

std::vector<SailPlace> placesFor(const core::Area& area, const core::Vessel& vessel) {
    std::vector<SailPlace> places;
    addBerths(area, vessel, places);
    for (const core::Place& place : area.places)
        if (place.kind == "anchorage")
            addAtSea(area, vessel, place.position, 2.0 * vessel.hull.lengthOverall_m, place.id, place.name,
                     places);
    addOpenSea(area, vessel, places);
    return places;
}

std::string freeSailScenario(const FreeSail& sail) {
    QJsonObject document{{QStringLiteral("document"), QStringLiteral("scenario")},
                         {QStringLiteral("version"), core::kScenarioDocumentVersion},
                         {QStringLiteral("id"), QStringLiteral("free-sailing")},
                         {QStringLiteral("name"), QStringLiteral("Free sailing: %1").arg(q(sail.shipName))},
                         {QStringLiteral("area"), q(sail.area)},
                         {QStringLiteral("startUtc"), q(sail.weather.startUtc)},
                         {QStringLiteral("longest_min"), 8 * 60},
                         {QStringLiteral("weather"), weatherJson(sail.weather)},
                         {QStringLiteral("levels"), levelsJson()},
                         {QStringLiteral("ownShips"), QJsonArray{shipJson(sail)}},
                         {QStringLiteral("mission"), missionJson(sail)}};
    const QJsonArray traffic = QJsonDocument::fromJson(QByteArray::fromStdString(sail.traffic)).array();
    if (!traffic.isEmpty()) document[QStringLiteral("traffic")] = traffic;
    return written(document);
}

std::string withWeather(const std::string& scenarioText, const SailWeather& weather) {
    QJsonObject document = read(scenarioText);
    if (document.isEmpty()) return scenarioText;  // the loader tells what is wrong with it
    QJsonObject changed = weatherJson(weather);
    const QJsonObject before = document[QStringLiteral("weather")].toObject();
    for (const QString& kept : {QStringLiteral("exposure"), QStringLiteral("current")})
        if (before.contains(kept)) changed[kept] = before[kept];
    document[QStringLiteral("weather")] = changed;
    document[QStringLiteral("startUtc")] = q(weather.startUtc);
    return written(document);
}

SailWeather sailWeatherOf(const core::World& world) {
    const core::Weather& w = world.weather;
    SailWeather weather;
    weather.wind_kn = w.wind.speed_mps / core::kKnot_mps;
    weather.windFrom_deg = wholeDegrees(w.wind.windFrom_rad);
    weather.swell_m = w.swells[0].significantHeight_m;
    if (weather.swell_m > 0.0) {
        weather.swellPeriod_s = w.swells[0].peakPeriod_s;
        weather.swellFrom_deg = wholeDegrees(w.swells[0].wavesTo_rad + core::kPi);
    }
    weather.visibility_M = w.visibility_m / core::kNauticalMile_m;
    weather.rain = w.rain;
    weather.startUtc = core::formatUtc(world.start);
    return weather;
}

std::string peacefulTraffic(const std::string& scenarioText) {
    QJsonArray peaceful;
    for (const QJsonValue& ship : read(scenarioText)[QStringLiteral("traffic")].toArray())
        if (ship.toObject()[QStringLiteral("behaviour")].toString() != QLatin1String("hostile"))
            peaceful.append(ship);
    return QJsonDocument(peaceful).toJson(QJsonDocument::Compact).toStdString();
}

}  // namespace sagara::ui
