#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/exercise/Documents.h"
#include "core/exercise/Event.h"
#include "core/exercise/SecondExtras.h"
#include "core/exercise/State.h"
#include "core/exercise/Track.h"

/// A recording: what the run was made of and everything that went into it, so that it can be run again to the
/// bit, begun anywhere, graded by another rubric, and shown by a later build from its kinematic track.
///
///   "SGRREC01"                      eight bytes
///   chunk*                          kind (1), length (4), hash of kind and payload (8), payload
///     H header  once, first         RecordingHeader
///     S state   tick 0, every 10 s  version of the layout, State
///     T second  every second        commands, events and track samples of it
///     E end     once                RecordingEnd
///
/// Chunks are written when they are whole and never changed. A file that was cut off or damaged is read up to
/// the first chunk that is not whole.
namespace sagara::core {

inline constexpr std::uint32_t kRecordingVersion = 1;

struct RecordingHeader {
    std::uint32_t version = kRecordingVersion;
    std::string buildId;
    std::uint64_t seed = 0;
    std::int32_t level = 1;
    std::string runType;             ///< "assess", "self-study", ...
    std::string trainee;             ///< empty: nobody named
    std::int64_t startedUnix_s = 0;  ///< wall clock, for the files of the school
    ExerciseDocuments documents;
    std::vector<Command> planned;  ///< commands known before the start, for a run that is taken up again

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.version, self.buildId, self.seed, self.level, self.runType, self.trainee, self.startedUnix_s,
           self.documents, self.planned);
    }
};

struct RecordingEnd {
    std::int64_t tick = 0;
    std::uint64_t stateHash = 0;
    bool finished = false;  ///< the exercise was over; else it was broken off

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.tick, self.stateHash, self.finished);
    }
};

inline constexpr std::int64_t kStateEvery_ticks = 10 * kTicksPerSecond;

/// Makes the bytes of a recording while the run goes on. Hands every whole chunk to `sink` at once.
class RecordingWriter {
public:
    using Sink = std::function<void(std::span<const std::byte>)>;
    explicit RecordingWriter(Sink sink) : m_sink(std::move(sink)) {}

    /// Before the first tick.
    void begin(const RecordingHeader& header, const World& world, const State& state);
    /// Instead of begin, for a file that already holds everything up to this state: at a whole second.
    void goOn(const State& state);
    /// After every tick: what went in, what came out, and how it stands.
    void tick(const World& world, const State& state, std::span<const Command> commands,
              std::span<const Event> events);
    /// After the last tick.
    void end(const State& state);

private:
    void put(char kind, const Bytes& payload);
    void putState(const State& state);
    void putSecond(std::int64_t tick);
    void takeSample(const World& world, const State& state);

    Sink m_sink;
    TrackCodec m_codec;
    std::vector<Command> m_commands;
    std::vector<Event> m_events;
    Bytes m_samples;
    std::uint32_t m_sampleCount = 0;
    SecondExtras m_extras;
    std::size_t m_addedWritten = 0;
    std::int64_t m_writtenTo_tick = 0;
};

/// A recording read back, as far as it is whole.
struct Recording {
    RecordingHeader header;
    std::string damage;           ///< empty: whole; else what was found and where
    std::size_t whole_bytes = 0;  ///< length of the part that is whole
    std::int64_t endTick = 0;     ///< the run is known up to here
    std::vector<Command> commands;
    std::vector<Event> events;
    std::optional<RecordingEnd> end;

    struct StatePart {
        std::int64_t tick = 0;
        std::uint32_t version = 0;
        Bytes bytes;
    };
    std::vector<StatePart> states;

    struct SamplePart {
        bool restart = false;  ///< the codec begins afresh
        std::uint32_t count = 0;
        Bytes bytes;
        std::vector<SecondExtras::Sample> added;
    };
    std::vector<SamplePart> samples;
    std::vector<TargetLayout> added;  ///< by the trainer, in the course of the run

    /// The whole kinematic track. Stops where samples are damaged. The targets of a sample are those of the
    /// world and, after them, those that were added in the run: all of them, present or not.
    std::vector<TrackSample> track(std::size_t ships, std::size_t targets) const;
    /// Whether this build can run it again to the bit.
    bool sameBuild() const;
};

/// Total: any bytes give a recording, which has a state at least, or the reason why there is none.
Result<Recording, std::string> readRecording(std::span<const std::byte> bytes);

}  // namespace sagara::core
