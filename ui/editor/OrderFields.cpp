#include "ui/editor/ScenarioFields.h"

/// Orders of events and steps of the pilot: the members stand in core/exercise, OrderDocument.cpp and
/// PilotDocument.cpp; a new kind there is a few lines here.
namespace sagara::ui::editor {
namespace {

const QString kMile = QStringLiteral("M"), kKnots = QStringLiteral("kn"), kSeconds = QStringLiteral("s"),
              kTrue = QStringLiteral("°T"), kDegrees = QStringLiteral("°"), kRpm = QStringLiteral("rpm");

Field shaft() { return optional(reference("shaft", words("Shaft"), Source::Shaft, words("Empty: all"))); }

std::vector<Option> telegraphSteps() {
    return {{"fullAstern", words("full astern")},
            {"halfAstern", words("half astern")},
            {"slowAstern", words("slow astern")},
            {"deadSlowAstern", words("dead slow astern")},
            {"stop", words("stop")},
            {"deadSlowAhead", words("dead slow ahead")},
            {"slowAhead", words("slow ahead")},
            {"halfAhead", words("half ahead")},
            {"fullAhead", words("full ahead")}};
}

std::vector<Field> weatherFields() {
    return {
        optional(number("wind_kn", words("Wind speed"), 0, 120, kKnots, words("Empty: as it is"), 20)),
        optional(number("windFrom_deg", words("Wind from"), 0, 360, kTrue, words("Empty: as it is"), 0)),
        optional(number("gustiness", words("Gustiness"), 0, 0.5, {}, words("Empty: as it is"), 0.1)),
        optional(list("swells", words("Swells"), swellList(), words("None: as they are"))),
        optional(number("current_kn", words("Current"), 0, 15, kKnots, words("Empty: as it is"), 1)),
        optional(
            number("currentTo_deg", words("Current sets to"), 0, 360, kTrue, words("With the current"), 0)),
        optional(number("visibility_M", words("Visibility"), 0.01, 30, kMile, words("Empty: as it is"), 1)),
        optional(number("rain", words("Rain"), 0, 1, {}, words("0 to 1; empty: as it is"), 0.5)),
        optional(number("ramp_s", words("Comes within"), 0, 86400, kSeconds, words("Empty: 60 s"), 60))};
}

std::vector<Variant> orderKinds() {
    const Field shackles =
        optional(number("shackles", words("Cable"), 0, 20, words("shackles"), words("Not with hold"), 3));
    return {
        {"weather", words("Weather"), weatherFields()},
        {"fault",
         words("Fault"),
         {choice("fault", words("Fault"),
                 {{"steeringPump", words("steering pumps")},
                  {"steeringJam", words("rudder jams")},
                  {"engine", words("engine fails")},
                  {"thruster", words("thruster fails")}},
                 words("What fails")),
          optional(integer("pumps", words("Pumps"), 1, 2, words("With steering pumps"), 1)),
          optional(reference("shaft", words("Shaft"), Source::Shaft, words("With an engine"))),
          optional(reference("thruster", words("Thruster"), Source::Thruster, words("With a thruster"))),
          flag("mended", words("Is mended"), words("The fault goes instead of coming"))}},
        {"target",
         words("Other ship"),
         {reference("target", words("Ship"), Source::Target, words("Of the traffic")),
          choice("action", words("Does"),
                 {{"appear", words("appears")},
                  {"remove", words("goes")},
                  {"stop", words("stops")},
                  {"resume", words("goes on")},
                  {"setSpeed", words("changes speed")}},
                 words("What she does")),
          optional(number("speed_kn", words("Speed"), 0, 60, kKnots, words("With a change of speed"), 5))}},
        {"difficulty", words("Difficulty"), {integer("level", words("Level"), 1, 5, words("1 to 5"), 3)}},
        {"event",
         words("Another event"),
         {reference("event", words("Event"), Source::Event, words("Of this scenario"))}},
        {"helm",
         words("Helm"),
         {number("rudder_deg", words("Rudder"), -70, 70, kDegrees, words("To starboard positive"), 0)}},
        {"telegraph",
         words("Telegraph"),
         {choice("step", words("Step"), telegraphSteps(), words("Of the engine telegraph")), shaft()}},
        {"shaft",
         words("Shaft speed"),
         {number("speed_rpm", words("Speed"), -3000, 3000, kRpm, words("Ahead positive"), 100), shaft()}},
        {"thruster",
         words("Thruster"),
         {reference("thruster", words("Thruster"), Source::Thruster, words("Of the ship")),
          number("thrust_percent", words("Thrust"), -100, 100, words("%"), words("To starboard positive"),
                 50)}},
        {"autopilot",
         words("Autopilot"),
         {choice("mode", words("Mode"),
                 {{"off", words("off")},
                  {"heading", words("keeps a heading")},
                  {"track", words("follows the route")}},
                 words("Of the autopilot")),
          optional(
              number("heading_deg", words("Heading"), 0, 360, kTrue, words("With a heading to keep"), 0))}},
        {"pilot",
         words("Scripted pilot"),
         {flag("engage", words("Has the ship"), words("Else hands her back"))}},
        {"line",
         words("Mooring line"),
         {reference("line", words("Line"), Source::Line, words("Of the ship")),
          choice("action", words("Action"),
                 {{"hold", words("hold")},
                  {"slack", words("slack")},
                  {"heave", words("heave")},
                  {"letGo", words("let go")}},
                 words("What the hands do"))}},
        {"anchor",
         words("Anchor"),
         {reference("anchor", words("Anchor"), Source::Anchor, words("Of the ship")),
          choice("action", words("Action"),
                 {{"letGo", words("let go")},
                  {"veer", words("veer")},
                  {"hold", words("hold")},
                  {"heaveIn", words("heave in")}},
                 words("What the hands do")),
          shackles}},
        {"finish", words("End of the exercise"), {}}};
}

}  // namespace

ListSpec orderList() {
    ListSpec spec;
    spec.one = words("order");
    spec.kindKey = "order";
    spec.variants = orderKinds();
    spec.common = {
        optional(reference("ship", words("To"), Source::Ship, words("Empty: the first own ship")))};
    spec.columns = {"order", "*"};
    return spec;
}

ListSpec pilotList() {
    ListSpec spec;
    spec.one = words("step");
    spec.kindKey = "do";
    const auto lines = [](const char* key, const QString& label) {
        return optional(references(key, label, Source::Line, 0, words("Lines of the first own ship")));
    };
    spec.variants = {
        {"lines",
         words("Lines"),
         {lines("letGo", words("Let go")), lines("slack", words("Slack")), lines("heave", words("Heave")),
          lines("hold", words("Hold")),
          optional(number("wait_s", words("Then wait"), 0, 3600, kSeconds, words("Empty: no wait"), 5))}},
        {"run",
         words("Run the engines"),
         {number("rudder_deg", words("Rudder"), -70, 70, kDegrees, words("To starboard positive"), 0),
          numbers("shafts_rpm", words("Shafts"), 0, -3000, 3000, kRpm, words("Ahead positive"), Json()),
          optional(number("headingChange_deg", words("Until turned by"), 1, 360, kDegrees,
                          words("Either way"), 20)),
          optional(number("moved_m", words("Until moved by"), 1, 5000, QStringLiteral("m"),
                          words("From here"), 50)),
          optional(number("slowerThan_kn", words("Until slower than"), 0.05, 30, kKnots,
                          words("Over the ground"), 1)),
          number("atMost_s", words("For at most"), 0, 3600, kSeconds, words("Then the next step"), 120)}},
        {"turn",
         words("Turn"),
         {number("heading_deg", words("To heading"), 0, 360, kTrue, words("On the spot, with shafts opposed"),
                 0),
          number("shaft_rpm", words("Shafts"), 1, 3000, kRpm, words("One ahead, one astern"), 150)}},
        {"track",
         words("Follow the route"),
         {number("cruise_kn", words("Speed"), 0.5, 60, kKnots, words("Where no zone is slower"), 8),
          reference("toWaypoint", words("To waypoint"), Source::Waypoint, words("Of the route")),
          optional(number("before_m", words("End before it by"), 0, 5000, QStringLiteral("m"),
                          words("Empty: at it"), 0)),
          list("speeds", words("Speeds"), speedZoneList(), words("The lowest that holds counts"))}},
        {"anchor",
         words("Anchor"),
         {reference("at", words("Place"), Source::Place, words("Where the anchor is let go")),
          reference("anchor", words("Anchor"), Source::Anchor, words("Of the first own ship")),
          number("first_shackles", words("First brake at"), 0.5, 20, words("shackles"), words("Of 27.5 m"),
                 2),
          number("shackles", words("Brought up to"), 0.5, 20, words("shackles"), words("Of 27.5 m"), 4),
          number("approach_kn", words("Approach at"), 0.5, 10, kKnots, words("Over the ground"), 3)}}};
    spec.columns = {"do", "*"};
    return spec;
}

}  // namespace sagara::ui::editor
