#include "core/world/MarkDocument.h"

#include <algorithm>
#include <string_view>

#include "core/world/LightCharacter.h"

namespace sagara::core {
namespace {

constexpr std::size_t kMostMarks = 100;

Light readLight(config::Reader& in, const MarkDefaults& defaults) {
    const config::Range height{0.5, 300.0, "m"}, range{0.1, 40.0, "M"};
    return {in.text("character"),
            defaults.lightHeight_m ? in.numberOr("height_m", *defaults.lightHeight_m, height)
                                   : in.number("height_m", height),
            defaults.lightRange_M ? in.numberOr("range_M", *defaults.lightRange_M, range)
                                  : in.number("range_M", range)};
}

/// As the chart shows it: less what is in brackets.
std::string_view shownName(std::string_view name) { return name.substr(0, name.find(" (")); }

/// Problems of one mark beside those that came before it.
void checkAmong(config::Reader& in, const Mark& mark, const std::vector<Mark>& others, const char* whose) {
    for (const Mark& other : others) {
        if (!mark.id.empty() && other.id == mark.id)
            in.problem("id", "is \"" + mark.id + "\" again", "an id that no other mark has");
        if (!mark.name.empty() && shownName(other.name) == shownName(mark.name))
            in.problem("name", "is \"" + mark.name + "\", as of another mark" + whose,
                       "a name that no other mark has");
    }
}

void checkPlace(config::Reader& in, const Mark& mark, const Area& area) {
    const bool charted = std::any_of(area.depths.begin(), area.depths.end(),
                                     [&](const Grid& grid) { return grid.covers(mark.position); });
    if (!charted) {
        in.problem("at", "is off the chart", "a place on the chart of " + area.name);
    } else if (mark.floating && area.isLand(mark.position)) {
        in.problem("at", "is on land", "a place in the water for a mark that floats");
    }
    const bool stands =
        mark.kind == MarkKind::Lighthouse || mark.kind == MarkKind::Leading || mark.kind == MarkKind::Beacon;
    if (mark.floating && stands)
        in.problem("floating", "is true", "false: lighthouses, leading marks and beacons stand");
}

}  // namespace

Mark readMark(config::Reader& in, const LocalFrame& frame, const MarkDefaults& defaults) {
    Mark m;
    m.id = in.text("id");
    m.name = in.text("name");
    m.kind = in.choice<MarkKind>("kind", {{"lighthouse", MarkKind::Lighthouse},
                                          {"lateral-port", MarkKind::LateralPort},
                                          {"lateral-starboard", MarkKind::LateralStarboard},
                                          {"cardinal-north", MarkKind::CardinalNorth},
                                          {"cardinal-east", MarkKind::CardinalEast},
                                          {"cardinal-south", MarkKind::CardinalSouth},
                                          {"cardinal-west", MarkKind::CardinalWest},
                                          {"isolated-danger", MarkKind::IsolatedDanger},
                                          {"safe-water", MarkKind::SafeWater},
                                          {"special", MarkKind::Special},
                                          {"leading", MarkKind::Leading},
                                          {"beacon", MarkKind::Beacon}});
    m.position = frame.toLocal(in.geoPoint("at"));
    m.floating = in.flagOr("floating", false);
    m.fictional = in.flagOr("fictional", defaults.fictional);
    if (in.has("light")) {
        config::Reader light(in.child("light"));
        m.light = readLight(light, defaults);
        light.rejectUnknownKeys();
    }
    in.textOr("source", "");
    in.rejectUnknownKeys();
    return m;
}

std::vector<Mark> readScenarioMarks(config::Reader& scenario, const Area& area) {
    std::vector<Mark> marks;
    const std::vector<config::Node> nodes = scenario.listOr("marks");
    if (nodes.size() > kMostMarks)
        scenario.problem("marks", "has " + std::to_string(nodes.size()),
                         "at most " + std::to_string(kMostMarks));
    for (const config::Node& node : nodes) {
        config::Reader in(node);
        const Mark mark = readMark(in, area.frame, kScenarioMark);
        if (in.sound()) checkPlace(in, mark, area);
        checkAmong(in, mark, area.marks, " of the area");
        checkAmong(in, mark, marks, "");
        if (mark.light && !mark.light->character.empty() && !LightCharacter::parse(mark.light->character))
            in.problem("light.character", "is \"" + mark.light->character + "\"",
                       "a light as charts have it: Fl R 3s, Fl(2) W 6s, Q(9) W 15s, Iso W 4s, F G");
        marks.push_back(mark);
    }
    return marks;
}

}  // namespace sagara::core
