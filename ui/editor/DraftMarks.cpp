#include "ui/editor/DraftMarks.h"

#include <set>

#include "core/world/MarkDocument.h"
#include "ui/editor/FieldText.h"

namespace sagara::ui::editor {
namespace {

bool stands(const std::string& kind) { return kind == "lighthouse" || kind == "leading" || kind == "beacon"; }

ListSpec markList() {
    ListSpec spec;
    spec.one = words("mark");
    spec.idBase = "mark";
    spec.ownNames = true;
    Field floats =
        flag("floating", words("Floats"), words("A buoy; else it stands on the ground or on land"));
    floats.optional = false;
    floats.initial = true;
    spec.common = {idField(words("Names the mark in the document")),
                   text("name", words("Name"), words("As on the chart"), words("Mark 1")),
                   choice("kind", words("Kind"), markKinds(),
                          words("IALA system; red and green as in the region of the area")),
                   position("at", words("Position"), words("Or drag it on the chart")),
                   floats,
                   optional(text("light.character", words("Light"),
                                 words("As charts have it: Fl R 3s, Fl(2) W 6s, Q(9) W 15s; empty: unlit"),
                                 QStringLiteral("Fl W 5s"))),
                   optional(number("light.height_m", words("Height of the light"), 0.5, 300,
                                   QStringLiteral("m"), words("Above the water; empty: 4 m"), 4)),
                   optional(number("light.range_M", words("Range of the light"), 0.1, 40, QStringLiteral("M"),
                                   words("Nominal; empty: 4 M"), 4))};
    spec.columns = {"name", "kind", "light.character"};
    return spec;
}

}  // namespace

const std::vector<Option>& markKinds() {
    static const std::vector<Option> kinds{{"lateral-port", words("port hand")},
                                           {"lateral-starboard", words("starboard hand")},
                                           {"isolated-danger", words("isolated danger")},
                                           {"safe-water", words("safe water")},
                                           {"special", words("special")},
                                           {"beacon", words("beacon")},
                                           {"cardinal-north", words("north cardinal")},
                                           {"cardinal-east", words("east cardinal")},
                                           {"cardinal-south", words("south cardinal")},
                                           {"cardinal-west", words("west cardinal")},
                                           {"leading", words("leading mark")},
                                           {"lighthouse", words("lighthouse")}};
    return kinds;
}

Section marksSection() {
    return {"marks",
            words("Marks"),
            QStringLiteral("buoy-default"),
            words("Buoys, beacons and lights of this scenario, beside those of the area. Choose a kind, then "
                  "click on the chart; drag to move."),
            {optional(list("marks", words("Marks"), markList(), words("In any order")))}};
}

Json newMark(const Json& document, const std::string& kind, core::GeoPoint place) {
    std::set<std::string> ids, names;
    for (std::size_t i = 0; i < sizeAt(document, "marks"); ++i) {
        ids.insert(textAt(document, join(join("marks", i), "id")));
        names.insert(textAt(document, join(join("marks", i), "name")));
    }
    Json row = initialRow(markList(), nullptr);
    for (const Option& option : markKinds()) {
        if (option.value != kind) continue;
        const QString label = option.label.left(1).toUpper() + option.label.mid(1);
        row["name"] = freshName((label + QStringLiteral(" 1")).toStdString(), names);
    }
    row["id"] = freshName("mark-1", ids);
    row["kind"] = kind;
    row["at"] = positionJson(place);
    row["floating"] = !stands(kind);
    return row;
}

core::Mark markOf(const Json& row, const core::LocalFrame& frame) {
    core::config::Document document("mark", row.dump());
    core::config::Reader in(document.root());
    return core::readMark(in, frame, core::kScenarioMark);
}

}  // namespace sagara::ui::editor
