#include "render/link/Codec.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/stubs/logging.h>
#include <google/protobuf/wire_format_lite.h>

#include <cassert>

#include "render/link/FrameCodec.h"
#include "render/link/TalkCodec.h"
#include "render/link/schema/link.pb.h"

namespace sagara::link {
namespace {

using google::protobuf::internal::WireFormatLite;
using google::protobuf::io::CodedInputStream;

/// Counted on the bytes, before lists are built of them.
bool tooManyFields(std::span<const std::byte> payload, std::size_t most) {
    CodedInputStream in(reinterpret_cast<const std::uint8_t*>(payload.data()),
                        static_cast<int>(payload.size()));
    for (std::size_t count = 0; const std::uint32_t tag = in.ReadTag(); ++count) {
        if (count >= most) return true;
        if (!WireFormatLite::SkipField(&in, tag)) return false;  // the parser will say so
    }
    return false;
}

template <typename Wire>
core::Result<Message, DecodeError> decodeAs(Kind kind, std::span<const std::byte> payload) {
    Wire wire;
    if (!wire.ParseFromArray(payload.data(), static_cast<int>(payload.size())))
        return DecodeError{std::string(kindName(kind)) + ": the bytes are damaged"};
    Check check;
    auto message = read(wire, check);
    if (!check.sound()) return DecodeError{std::string(kindName(kind)) + ": " + check.reason()};
    return Message(std::move(message));
}

template <typename Wire, typename T>
core::Bytes encodeAs(const T& message) {
    Wire wire;
    const Kind kind = write(message, wire);
    const std::size_t length = wire.ByteSizeLong();
    assert(length <= mostPayload_bytes(kind));
    core::Bytes bytes(kHeader_bytes + length);
    const auto header = encodeHeader({kProtocolVersion, kind, static_cast<std::uint32_t>(length)});
    std::copy(header.begin(), header.end(), bytes.begin());
    wire.SerializeToArray(bytes.data() + kHeader_bytes, static_cast<int>(length));
    return bytes;
}

/// Damaged bytes are answered with a reason; Protobuf need not write to standard error as well.
[[maybe_unused]] const auto kQuiet = google::protobuf::SetLogHandler(nullptr);

}  // namespace

core::Bytes encode(const Message& message) {
    struct Encoder {
        core::Bytes operator()(const Greeting& m) { return encodeAs<wire::Greeting>(m); }
        core::Bytes operator()(const Hello& m) { return encodeAs<wire::Hello>(m); }
        core::Bytes operator()(const Refused& m) { return encodeAs<wire::Refused>(m); }
        core::Bytes operator()(const Welcome& m) { return encodeAs<wire::Welcome>(m); }
        core::Bytes operator()(const Setup& m) { return encodeAs<wire::Setup>(m); }
        core::Bytes operator()(const Ready& m) { return encodeAs<wire::Ready>(m); }
        core::Bytes operator()(const Frame& m) { return encodeAs<wire::Frame>(m); }
        core::Bytes operator()(const Rendered& m) { return encodeAs<wire::Rendered>(m); }
        core::Bytes operator()(const Show& m) { return encodeAs<wire::Show>(m); }
        core::Bytes operator()(const Shown& m) { return encodeAs<wire::Shown>(m); }
        core::Bytes operator()(const Ping& m) { return encodeAs<wire::Ping>(m); }
        core::Bytes operator()(const Pong& m) { return encodeAs<wire::Pong>(m); }
        core::Bytes operator()(const Picture& m) { return encodeAs<wire::Picture>(m); }
        core::Bytes operator()(const Bye& m) { return encodeAs<wire::Bye>(m); }
    };
    return std::visit(Encoder{}, message);
}

core::Result<Message, DecodeError> decode(Kind kind, std::span<const std::byte> payload) {
    if (payload.size() > mostPayload_bytes(kind) || tooManyFields(payload, mostFields(kind)))
        return DecodeError{std::string(kindName(kind)) + ": too much of it"};
    switch (kind) {
        case Kind::Greeting:
            return decodeAs<wire::Greeting>(kind, payload);
        case Kind::Hello:
            return decodeAs<wire::Hello>(kind, payload);
        case Kind::Refused:
            return decodeAs<wire::Refused>(kind, payload);
        case Kind::Welcome:
            return decodeAs<wire::Welcome>(kind, payload);
        case Kind::Setup:
            return decodeAs<wire::Setup>(kind, payload);
        case Kind::Ready:
            return decodeAs<wire::Ready>(kind, payload);
        case Kind::Frame:
            return decodeAs<wire::Frame>(kind, payload);
        case Kind::Rendered:
            return decodeAs<wire::Rendered>(kind, payload);
        case Kind::Show:
            return decodeAs<wire::Show>(kind, payload);
        case Kind::Shown:
            return decodeAs<wire::Shown>(kind, payload);
        case Kind::Ping:
            return decodeAs<wire::Ping>(kind, payload);
        case Kind::Pong:
            return decodeAs<wire::Pong>(kind, payload);
        case Kind::Picture:
            return decodeAs<wire::Picture>(kind, payload);
        case Kind::Bye:
            return decodeAs<wire::Bye>(kind, payload);
    }
    return DecodeError{"unknown kind"};
}

}  // namespace sagara::link
