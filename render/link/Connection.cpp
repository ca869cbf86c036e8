#include "render/link/Connection.h"

#include <QHostAddress>
#include <QTcpSocket>

#include "render/link/Codec.h"
#include "render/link/SteadyClock.h"

namespace sagara::link {
namespace {

constexpr qint64 kReadAtOnce_bytes = 1 << 20;

}  // namespace

Connection::Connection(std::unique_ptr<QTcpSocket> socket, KindSet expected)
    : m_socket(std::move(socket)), m_reader(expected) {
    m_socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    m_socket->setReadBufferSize(kReadAtOnce_bytes);  // TCP slows a peer that sends more
}

Connection::~Connection() { m_socket->disconnect(); }

core::Result<std::unique_ptr<Connection>, std::string> Connection::to(const std::string& host,
                                                                      std::uint16_t port, int patience_ms,
                                                                      KindSet expected) {
    auto socket = std::make_unique<QTcpSocket>();
    socket->connectToHost(QString::fromStdString(host), port);
    if (!socket->waitForConnected(patience_ms))
        return "cannot reach " + host + ":" + std::to_string(port) + ": " +
               socket->errorString().toStdString();
    return std::make_unique<Connection>(std::move(socket), expected);
}

core::Bytes Connection::encoded(const Message& message) { return encode(message); }

void Connection::sendPacket(const core::Bytes& packet) {
    if (!m_open || m_socket->state() != QAbstractSocket::ConnectedState) return;
    m_socket->write(reinterpret_cast<const char*>(packet.data()), static_cast<qint64>(packet.size()));
    m_socket->flush();
}

void Connection::onMessage(std::function<void(Received)> heard, std::function<void()> closed) {
    const bool first = !m_heard;
    m_heard = std::move(heard);
    m_closed = std::move(closed);
    if (first) {
        QObject::connect(m_socket.get(), &QTcpSocket::readyRead, m_socket.get(), [this] { readAll(); });
        // Queued: a write that fails must not call anybody from inside send.
        QObject::connect(
            m_socket.get(), &QTcpSocket::disconnected, m_socket.get(),
            [this] {
                readAll();
                noteClosed("the connection was closed by the other side");
            },
            Qt::QueuedConnection);
    }
    readAll();
}

void Connection::readAll() {
    while (auto received = pull()) {
        const auto heard = m_heard;  // it may be replaced while it runs
        heard(std::move(*received));
    }
}

std::optional<Received> Connection::wait(int patience_ms) {
    const std::int64_t until_us = steadyClock_us() + 1000 * std::int64_t{patience_ms};
    for (;;) {
        if (auto received = pull()) return received;
        if (!m_open) return std::nullopt;
        const std::int64_t left_us = until_us - steadyClock_us();
        if (left_us <= 0) return std::nullopt;
        if (m_socket->waitForReadyRead(static_cast<int>((left_us + 999) / 1000))) continue;
        if (m_socket->state() != QAbstractSocket::ConnectedState && m_socket->bytesAvailable() == 0)
            noteClosed("the connection was closed by the other side");
    }
}

std::optional<Received> Connection::pull() {
    while (m_open) {
        if (m_taken == m_bytes.size()) {
            const qint64 available = std::min(m_socket->bytesAvailable(), kReadAtOnce_bytes);
            if (available <= 0) return std::nullopt;
            m_bytes.resize(static_cast<std::size_t>(available));
            const qint64 count = m_socket->read(reinterpret_cast<char*>(m_bytes.data()), available);
            m_bytes.resize(static_cast<std::size_t>(std::max<qint64>(count, 0)));
            m_taken = 0;
            m_readAt_us = steadyClock_us();
            if (m_bytes.empty()) return std::nullopt;
        }
        std::span<const std::byte> rest = std::span<const std::byte>(m_bytes).subspan(m_taken);
        auto packet = m_reader.take(rest);
        m_taken = m_bytes.size() - rest.size();
        std::optional<DecodeError> error;
        if (!packet) {
            error = packet.error();
        } else if (*packet) {
            auto message = decode((*packet)->kind, (*packet)->payload);
            if (message) return Received{std::move(message).value(), m_readAt_us};
            error = message.error();
        }
        if (error) {
            send(Refused{error->reason, {kProtocolVersion}});
            close("what came cannot be read: " + error->reason);
        }
    }
    return std::nullopt;
}

void Connection::close(std::string why) {
    if (!m_open) return;
    m_socket->flush();
    m_socket->disconnectFromHost();
    noteClosed(std::move(why));
}

void Connection::abort(std::string why) {
    if (!m_open) return;
    m_socket->abort();
    noteClosed(std::move(why));
}

void Connection::noteClosed(std::string why) {
    if (!m_open) return;
    m_open = false;
    m_whyClosed = std::move(why);
    if (!m_heard) return;
    QMetaObject::invokeMethod(
        m_socket.get(),
        [this] {
            const auto closed = m_closed;
            closed();
        },
        Qt::QueuedConnection);
}

std::string Connection::peer() const {
    return m_socket->peerAddress().toString().toStdString() + ":" + std::to_string(m_socket->peerPort());
}

}  // namespace sagara::link
