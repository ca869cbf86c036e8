#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/base/Archive.h"
#include "render/link/Messages.h"
#include "render/link/PacketReader.h"

class QTcpSocket;

namespace sagara::link {

/// A message and when its bytes were read, by our clock.
struct Received {
    Message message;
    std::int64_t at_us = 0;
};

/// One end of the link: messages over TCP without delay. Belongs to one thread. Two ways of use: an event
/// loop and `onMessage`, or no event loop and `wait`. Bytes that are no message close it, after the peer was
/// told why.
class Connection {
public:
    /// Takes a connected socket.
    Connection(std::unique_ptr<QTcpSocket> socket, KindSet expected);
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    /// The error is for people: "cannot reach HOST:PORT: ...".
    static core::Result<std::unique_ptr<Connection>, std::string> to(const std::string& host,
                                                                     std::uint16_t port, int patience_ms,
                                                                     KindSet expected);

    void expect(KindSet kinds) { m_reader.expect(kinds); }
    void send(const Message& message) { sendPacket(encoded(message)); }
    void sendPacket(const core::Bytes& packet);

    /// `heard` is called from the event loop, and at once for what has come already; `closed` once, from the
    /// event loop, never from inside another call. `heard` may close this connection or set others in their
    /// place, but not destroy it; `closed` may not destroy it either.
    void onMessage(std::function<void(Received)> heard, std::function<void()> closed);
    /// The next message, waiting no longer than this; nothing when none came or the connection is closed.
    std::optional<Received> wait(int patience_ms);

    bool isOpen() const { return m_open; }
    const std::string& whyClosed() const { return m_whyClosed; }
    /// Sends what is still to be sent, then closes.
    void close(std::string why);
    /// Drops everything at once.
    void abort(std::string why);
    std::string peer() const;  ///< "192.168.1.7:52114"

private:
    static core::Bytes encoded(const Message& message);
    std::optional<Received> pull();
    void readAll();
    void noteClosed(std::string why);

    std::unique_ptr<QTcpSocket> m_socket;
    PacketReader m_reader;
    core::Bytes m_bytes;      ///< read and not yet taken
    std::size_t m_taken = 0;  ///< of m_bytes
    std::int64_t m_readAt_us = 0;
    bool m_open = true;
    std::string m_whyClosed;
    std::function<void(Received)> m_heard;
    std::function<void()> m_closed;
};

}  // namespace sagara::link
