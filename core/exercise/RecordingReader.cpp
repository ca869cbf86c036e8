#include <algorithm>
#include <cstring>

#include "core/exercise/BuildId.h"
#include "core/exercise/Recording.h"
#include "core/exercise/RecordingFormat.h"

namespace sagara::core {
namespace {

/// Walks the chunks and gathers what they hold.
class Gather {
public:
    explicit Gather(std::span<const std::byte> bytes) : m_bytes(bytes) {}

    Result<Recording, std::string> read() {
        if (m_bytes.size() < kRecordingMagic.size() ||
            std::memcmp(m_bytes.data(), kRecordingMagic.data(), kRecordingMagic.size()) != 0) {
            return std::string("is not a Sagara recording of format 1: it does not begin with SGRREC01");
        }
        m_at = kRecordingMagic.size();
        while (m_recording.damage.empty() && m_at < m_bytes.size()) readChunk();
        if (m_recording.damage.empty() && !m_recording.end)
            m_recording.damage = "the end is missing: the run was broken off";
        if (!m_haveHeader) return nothingWithout("header");
        if (m_recording.states.empty()) return nothingWithout("state to begin from");
        m_recording.whole_bytes = m_at;
        return std::move(m_recording);
    }

private:
    std::string nothingWithout(const std::string& part) const {
        return "has no whole " + part + ", so nothing of the run can be read (" + m_recording.damage + ")";
    }

    void damage(const std::string& what) {
        m_recording.damage =
            what + " at byte " + std::to_string(m_at) + " of " + std::to_string(m_bytes.size());
    }

    void readChunk() {
        const auto rest = m_bytes.subspan(m_at);
        if (rest.size() < ChunkHead::kSize_bytes) return damage("cut off");
        const ChunkHead head = *fromBytes<ChunkHead>(rest.first(ChunkHead::kSize_bytes));
        if (head.length_bytes > rest.size() - ChunkHead::kSize_bytes) return damage("cut off or damaged");
        const auto payload = rest.subspan(ChunkHead::kSize_bytes, head.length_bytes);
        if (head.hash != chunkHash(head.kind, payload)) return damage("damaged");
        if (!take(head.kind, payload)) return damage("a part that this version cannot read");
        m_at += ChunkHead::kSize_bytes + head.length_bytes;
    }

    bool take(char kind, std::span<const std::byte> payload) {
        if (kind == kHeaderChunk) return takeHeader(payload);
        if (!m_haveHeader || m_recording.end) return false;
        if (kind == kStateChunk) return takeState(payload);
        if (kind == kSecondChunk) return takeSecond(payload);
        if (kind == kEndChunk) return takeEnd(payload);
        return false;
    }

    bool takeHeader(std::span<const std::byte> payload) {
        auto header = fromBytes<RecordingHeader>(payload);
        if (!header || m_haveHeader || header->version != kRecordingVersion) return false;
        m_recording.header = std::move(*header);
        m_haveHeader = true;
        return true;
    }

    bool takeState(std::span<const std::byte> payload) {
        auto chunk = fromBytes<StateChunk>(payload);
        if (!chunk) return false;
        m_recording.states.push_back({chunk->tick, chunk->version, std::move(chunk->state)});
        m_restart = true;
        return true;
    }

    bool takeSecond(std::span<const std::byte> payload) {
        auto chunk = fromBytes<SecondChunk>(payload);
        if (!chunk || chunk->toTick < m_recording.endTick) return false;
        if (!takeExtras(*chunk)) return false;
        append(m_recording.commands, chunk->commands);
        append(m_recording.events, chunk->events);
        m_recording.samples.push_back(
            {m_restart, chunk->sampleCount, std::move(chunk->samples), std::move(chunk->extras.samples)});
        m_recording.endTick = chunk->toTick;
        m_restart = false;
        return true;
    }

    bool takeExtras(SecondChunk& chunk) {
        for (SecondExtras::Text& text : chunk.extras.texts) {
            if (text.event >= chunk.events.size()) return false;
            chunk.events[text.event].text = std::move(text.text);
        }
        append(m_recording.added, chunk.extras.added);
        const auto known = m_recording.added.size();
        return known <= kMostAddedTargets &&
               std::all_of(m_recording.added.begin(), m_recording.added.end(), isSound) &&
               std::all_of(chunk.extras.samples.begin(), chunk.extras.samples.end(),
                           [&](const auto& s) { return s.target < known && s.sample < chunk.sampleCount; });
    }

    bool takeEnd(std::span<const std::byte> payload) {
        m_recording.end = fromBytes<RecordingEnd>(payload);
        return m_recording.end.has_value();
    }

    template <typename T>
    static void append(std::vector<T>& all, const std::vector<T>& more) {
        all.insert(all.end(), more.begin(), more.end());
    }

    std::span<const std::byte> m_bytes;
    std::size_t m_at = 0;
    bool m_haveHeader = false;
    bool m_restart = false;
    Recording m_recording;
};

}  // namespace

Result<Recording, std::string> readRecording(std::span<const std::byte> bytes) {
    return Gather(bytes).read();
}

bool Recording::sameBuild() const {
    return header.buildId == coreBuildId() && !states.empty() && states.front().version == kStateVersion;
}

std::vector<TrackSample> Recording::track(std::size_t ships, std::size_t targets) const {
    std::vector<TrackSample> track;
    TrackCodec codec;
    for (const SamplePart& part : samples) {
        if (part.restart) codec.restart();
        std::span<const std::byte> bytes(part.bytes);
        for (std::uint32_t i = 0; i < part.count; ++i) {
            TrackSample sample;
            if (!codec.decode(bytes, ships, targets, sample)) return track;
            sample.targets.resize(targets + added.size());
            track.push_back(std::move(sample));
        }
        for (const SecondExtras::Sample& s : part.added) {
            if (s.sample >= part.count) continue;
            TargetSample& target = track[track.size() - part.count + s.sample].targets[targets + s.target];
            target = {true, {0.1 * s.north_dm, 0.1 * s.east_dm}, 0.001 * s.heading_mrad, 0.01 * s.speed_cmps};
        }
    }
    return track;
}

}  // namespace sagara::core
