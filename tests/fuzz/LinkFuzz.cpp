// libFuzzer target: a peer on the link that sends anything. How to build and run it: README.md here.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "render/link/Codec.h"
#include "render/link/PacketReader.h"

using namespace sagara;

namespace {

constexpr link::KindSet kAll{
    link::Kind::Greeting, link::Kind::Hello, link::Kind::Refused,  link::Kind::Welcome, link::Kind::Setup,
    link::Kind::Ready,    link::Kind::Frame, link::Kind::Rendered, link::Kind::Show,    link::Kind::Shown,
    link::Kind::Ping,     link::Kind::Pong,  link::Kind::Picture,  link::Kind::Bye};

/// What is accepted must be what is sent on: the same message again.
void roundTrip(link::Kind kind, std::span<const std::byte> payload) {
    const auto message = link::decode(kind, payload);
    if (!message) return;
    const core::Bytes packet = link::encode(*message);
    const auto back = link::decode(kind, std::span(packet).subspan(link::kHeader_bytes));
    if (!back || link::encode(*back) != packet) std::abort();
}

}  // namespace

/// The first byte chooses: a stream as it comes from the socket, or the payload of one kind without a header,
/// which a fuzzer would take long to guess.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    std::span<const std::byte> rest = std::as_bytes(std::span(data, size)).subspan(1);
    if (data[0] >= 1 && data[0] <= link::kLastKind) {
        roundTrip(static_cast<link::Kind>(data[0]), rest);
        return 0;
    }
    link::PacketReader reader(kAll);
    while (!rest.empty()) {
        const auto packet = reader.take(rest);
        if (!packet || !*packet) break;
        roundTrip((*packet)->kind, (*packet)->payload);
    }
    return 0;
}
