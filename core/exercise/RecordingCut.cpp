#include "core/exercise/RecordingCut.h"

#include <cstring>

#include "core/exercise/RecordingFormat.h"

namespace sagara::core {

std::optional<std::size_t> bytesUpTo(std::span<const std::byte> recording, std::int64_t tick) {
    if (recording.size() < kRecordingMagic.size() ||
        std::memcmp(recording.data(), kRecordingMagic.data(), kRecordingMagic.size()) != 0)
        return std::nullopt;
    std::size_t at = kRecordingMagic.size();
    std::optional<std::size_t> found;
    while (recording.size() - at >= ChunkHead::kSize_bytes) {
        const auto rest = recording.subspan(at);
        const ChunkHead head = *fromBytes<ChunkHead>(rest.first(ChunkHead::kSize_bytes));
        if (head.length_bytes > rest.size() - ChunkHead::kSize_bytes) break;
        const auto payload = rest.subspan(ChunkHead::kSize_bytes, head.length_bytes);
        if (head.hash != chunkHash(head.kind, payload) || head.kind == kEndChunk) break;
        at += ChunkHead::kSize_bytes + head.length_bytes;
        if (head.kind == kStateChunk) {
            const auto chunk = fromBytes<StateChunk>(payload);
            if (!chunk || chunk->tick > tick) break;
            if (chunk->tick == tick) found = at;
        } else if (head.kind == kSecondChunk) {
            const auto chunk = fromBytes<SecondChunk>(payload);
            if (!chunk || chunk->toTick > tick) break;
            if (chunk->toTick == tick) found = at;
        }
    }
    return found;
}

}  // namespace sagara::core
