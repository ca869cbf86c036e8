#include <gtest/gtest.h>

#include "core/exercise/Advance.h"
#include "core/exercise/BuildId.h"
#include "core/exercise/Recording.h"
#include "core/exercise/Session.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::core {
namespace {

TEST(Notes, AreEventsWithTheirTextAndChangeNothing) {
    const auto world = test::lessonWorld();
    State state = startState(*world, 1), same = state;
    const NorthEast before = state.ships[0].motion.position();
    const std::vector<Command> commands{{0, 0, NoteOrder{"Good lookout", false}},
                                        {0, 0, NoteOrder{"", true}},
                                        {0, 0, ReportOrder{ReportKind::Anchored}},
                                        {0, 0, ReportOrder{static_cast<ReportKind>(9)}}};
    const auto events = advance(*world, state, commands);
    (void)advance(*world, same, {});
    ASSERT_EQ(events.size(), 3u);
    EXPECT_EQ(events[0].kind, EventKind::NoteMade);
    EXPECT_EQ(events[0].text, "Good lookout");
    EXPECT_EQ(events[0].value, 0.0);
    EXPECT_EQ(events[1].value, 1.0);
    EXPECT_EQ(events[2].kind, EventKind::Reported);
    EXPECT_EQ(events[2].index, static_cast<int>(ReportKind::Anchored));
    EXPECT_EQ(events[2].place, before);
    EXPECT_EQ(stateHash(state), stateHash(same));
}

TEST(Notes, ALongOneIsCutBetweenLetters) {
    const auto world = test::lessonWorld();
    State state = startState(*world, 1);
    std::string text(kLongestNote_bytes - 1, 'a');
    text += "é and more";
    const std::vector<Command> commands{{0, 0, NoteOrder{text, false}}};
    EXPECT_EQ(advance(*world, state, commands).at(0).text, std::string(kLongestNote_bytes - 1, 'a'));
}

TEST(Notes, ComeBackFromARecordingWithTheirTexts) {
    const auto world = test::lessonWorld();
    Bytes bytes;
    RecordingWriter writer([&](std::span<const std::byte> piece) { append(bytes, piece); });
    RecordingHeader header;
    header.buildId = coreBuildId();
    header.documents = world->documents;
    Session session(world, startState(*world, 1), {}, &writer);
    writer.begin(header, *world, session.state());
    while (session.state().tick < 3 * kTicksPerSecond) {
        if (session.state().tick == 60) {
            session.give(0, NoteOrder{"first", false});
            session.give(0, ReportOrder{ReportKind::PortControl});
            session.give(0, NoteOrder{"second", true});
        }
        if (session.state().tick == 120) session.give(0, NoteOrder{"third", false});
        (void)session.step();
    }
    writer.end(session.state());
    const auto recording = readRecording(bytes);
    ASSERT_TRUE(recording) << recording.error();
    EXPECT_EQ(recording->damage, "");
    std::vector<std::string> texts;
    for (const Event& e : recording->events) texts.push_back(e.text);
    EXPECT_EQ(texts, (std::vector<std::string>{"first", "", "second", "third"}));

    for (std::size_t cut = 0; cut < bytes.size(); cut += 97)  // any part of it reads without a fall
        (void)readRecording(std::span(bytes).first(cut));
}

TEST(Notes, ARecordingWithoutAnyIsOfTheSameBytesAsBefore) {
    // The extras of a second stand only where there are some: readers of before still read the rest.
    const auto world = test::lessonWorld();
    Bytes bytes;
    RecordingWriter writer([&](std::span<const std::byte> piece) { append(bytes, piece); });
    RecordingHeader header;
    Session session(world, startState(*world, 1), {}, &writer);
    writer.begin(header, *world, session.state());
    const std::size_t before = bytes.size();
    while (session.state().tick < kTicksPerSecond) (void)session.step();
    // head, tick, commands, events, count of samples, length and bytes of six samples
    EXPECT_LT(bytes.size() - before, 1000u);
    writer.end(session.state());
    const auto recording = readRecording(bytes);
    ASSERT_TRUE(recording);
    EXPECT_TRUE(recording->added.empty());
    EXPECT_EQ(recording->damage, "");
}

}  // namespace
}  // namespace sagara::core
