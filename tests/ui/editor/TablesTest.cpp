// The tables of fields against the loader: what they make it takes, and what it knows they have.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/support/exercise/Lesson.h"
#include "ui/editor/DraftMarks.h"

namespace sagara::ui::editor {
namespace {

Json lesson() { return Json::parse(test::lessonText()); }

std::string problemsWith(const std::string& path, Json value) {
    Json document = lesson();
    put(document, path, std::move(value));
    return test::problemsOf(document.dump());
}

/// Whether a table has a field for every member of a value.
void expectKnown(const std::vector<Field>& fields, const std::string& kindKey, const Json& value,
                 const std::string& path) {
    for (const auto& [key, member] : value.items()) {
        const std::string at = join(path, key);
        bool known = key == kindKey;
        for (const Field& f : fields) {
            if (f.key != key && !f.key.starts_with(key + ".")) continue;
            known = true;
            if (f.key == key && f.kind == FieldKind::List)
                for (std::size_t i = 0; i < member.size(); ++i)
                    expectKnown(f.list->fieldsOf(member[i]), f.list->kindKey, member[i], join(at, i));
        }
        EXPECT_TRUE(known) << at;
    }
}

TEST(EditorTables, HaveAFieldForEveryMemberOfTheLesson) {
    std::vector<Field> all;
    for (const Section& s : scenarioSections())
        for (const Field& f : s.fields) all.push_back(f);
    Json document = lesson();
    document.erase("document");
    document.erase("version");
    const Json mission = document["mission"];
    expectKnown(all, {}, document, {});
    std::vector<Field> ofMission;
    for (Field f : all) {
        if (!f.key.starts_with("mission.")) continue;
        f.key = f.key.substr(8);
        ofMission.push_back(f);
    }
    expectKnown(ofMission, {}, mission, "mission");
}

/// A new row, with names of the lesson where names are wanted.
Json rowOf(const ListSpec& spec, const Variant& variant) {
    Json row = initialRow(spec, &variant);
    for (const Field& f : variant.fields) {
        if (f.optional || f.kind == FieldKind::List) continue;
        if (f.kind == FieldKind::Numbers && f.initial.is_null()) row[f.key] = Json::array({100, 100});
        if (f.kind == FieldKind::References) row[f.key] = Json::array({"head"});
        if (f.kind == FieldKind::Place) row[f.key] = "anch_ne_monsoon";
        if (f.kind == FieldKind::Places)
            row[f.key] = Json::array({"s_breakwater_head", Json{{"lat", 6.0338}, {"lon", 80.228}}});
        if (f.kind != FieldKind::Reference) continue;
        switch (f.source) {
            case Source::Waypoint:
                row[f.key] = 2;
                break;
            case Source::Line:
                row[f.key] = "head";
                break;
            case Source::Anchor:
                row[f.key] = "port";
                break;
            case Source::Thruster:
                row[f.key] = "bow";
                break;
            case Source::Target:
                row[f.key] = "coaster";
                break;
            case Source::Event:
                row[f.key] = "rain-squall";
                break;
            default:
                ADD_FAILURE() << f.key;
        }
    }
    for (const Field& f : spec.common)
        if (f.key == "id") row["id"] = "new";
    return row;
}

/// All kinds in one document, bare and with all that may be said: reading an area takes its time.
void expectEveryKindTaken(const ListSpec& spec, const std::string& path) {
    Json rows = Json::array();
    for (const Variant& v : spec.variants) {
        Json row = rowOf(spec, v);
        if (row.contains("id")) row["id"] = v.value;
        if (path == "events[0].orders" && v.value == "anchor") row["shackles"] = 3;
        rows.push_back(row);
        if (path == "events[0].orders") continue;  // some members go with some values only
        if (row.contains("id")) row["id"] = v.value + "-full";
        for (const Field& f : v.fields)
            if (f.optional && !f.initial.is_null()) put(row, f.key, f.initial);
        rows.push_back(row);
    }
    EXPECT_EQ(problemsWith(path, rows), "") << rows.dump();
}

TEST(EditorTables, MakeTasksTheLoaderTakes) { expectEveryKindTaken(taskList(), "mission.tasks"); }
TEST(EditorTables, MakeCriteriaTheLoaderTakes) { expectEveryKindTaken(criterionList(), "mission.criteria"); }
TEST(EditorTables, MakePilotStepsTheLoaderTakes) { expectEveryKindTaken(pilotList(), "pilot"); }

TEST(EditorTables, MakeOrdersTheLoaderTakes) {
    // all kinds of OrderDocument.cpp but pitch and azimuth, which no shipped vessel takes
    EXPECT_EQ(orderList().variants.size(), 14u);
    expectEveryKindTaken(orderList(), "events[0].orders");
}

TEST(EditorTables, HaveEveryKindTheLoaderKnows) {
    const auto knownBy = [](const std::string& path, const std::string& key) {
        const std::string problems = problemsWith(
            path, Json::array({Json{{"id", "x"}, {"title", "x"}, {"weight", 1}, {"points", 1}, {key, "?"}}}));
        const std::size_t at = problems.find("one of ");
        std::string list = problems.substr(at + 7);
        return std::count(list.begin(),
                          list.begin() + static_cast<std::ptrdiff_t>(std::min(list.find('\n'), list.size())),
                          ',') +
               1;
    };
    EXPECT_EQ(knownBy("mission.tasks", "kind"), static_cast<std::ptrdiff_t>(taskList().variants.size()));
    EXPECT_EQ(knownBy("mission.criteria", "kind"),
              static_cast<std::ptrdiff_t>(criterionList().variants.size()));
    EXPECT_EQ(knownBy("pilot", "do"), static_cast<std::ptrdiff_t>(pilotList().variants.size()));
}

TEST(EditorTables, MakeMarksOfEveryKindTheLoaderTakes) {
    Json document = lesson();
    document["marks"] = Json::array();
    double lon_deg = 80.222;
    for (const Option& kind : markKinds()) {
        Json mark = newMark(document, kind.value, {6.015, lon_deg += 0.001});
        const core::Mark drawn = markOf(mark, core::LocalFrame({6.0, 80.0}));
        EXPECT_EQ(drawn.floating, mark["floating"].get<bool>()) << kind.value;
        document["marks"].push_back(std::move(mark));
    }
    EXPECT_EQ(test::problemsOf(document.dump()), "");
    EXPECT_EQ(textAt(newMark(document, "special", {}), "name"), "Special 2");
}

TEST(EditorTables, KnowEveryKindOfMark) {
    const std::string problems = problemsWith("marks", Json::array({Json{{"kind", "?"}}}));
    for (const Option& kind : markKinds())
        EXPECT_NE(problems.find(kind.value), std::string::npos) << kind.value << problems;
    const std::size_t at = problems.find("one of ");
    EXPECT_EQ(std::count(problems.begin() + static_cast<std::ptrdiff_t>(at),
                         problems.begin() + static_cast<std::ptrdiff_t>(problems.find('\n', at)), ',') +
                  1,
              static_cast<std::ptrdiff_t>(markKinds().size()));
}

TEST(FreshName, CountsOn) {
    EXPECT_EQ(freshName("Wreck", {}), "Wreck");
    EXPECT_EQ(freshName("Wreck", {"Wreck"}), "Wreck 2");
    EXPECT_EQ(freshName("mark-1", {"mark-1", "mark-2"}), "mark-3");
}

TEST(EditorTables, AnEmptyScenarioLacksOnlyTheWordsOfItsMission) {
    const Json document = emptyScenario({"new", "New", "galle", "patrol51", 6.007185, 80.227506});
    const std::string problems = test::problemsOf(document.dump());
    EXPECT_EQ(std::count(problems.begin(), problems.end(), '\n'), 2) << problems;
    for (const char* path : {"mission.objective", "mission.competenceCode", "mission.briefing"})
        EXPECT_NE(problems.find(path), std::string::npos) << problems;
}

}  // namespace
}  // namespace sagara::ui::editor
