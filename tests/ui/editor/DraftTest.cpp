#include <gtest/gtest.h>

#include "ui/editor/ScenarioDraft.h"

namespace sagara::ui::editor {
namespace {

Json sample() { return Json::parse(R"({"a": {"b": [{"c": 1}, {"c": 2}]}, "z": "text", "unknown": [1, 2]})"); }

TEST(JsonPath, FindsWhatTheLoaderNames) {
    const Json document = sample();
    ASSERT_NE(find(document, "a.b[1].c"), nullptr);
    EXPECT_EQ(*find(document, "a.b[1].c"), 2);
    EXPECT_EQ(find(document, "a.b[2].c"), nullptr);
    EXPECT_EQ(find(document, "z.c"), nullptr);
    EXPECT_EQ(&*find(document, ""), &document);
    EXPECT_EQ(parentOf("a.b[1].c"), "a.b[1]");
    EXPECT_EQ(parentOf("a.b[1]"), "a.b");
    EXPECT_EQ(indexOf("a.b[12]"), 12u);
    EXPECT_TRUE(within("a.b[1].c", "a.b[1]"));
    EXPECT_FALSE(within("a.b[11]", "a.b[1]"));
    EXPECT_FALSE(within("ab", "a"));
}

TEST(JsonPath, PutsAndErasesInPlace) {
    Json document = sample();
    put(document, "a.new.deep", 3);
    EXPECT_EQ(numberAt(document, "a.new.deep", 0.0), 3.0);
    put(document, "a.b[0].c", 7);
    EXPECT_EQ(numberAt(document, "a.b[0].c", 0.0), 7.0);
    erase(document, "a.b[0]");
    EXPECT_EQ(sizeAt(document, "a.b"), 1u);
    erase(document, "a.new.deep");
    EXPECT_EQ(find(document, "a.new.deep"), nullptr);
    erase(document, "not.there");
    EXPECT_EQ(document["unknown"], Json::array({1, 2}));
}

TEST(ScenarioDraft, JoinsStepsThatGoOnUntilTheyEnd) {
    ScenarioDraft draft;
    draft.reset(sample(), true);
    EXPECT_TRUE(draft.isSaved());
    for (const char* text : {"t", "ty", "typ"}) draft.set("z", text, QStringLiteral("typing"), QStringLiteral("z"));
    EXPECT_EQ(draft.history().count(), 1);
    EXPECT_FALSE(draft.isSaved());
    draft.endGoing();
    draft.set("z", "type", QStringLiteral("typing"), QStringLiteral("z"));
    draft.set("a.b[0].c", 5, QStringLiteral("c"));
    EXPECT_EQ(draft.history().count(), 3);
    draft.history().undo();
    draft.history().undo();
    EXPECT_EQ(textAt(draft.document(), "z"), "typ");
    draft.history().undo();
    EXPECT_EQ(draft.document(), sample());
    EXPECT_TRUE(draft.isSaved());
}

TEST(ScenarioDraft, WhatChangesNothingIsNoStep) {
    ScenarioDraft draft;
    draft.reset(sample(), true);
    draft.set("z", "text", QStringLiteral("same"));
    EXPECT_EQ(draft.history().count(), 0);
    draft.reset(sample(), false);
    EXPECT_FALSE(draft.isSaved());
    draft.markSaved();
    EXPECT_TRUE(draft.isSaved());
}

}  // namespace
}  // namespace sagara::ui::editor
