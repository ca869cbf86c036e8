#pragma once

#include <array>

#include "core/base/Archive.h"
#include "core/exercise/Command.h"
#include "core/exercise/Event.h"
#include "core/exercise/SecondExtras.h"

/// The chunks of a recording as bytes: shared by writer and reader only. See Recording.h for the format.
namespace sagara::core {

inline constexpr std::array<char, 8> kRecordingMagic{'S', 'G', 'R', 'R', 'E', 'C', '0', '1'};
inline constexpr char kHeaderChunk = 'H', kStateChunk = 'S', kSecondChunk = 'T', kEndChunk = 'E';

struct ChunkHead {
    char kind = 0;
    std::uint32_t length_bytes = 0;
    std::uint64_t hash = 0;

    static constexpr std::size_t kSize_bytes = 1 + 4 + 8;
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.kind, self.length_bytes, self.hash);
    }
};

inline std::uint64_t chunkHash(char kind, std::span<const std::byte> payload) {
    Hash64 hash;
    hash.add(std::as_bytes(std::span(&kind, 1)));
    hash.add(payload);
    return hash.value();
}

struct StateChunk {
    std::int64_t tick = 0;
    std::uint32_t version = 0;
    Bytes state;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.tick, self.version, self.state);
    }
};

struct SecondChunk {
    std::int64_t toTick = 0;
    std::vector<Command> commands;
    std::vector<Event> events;
    std::uint32_t sampleCount = 0;
    Bytes samples;
    SecondExtras extras;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.toTick, self.commands, self.events, self.sampleCount, self.samples);
        if constexpr (requires { ar.atEnd(); }) {
            if (!ar.atEnd()) ar(self.extras);
        } else {
            if (!self.extras.empty()) ar(self.extras);
        }
    }
};

}  // namespace sagara::core
