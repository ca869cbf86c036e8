#include "ui/editor/ScenarioFields.h"

#include <algorithm>

#include "core/assess/MissionContext.h"
#include "core/exercise/ScenarioVersion.h"
#include "ui/editor/DraftMarks.h"

namespace sagara::ui::editor {
namespace {

Section general() {
    Field start =
        text("startUtc", words("Start"), words("Date and time in UTC; the area's own time beside it"));
    start.kind = FieldKind::Utc;
    Field id = idField(words("Names the scenario in the database; another id is another scenario"));
    return {"general",
            words("General"),
            QStringLiteral("settings-iec"),
            words("What it is called, where and when it takes place."),
            {id, text("name", words("Name"), words("As it stands in lists")),
             reference("area", words("Area"), Source::Area, words("Chart and waters")), start,
             number("longest_min", words("Longest duration"), 1, 1440, QStringLiteral("min"),
                    words("The exercise ends then, whatever is left to do"), 60)}};
}

ListSpec lineList() {
    ListSpec spec;
    spec.one = words("line");
    spec.idBase = "line";
    spec.common = {idField(words("Names the line in tasks, orders and the pilot's script")),
                   reference("fairlead", words("Fairlead"), Source::Fairlead, words("On board")),
                   reference("bollard", words("Bollard"), Source::Bollard, words("Ashore, at her berth"))};
    spec.columns = {"id", "fairlead", "bollard"};
    return spec;
}

Section ownShip() {
    ListSpec ships;
    ships.one = words("own ship");
    ships.idBase = "own";
    ships.common = {
        idField(words("Names her in orders")),
        text("name", words("Name"), words("As the trainee knows her"), words("Own ship")),
        reference("vessel", words("Vessel"), Source::Vessel, words("Her model; from the vessels' list"))};
    ships.variants = {
        {"berth",
         words("alongside a berth"),
         {reference("berth.id", words("Berth"), Source::Berth, words("Drag her on the chart to another")),
          number("berth.along_m", words("Midship along the berth"), 0, 5000, QStringLiteral("m"),
                 words("From the berth's first end"), 50),
          choice("berth.side", words("Side at the quay"),
                 {{"port", words("port")}, {"starboard", words("starboard")}},
                 words("Which side she lies with")),
          list("lines", words("Mooring lines"), lineList(), words("From fairleads to bollards; at most 8"))}},
        {"at",
         words("at sea"),
         {position("at", words("Position"), words("Midship; or drag her on the chart")),
          number("heading_deg", words("Heading"), 0, 360, QStringLiteral("°T"), words("True"), 0),
          optional(number("speed_kn", words("Speed"), 0, 60, QStringLiteral("kn"),
                          words("Ahead through the water; empty: stopped"), 0))}}};
    ships.columns = {"name", "vessel"};
    return {"ownShips",
            words("Own ship"),
            QStringLiteral("own-ship-iec"),
            words("Who is sailed. The first is graded."),
            {list("ownShips", words("Own ships"), ships, words("1 to 8"))}};
}

Section weather() {
    return {
        "weather",
        words("Weather"),
        QStringLiteral("wind"),
        words("At level 3 with factor 1; the wind's own sea follows from the wind."),
        {number("weather.wind.speed_kn", words("Wind speed"), 0, 120, QStringLiteral("kn"),
                words("Mean, 10 m up"), 10),
         number("weather.wind.from_deg", words("Wind from"), 0, 360, QStringLiteral("°T"), words("True"), 0),
         number("weather.wind.gustiness", words("Gustiness"), 0, 0.5, {},
                words("Gusts over mean wind: 0 steady, 0.12 usual at sea, 0.25 in squalls"), 0.1),
         choice("weather.exposure", words("Wind sea grows"),
                {{"inshore", words("inshore")}, {"ocean", words("on the open ocean")}},
                words("Fetch of the wind")),
         list("weather.swells", words("Swells"), swellList(), words("At most two")),
         optional(number("weather.current.speed_kn", words("Current"), 0, 15, QStringLiteral("kn"),
                         words("Empty: none"), 0)),
         optional(number("weather.current.to_deg", words("Current sets to"), 0, 360, QStringLiteral("°T"),
                         words("True"), 0)),
         number("weather.visibility_M", words("Visibility"), 0.01, 30, QStringLiteral("M"),
                words("Nautical miles"), 10),
         optional(number("weather.rain", words("Rain"), 0, 1, {}, words("0 none to 1 a cloudburst"), 0))}};
}

Section levels() {
    ListSpec spec;
    spec.one = words("level");
    spec.fixed = core::kLevels;
    spec.form = false;
    spec.common = {
        number("windFactor", words("Wind ×"), 0.05, 10, {}, words("Times the wind speed"), 1),
        number("seaFactor", words("Sea ×"), 0.05, 10, {}, words("Times the height of the swell"), 1),
        number("visibilityFactor", words("Visibility ×"), 0.05, 10, {}, words("Times the visibility"), 1)};
    spec.columns = {"windFactor", "seaFactor", "visibilityFactor"};
    return {"levels",
            words("Levels"),
            QStringLiteral("speed"),
            words("What difficulty 1 to 5 makes of the weather. Which ships appear is said at each of them."),
            {list("levels", words("Factors"), spec, words("Double-click a cell to change it"))}};
}

Section route() {
    ListSpec spec;
    spec.one = words("waypoint");
    spec.parent = Json{{"name", "Route"}};
    spec.common = {text("name", words("Name"), words("As on the chart"), words("Waypoint")),
                   position("at", words("Position"), words("Or drag it on the chart")),
                   optional(number("radius_M", words("Turn radius"), 0, 5, QStringLiteral("M"),
                                   words("0: no rounding"), 0.1)),
                   optional(number("portXtd_M", words("Corridor to port"), 0.001, 10, QStringLiteral("M"),
                                   words("Of the leg that ends here"), 0.1)),
                   optional(number("starboardXtd_M", words("Corridor to starboard"), 0.001, 10,
                                   QStringLiteral("M"), words("Of the leg that ends here"), 0.1)),
                   optional(number("speedMax_kn", words("Speed at most"), 0.1, 60, QStringLiteral("kn"),
                                   words("On the leg that ends here"), 10))};
    spec.columns = {"name", "at", "speedMax_kn", "radius_M", "portXtd_M", "starboardXtd_M"};
    return {"route",
            words("Route"),
            QStringLiteral("route"),
            words("Waypoints and the corridor of each leg. With \"Add by click\" each click on the chart is "
                  "one more."),
            {optional(text("route.name", words("Name"), words("Of the passage"))),
             list("route.waypoints", words("Waypoints"), spec, words("At least two, or none"))}};
}

ListSpec targetRoute() {
    ListSpec spec;
    spec.one = words("point");
    spec.form = false;
    spec.common = {position("at", words("Position"), words("Or drag it on the chart")),
                   optional(number("speed_kn", words("Speed, kn"), 0, 60, QStringLiteral("kn"),
                                   words("On the way to it"), 5))};
    spec.columns = {"at", "speed_kn"};
    return spec;
}

Section traffic() {
    ListSpec spec;
    spec.one = words("ship");
    spec.idBase = "ship";
    spec.common = {
        idField(words("Names her in orders")),
        text("name", words("Name"), words("Shown on AIS and the chart"), words("Ship")),
        choice("type", words("Type"),
               {{"fishing", words("fishing boat")},
                {"coaster", words("coaster")},
                {"tanker", words("tanker")},
                {"container", words("container ship")},
                {"ferry", words("ferry")},
                {"yacht", words("yacht")},
                {"tug", words("tug")},
                {"fastCraft", words("fast craft")}},
               words("How she looks")),
        choice("behaviour", words("Behaviour"),
               {{"route", words("sails her route once")},
                {"circuit", words("goes round her route")},
                {"lying", words("lies where she is")},
                {"hostile", words("hostile: loiters, closes, harasses")}},
               words("How she moves")),
        optional(
            choice("activity", words("Is"),
                   {{"underWay", words("under way")},
                    {"anchored", words("at anchor")},
                    {"fishing", words("fishing")},
                    {"trawling", words("trawling")},
                    {"towing", words("towing")},
                    {"notUnderCommand", words("not under command")},
                    {"restricted", words("restricted in her ability to manoeuvre")},
                    {"moored", words("moored")},
                    {"sailing", words("under sail")}},
                   words("Her lights and shapes; empty: by her type. At anchor and moored: only who lies"))),
        number("length_m", words("Length"), 3, 400, QStringLiteral("m"), words("Over all"), 15),
        number("beam_m", words("Beam"), 1, 70, QStringLiteral("m"), words("Greatest"), 4),
        number("draught_m", words("Draught"), 0.2, 25, QStringLiteral("m"), words("Deepest"), 1.5),
        optional(integer("fromLevel", words("From level"), 1, core::kLevels,
                         words("Appears from this difficulty on; empty: always"), 1)),
        flag("onEvent", words("Only when an event says so"), words("Hidden until an order makes her appear")),
        optional(reference("picture", words("Picture"), Source::Picture,
                           words("3D model; empty: drawn by her type"))),
        list(
            "route", words("Where she goes"), targetRoute(),
            words(
                "The first is where she starts. With \"Add by click\" each click on the chart is one more"))};
    spec.columns = {"name", "type", "behaviour", "fromLevel"};
    return {"traffic",
            words("Traffic"),
            QStringLiteral("ship"),
            words("Other ships: choose one to drag its points on the chart."),
            {list("traffic", words("Ships"), spec, words("In any order"))}};
}

Section events() {
    ListSpec spec;
    spec.one = words("event");
    spec.idBase = "event";
    spec.common = {
        idField(words("Names it in orders")),
        text("title", words("Title"), words("On the trainer's desk"), words("Event")),
        flag("when.command", words("By hand"), words("Only the trainer, or an order, makes it happen")),
        optional(number("when.time_s", words("At time"), 0, 86400, QStringLiteral("s"),
                        words("Since the start; empty: not by time"), 60)),
        optional(place("when.near", words("When she is near"),
                       words("A place of the area, or a position: drag the circle on the chart"))),
        optional(number("when.within_M", words("within"), 0.01, 50, QStringLiteral("M"),
                        words("Radius of the circle; drag its edge"), 0.2)),
        list("orders", words("What then happens"), orderList(), words("All at the same moment"))};
    spec.columns = {"title", "*"};
    return {"events",
            words("Events"),
            QStringLiteral("time-google"),
            words("What happens by hand, at a time or in a place: faults, weather, ships."),
            {list("events", words("Events"), spec, words("In any order"))}};
}

Section mission() {
    return {
        "mission",
        words("Mission"),
        QStringLiteral("chart-settings"),
        words("What the trainee is told, and the score to pass."),
        {longText("mission.objective", words("Objective"), words("In a sentence")),
         text("mission.competenceCode", words("Competence"),
              words("Of the school's standard, such as an STCW table")),
         longText("mission.briefing", words("Briefing"), words("As it is read before the run")),
         number("mission.passScore", words("Score to pass"), 0, 100, words("points"), words("Of 100"), 70)}};
}

Section listSection(const char* id, const char* path, QString title, const char* icon, QString about,
                    ListSpec spec, QString hint) {
    return {id,
            title,
            QString::fromLatin1(icon),
            std::move(about),
            {list(path, title, std::move(spec), std::move(hint))}};
}

}  // namespace

ListSpec swellList() {
    ListSpec spec;
    spec.one = words("swell");
    spec.form = false;
    spec.common = {
        number("height_m", words("Height, m"), 0, 20, QStringLiteral("m"), words("Significant"), 1),
        number("period_s", words("Period, s"), 2, 25, QStringLiteral("s"), words("Of the peak"), 10),
        number("from_deg", words("From, °T"), 0, 360, QStringLiteral("°"), words("True"), 225)};
    spec.columns = {"height_m", "period_s", "from_deg"};
    return spec;
}

bool Section::holds(const std::string& path) const {
    return std::any_of(fields.begin(), fields.end(), [&](const Field& f) { return within(path, f.key); });
}

std::vector<Section> scenarioSections() {
    return {general(),
            ownShip(),
            weather(),
            levels(),
            route(),
            marksSection(),
            traffic(),
            events(),
            mission(),
            listSection("tasks", "mission.tasks", words("Tasks"), "waypoint-active-iec",
                        words("What is to be done, in this order."), taskList(),
                        words("Done one after the other")),
            listSection("criteria", "mission.criteria", words("Criteria"), "alarm-unacknowledged-iec",
                        words("What costs points. The score is 100 less all of it."), criterionList(),
                        words("A breach takes its points until the weight is used up")),
            listSection("pilot", "pilot", words("Pilot script"), "command-auto-track",
                        words("How the scripted pilot sails it: for demonstrations and the dry run."),
                        pilotList(), words("Done one after the other"))};
}

Json initialRow(const ListSpec& spec, const Variant* variant) {
    Json row = Json::object();
    std::vector<Field> fields = spec.common;
    if (variant) {
        if (!spec.kindKey.empty()) {
            // after id and title, where people look for it
            const auto at = std::find_if(fields.begin(), fields.end(),
                                         [](const Field& f) { return f.key != "id" && f.key != "title"; });
            Field kind;
            kind.key = spec.kindKey;
            kind.initial = variant->value;
            fields.insert(at, kind);
        }
        fields.insert(fields.end(), variant->fields.begin(), variant->fields.end());
    }
    for (const Field& f : fields) {
        const bool optionalHere = f.optional && spec.form;
        if (f.kind == FieldKind::List && !f.optional)
            put(row, f.key, Json::array());
        else if (!optionalHere && !f.initial.is_null())
            put(row, f.key, f.initial);
    }
    return row;
}

Json emptyScenario(const NewScenario& choice) {
    Json document{{"document", "scenario"}, {"version", core::kScenarioDocumentVersion},
                  {"id", choice.id},        {"name", choice.name},
                  {"area", choice.area},    {"startUtc", "2027-01-15T06:00:00Z"},
                  {"longest_min", 60}};
    for (const Field& f : weather().fields)
        if (!f.optional && !f.initial.is_null()) put(document, f.key, f.initial);
    Json factors = Json::array();
    const Section ofLevels = levels();
    for (int i = 0; i < core::kLevels; ++i) factors.push_back(initialRow(*ofLevels.fields[0].list, nullptr));
    document["levels"] = std::move(factors);
    Json ship{{"id", "own"}, {"name", words("Own ship").toStdString()}, {"vessel", choice.vessel}};
    put(ship, "at.lat", choice.lat_deg);
    put(ship, "at.lon", choice.lon_deg);
    ship["heading_deg"] = 0;
    document["ownShips"] = Json::array({ship});
    Json mission{{"objective", ""}, {"competenceCode", ""}, {"briefing", ""}, {"passScore", 70}};
    mission["tasks"] = Json::array();
    mission["criteria"] = Json::array();
    document["mission"] = std::move(mission);
    return document;
}

}  // namespace sagara::ui::editor
