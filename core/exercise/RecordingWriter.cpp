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
    takeSample(world, state);
}

void RecordingWriter::goOn(const State& state) {
    m_writtenTo_tick = state.tick;
    m_addedWritten = state.added.size();
    putState(state);
}

void RecordingWriter::takeSample(const World& world, const State& state) {
    TrackSample sample = sampleOf(world, state);
    sample.targets.resize(world.targets.size());
    m_codec.encode(sample, m_samples);
    sampleAdded(world, state, m_sampleCount++, m_extras.samples);
}

void RecordingWriter::putState(const State& state) {
    StateChunk chunk{state.tick, kStateVersion, toBytes(state)};
    put(kStateChunk, toBytes(chunk));
    m_codec.restart();
}

void RecordingWriter::putSecond(std::int64_t tick) {
    put(kSecondChunk, toBytes(SecondChunk{tick, m_commands, m_events, m_sampleCount, m_samples, m_extras}));
    m_extras = {};
    m_commands.clear();
    m_events.clear();
    m_samples.clear();
    m_sampleCount = 0;
    m_writtenTo_tick = tick;
}

void RecordingWriter::tick(const World& world, const State& state, std::span<const Command> commands,
                           std::span<const Event> events) {
    m_commands.insert(m_commands.end(), commands.begin(), commands.end());
    for (const Event& event : events) {
        if (!event.text.empty())
            m_extras.texts.push_back({static_cast<std::uint32_t>(m_events.size()), event.text});
        m_events.push_back(event);
    }
    for (; m_addedWritten < state.added.size(); ++m_addedWritten)
        m_extras.added.push_back(state.added[m_addedWritten]);
    if (state.tick % kTrackEvery_ticks == 0) takeSample(world, state);
    if (state.tick % kTicksPerSecond == 0) putSecond(state.tick);
    if (state.tick % kStateEvery_ticks == 0) putState(state);
}

void RecordingWriter::end(const State& state) {
    if (state.tick != m_writtenTo_tick) putSecond(state.tick);
    put(kEndChunk, toBytes(RecordingEnd{state.tick, stateHash(state), state.finished}));
}

}  // namespace sagara::core
