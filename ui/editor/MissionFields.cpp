#include "core/assess/MissionContext.h"
#include "core/assess/Observation.h"
#include "ui/editor/ScenarioFields.h"

/// Tasks and criteria: the members stand in core/assess; a new kind there is a few lines here.
namespace sagara::ui::editor {
namespace {

const QString kM = QStringLiteral("m"), kMile = QStringLiteral("M"), kKnots = QStringLiteral("kn"),
              kSeconds = QStringLiteral("s"), kDegrees = QStringLiteral("°");

Field limit_m(double low, double high, const QString& label, const QString& hint, double initial) {
    return number("limit_m", label, low, high, kM, hint, initial);
}

}  // namespace

ListSpec speedZoneList() {
    ListSpec spec;
    spec.one = words("zone");
    const Field speed =
        number("speed_kn", words("Speed"), 0.5, 60, kKnots, words("Over the ground, at most"), 6);
    spec.variants = {
        {"near",
         words("about a place"),
         {place("near", words("Place"), words("Of the area, or a position: drag the circle on the chart")),
          number("within_M", words("within"), 0.01, 20, kMile, words("Radius; drag its edge"), 0.5), speed}},
        {"toWaypoint",
         words("up to a waypoint"),
         {reference("toWaypoint", words("Waypoint"), Source::Waypoint, words("Of the route")), speed}}};
    spec.columns = {"*"};
    return spec;
}

ListSpec taskList() {
    ListSpec spec;
    spec.one = words("task");
    spec.idBase = "task";
    spec.common = {idField(words("Names it in reports")),
                   text("title", words("Title"), words("As the trainee reads it"), words("Task"))};
    spec.kindKey = "kind";
    spec.variants = {
        {"spring-off",
         words("Spring off"),
         {references("keep", words("Lines to keep"), Source::Line,
                     words("To spring off on; all others are in")),
          number("swing_deg", words("Swing"), 2, 90, kDegrees, words("Of her heading from where she lay"),
                 12)}},
        {"clear-of-berth",
         words("Clear of the berth"),
         {number("distance_m", words("Clear by"), 1, core::kShoreLimit_m, kM,
                 words("Of quays and shore, all lines in"), 20)}},
        {"gate",
         words("Pass a gate"),
         {places("between", words("Between"), 2,
                 words("Two places; passed away from the route's start. Drag them on the chart"))}},
        {"transit",
         words("Reach a place"),
         {place("to", words("Place"), words("Of the area, or a position: drag the circle on the chart")),
          number("within_M", words("within"), 0.01, 10, kMile, words("Radius; drag its edge"), 0.2)}},
        {"anchor",
         words("Anchor"),
         {place("at", words("Place"), words("Of the area, or a position: drag the circle on the chart")),
          number("within_m", words("Anchor within"), 1, 2000, kM, words("Radius; drag its edge"), 75),
          numbers("shackles", words("Cable, least and most"), 2, 0.5, 20, words("shackles"),
                  words("Of 27.5 m"), Json::array({4, 5})),
          number("speed_kn", words("Lies still below"), 0.05, 3, kKnots, words("Over the ground"), 0.3),
          number("still_s", words("for"), 1, 1800, kSeconds, words("How long she lies still"), 60),
          number("hold_s", words("Anchor holds for"), 0, 1800, kSeconds, words("Not moving on the bottom"),
                 120),
          number("weather_deg", words("Head to wind within"), 5, 180, kDegrees, words("Either side"), 30)}}};
    spec.columns = {"title", "kind", "*"};
    return spec;
}

ListSpec criterionList() {
    ListSpec spec;
    spec.one = words("criterion");
    spec.idBase = "criterion";
    spec.common = {
        idField(words("Names it in reports")),
        text("title", words("Title"), words("As the trainee reads it"), words("Criterion")),
        number("weight", words("Weight"), 0, 100, words("points"), words("The most it can take"), 20),
        number("points", words("Points of a breach"), 0, 100, words("points"),
               words("And again for each half minute it lasts"), 5),
        flag("fails", words("A breach fails the run"), words("Whatever the score"))};
    spec.kindKey = "kind";
    const Field place = editor::place("at", words("Mark"), words("Where the anchor is to be let go"));
    const Field from =
        reference("fromWaypoint", words("From waypoint"), Source::Waypoint, words("Of the route"));
    const Field to = reference("toWaypoint", words("To waypoint"), Source::Waypoint, words("Of the route"));
    spec.variants = {
        {"cross-track", words("Keep to the corridor"), {from}},
        {"speed-limit",
         words("Keep to the speeds"),
         {list("zones", words("Zones"), speedZoneList(), words("The lowest speed that holds counts"))}},
        {"time-limit",
         words("Be done in time"),
         {numbers("limit_min", words("Minutes, level 1 to 5"), core::kLevels, 0.5, 1440, words("min"),
                  words("From the first line let go, or the start"), Json::array({45, 40, 35, 30, 25}))}},
        {"under-keel",
         words("Water under the keel"),
         {limit_m(0, 50, words("At least"), words("Under-keel clearance"), 1.5)}},
        {"passing-distance",
         words("Distance from other ships"),
         {limit_m(1, core::kShipsLimit_m, words("At least"), words("Hull to hull"), 463), optional(from),
          optional(to)}},
        {"contact-speed",
         words("Speed of contact"),
         {number("limit_mps", words("At most"), 0, 10, QStringLiteral("m/s"),
                 words("Against quays and fenders"), 0.15)}},
        {"contact-energy",
         words("Energy of contact"),
         {number("limit_kJ", words("At most"), 0, 1e6, QStringLiteral("kJ"),
                 words("Against quays and fenders"), 60)}},
        {"collision", words("Collision"), {}},
        {"grounding", words("Grounding"), {}},
        {"parted", words("Line or cable parted"), {}},
        {"anchor-place",
         words("Anchor on the mark"),
         {place, limit_m(1, 2000, words("Within"), words("Of the mark"), 50)}},
        {"let-go-speed",
         words("Sternway at let go"),
         {number("least_kn", words("At least"), -5, 5, kKnots, words("Astern over the ground"), 0.3),
          number("most_kn", words("At most"), -5, 5, kKnots, words("Astern over the ground"), 0.8)}},
        {"anchor-drag",
         words("Anchor dragged"),
         {limit_m(0.5, 500, words("At most"), words("Over the bottom"), 10)}}};
    spec.columns = {"title", "kind", "weight", "points", "fails"};
    return spec;
}

}  // namespace sagara::ui::editor
