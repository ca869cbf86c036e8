#include "SimTest.h"

namespace sagara::run::test {
namespace {

/// A recording of 12 s that tests cut and spoil.
class DamagedRecording : public SimTest {
protected:
    void SetUp() override {
        m_run = simJson(lesson("12", {"--helm", "pilot", "--record", at("whole.sgr")}));
        m_bytes = read("whole.sgr");
        m_headEnd = 8 + 13 + lengthAt(8);
    }
    std::size_t lengthAt(std::size_t chunk) const {
        std::size_t length = 0;
        for (std::size_t k = 4; k > 0; --k)
            length = length << 8 | static_cast<unsigned char>(m_bytes[chunk + k]);
        return length;
    }
    /// Begins of the chunks, and the end of the file.
    std::vector<std::size_t> chunks() const {
        std::vector<std::size_t> begins;
        std::size_t i = 8;
        for (; i < m_bytes.size(); i += 13 + lengthAt(i)) begins.push_back(i);
        begins.push_back(i);
        return begins;
    }

    /// What holds for any file at all: an answer, and not a byte of it changed.
    void expectAnswered(const std::string& bytes, const std::string& how) const {
        write("bad.sgr", bytes);
        const Outcome replay = sim({"replay", at("bad.sgr"), "--json"});
        EXPECT_EQ(replay.signal, 0) << how;
        EXPECT_EQ(replay.err.rfind(at("bad.sgr") + ": ", 0), 0u) << how << "\n" << replay.err;
        EXPECT_EQ(linesOf(replay.err).size(), 1u) << how << "\n" << replay.err;
        if (replay.exitCode == 0) {
            EXPECT_TRUE(nlohmann::json::accept(replay.out)) << how << "\n" << replay.out;
            EXPECT_NE(replay.err.find("; what is whole, up to 00:"), std::string::npos) << how << replay.err;
        } else {
            EXPECT_EQ(replay.exitCode, 2) << how;
            EXPECT_EQ(replay.out, "") << how;
        }
        EXPECT_EQ(read("bad.sgr"), bytes) << how;
    }

    /// Resumed to the length of the whole run: to its end, or refused with the file as it was.
    void expectResumedOrRefused(const std::string& bytes, const std::string& how) const {
        write("bad.sgr", bytes);
        const Outcome run = sim({"run", "--resume", at("bad.sgr"), "--fast", "--duration-s", "12"});
        EXPECT_EQ(run.signal, 0) << how;
        EXPECT_EQ(run.err.rfind(at("bad.sgr") + ": ", 0), 0u) << how << "\n" << run.err;
        if (run.exitCode == 0) {
            EXPECT_EQ(hashIn(run), m_run["state_hash"]) << how;
            EXPECT_EQ(hashIn(simDone({"replay", at("bad.sgr")})), m_run["state_hash"]) << how;
        } else {
            EXPECT_EQ(run.exitCode, 2) << how << "\n" << run.err;
            EXPECT_EQ(read("bad.sgr"), bytes) << how;
        }
    }

    nlohmann::json m_run;
    std::string m_bytes;
    std::size_t m_headEnd = 0;
};

TEST_F(DamagedRecording, CutAnywhereIsReadAsFarAsItIsWhole) {
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{5}, std::size_t{8}, std::size_t{20}, m_headEnd / 2})
        expectAnswered(m_bytes.substr(0, size), "cut at " + std::to_string(size));
    const auto begins = chunks();
    for (std::size_t i = 1; i + 1 < begins.size(); i += 3) {
        expectAnswered(m_bytes.substr(0, begins[i]), "cut before chunk " + std::to_string(i));
        expectAnswered(m_bytes.substr(0, (begins[i] + begins[i + 1]) / 2),
                       "cut in chunk " + std::to_string(i));
    }
}

TEST_F(DamagedRecording, FlippedBitsAreNoticed) {
    const auto begins = chunks();
    for (std::size_t i = 0; i + 1 < begins.size(); i += 2) {
        for (const std::size_t at : {begins[i], begins[i] + 3, begins[i] + 7, begins[i + 1] - 1}) {
            if ((at + i) % 3 != 0 && i > 2) continue;  // every place about the begin, a third of the others
            std::string bytes = m_bytes;
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << (at % 8)));
            expectAnswered(bytes, "flipped at " + std::to_string(at));
        }
    }
}

TEST_F(DamagedRecording, IsResumedFromWhatIsWholeOrRefused) {
    const auto begins = chunks();
    expectResumedOrRefused(m_bytes.substr(0, 100), "cut in the header");
    expectResumedOrRefused(m_bytes.substr(0, begins[1]), "cut after the header");
    expectResumedOrRefused(m_bytes.substr(0, begins[2]), "cut after the first state");
    expectResumedOrRefused(m_bytes.substr(0, begins[5] + 20), "cut in a second");
    expectResumedOrRefused(m_bytes.substr(0, begins[begins.size() - 2]), "without its end");
    std::string flipped = m_bytes;
    flipped[begins[6] + 30] = static_cast<char>(flipped[begins[6] + 30] ^ 4);
    expectResumedOrRefused(flipped, "flipped in the middle");
}

TEST_F(DamagedRecording, SaysWhatAndWhere) {
    const auto begins = chunks();
    write("bad.sgr", m_bytes.substr(0, begins[5] + 20));
    EXPECT_EQ(simDone({"replay", at("bad.sgr")}).err,
              at("bad.sgr") + ": cut off or damaged at byte " + std::to_string(begins[5]) + " of " +
                  std::to_string(begins[5] + 20) + "; what is whole, up to 00:03, is used\n");
}

TEST_F(DamagedRecording, WithoutItsFirstStateItIsRefusedAndTheReasonIsTheTrueOne) {
    write("bad.sgr", m_bytes.substr(0, chunks()[1]));
    for (const Arguments& arguments :
         {Arguments{"replay", at("bad.sgr")}, Arguments{"run", "--resume", at("bad.sgr"), "--fast"}}) {
        const Outcome outcome = sim(arguments);
        EXPECT_EQ(outcome.exitCode, 2) << outcome.out;
        EXPECT_EQ(outcome.err.find("another build"), std::string::npos) << outcome.err;
        EXPECT_NE(outcome.err.find("bad.sgr: "), std::string::npos) << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
}

TEST_F(DamagedRecording, TakingUpARunSaysThatWhatCannotBeReadIsCutOff) {
    const auto begins = chunks();
    std::string flipped = m_bytes;
    flipped[begins[6] + 30] = static_cast<char>(flipped[begins[6] + 30] ^ 4);
    write("bad.sgr", flipped);
    const Outcome run = simDone({"run", "--resume", at("bad.sgr"), "--fast", "--duration-s", "12"});
    EXPECT_EQ(linesOf(run.err).at(0),
              at("bad.sgr") + ": damaged at byte " + std::to_string(begins[6]) + " of " +
                  std::to_string(m_bytes.size()) + "; taken up again at 00:04, " +
                  std::to_string(m_bytes.size() - begins[6]) + " bytes after that are cut off");
}

}  // namespace
}  // namespace sagara::run::test
