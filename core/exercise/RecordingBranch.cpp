#include "core/exercise/RecordingBranch.h"

#include <cstring>

#include "core/exercise/RecordingFormat.h"

namespace sagara::core {
namespace {

constexpr std::size_t kMagic_bytes = kRecordingMagic.size();

/// Whether a chunk is of the time before: a state of that very tick is goOn's to write.
bool isBefore(char kind, std::span<const std::byte> payload, std::int64_t tick) {
    if (kind == kStateChunk) {
        const auto chunk = fromBytes<StateChunk>(payload);
        return chunk && chunk->tick < tick;
    }
    if (kind != kSecondChunk) return false;
    const auto chunk = fromBytes<SecondChunk>(payload);
    return chunk && chunk->toTick <= tick;
}

}  // namespace

Result<Bytes, std::string> recordingUpTo(std::span<const std::byte> recording, const RecordingHeader& header,
                                         std::int64_t tick) {
    if (recording.size() < kMagic_bytes ||
        std::memcmp(recording.data(), kRecordingMagic.data(), kMagic_bytes) != 0)
        return std::string("is not a Sagara recording of format 1");
    if (tick < 0 || tick % kTicksPerSecond != 0)
        return std::string("a run can branch at a whole second only");
    Bytes out(recording.begin(), recording.begin() + kMagic_bytes);
    const Bytes head = toBytes(header);
    appendTo(out,
             ChunkHead{kHeaderChunk, static_cast<std::uint32_t>(head.size()), chunkHash(kHeaderChunk, head)});
    append(out, head);
    auto rest = recording.subspan(kMagic_bytes);
    while (rest.size() >= ChunkHead::kSize_bytes) {
        const ChunkHead chunk = *fromBytes<ChunkHead>(rest.first(ChunkHead::kSize_bytes));
        if (chunk.length_bytes > rest.size() - ChunkHead::kSize_bytes) break;
        const auto whole = rest.first(ChunkHead::kSize_bytes + chunk.length_bytes);
        const auto payload = whole.subspan(ChunkHead::kSize_bytes);
        if (chunk.hash != chunkHash(chunk.kind, payload)) break;
        if (isBefore(chunk.kind, payload, tick)) out.insert(out.end(), whole.begin(), whole.end());
        rest = rest.subspan(whole.size());
    }
    return out;
}

}  // namespace sagara::core
