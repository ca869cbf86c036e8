#include "core/base/Archive.h"
#include "core/exercise/Recording.h"
#include "core/exercise/RecordingFormat.h"

namespace sagara::core {

void RecordingWriter::put(char kind, const Bytes& payload) {
    Bytes chunk;
    appendTo(chunk, ChunkHead{kind, static_cast<std::uint32_t>(payload.size()), chunkHash(kind, payload)});
    append(chunk, payload);
    m_sink(chunk);
}

void RecordingWriter::begin(const RecordingHeader& header, const World& world, const State& state) {
    m_sink(std::as_bytes(std::span(kRecordingMagic)));
    put(kHeaderChunk, toBytes(header));
    m_writtenTo_tick = state.tick;
    putState(state);
    m_codec.encode(sampleOf(world, state), m_samples);
    m_sampleCount = 1;
}

void RecordingWriter::goOn(const State& state) {
    m_writtenTo_tick = state.tick;
    putState(state);
}

void RecordingWriter::putState(const State& state) {
    StateChunk chunk{state.tick, kStateVersion, toBytes(state)};
    put(kStateChunk, toBytes(chunk));
    m_codec.restart();
}

void RecordingWriter::putSecond(std::int64_t tick) {
    put(kSecondChunk, toBytes(SecondChunk{tick, m_commands, m_events, m_sampleCount, m_samples}));
    m_commands.clear();
    m_events.clear();
    m_samples.clear();
    m_sampleCount = 0;
    m_writtenTo_tick = tick;
}

void RecordingWriter::tick(const World& world, const State& state, std::span<const Command> commands,
                           std::span<const Event> events) {
    m_commands.insert(m_commands.end(), commands.begin(), commands.end());
    m_events.insert(m_events.end(), events.begin(), events.end());
    if (state.tick % kTrackEvery_ticks == 0) {
        m_codec.encode(sampleOf(world, state), m_samples);
        ++m_sampleCount;
    }
    if (state.tick % kTicksPerSecond == 0) putSecond(state.tick);
    if (state.tick % kStateEvery_ticks == 0) putState(state);
}

void RecordingWriter::end(const State& state) {
    if (state.tick != m_writtenTo_tick) putSecond(state.tick);
    put(kEndChunk, toBytes(RecordingEnd{state.tick, stateHash(state), state.finished}));
}

}  // namespace sagara::core
