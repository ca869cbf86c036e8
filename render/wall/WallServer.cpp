#include "render/wall/WallServer.h"

#include <QHostAddress>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>
#include <algorithm>
#include <cmath>

#include "core/exercise/BuildId.h"
#include "render/link/ClockOffset.h"
#include "render/link/Codec.h"
#include "render/link/Handshake.h"
#include "render/link/SteadyClock.h"
#include "render/link/Token.h"

namespace sagara::wall {
namespace {

constexpr std::size_t kMostGuests = 32, kMostObservers = 8;
constexpr std::int64_t kHello_us = 5'000'000, kPingEvery_us = 250'000, kIdleFrame_us = 20'000;
/// A decision by time waits this long for messages that came but were not read: the station itself may have
/// been busy.
constexpr int kSecondLook_ms = 3;

/// Someone who has not said hello yet.
struct Guest {
    std::unique_ptr<link::Connection> connection;
    link::Nonce nonce{};
    std::int64_t arrived_us = 0;
};

/// The connection of a channel, if there is one.
struct Peer {
    std::unique_ptr<link::Connection> connection;
    link::ChannelView view;
    link::ClockOffset clock;
    std::int64_t pinged_us = 0;
    bool pictureAsked = false;
};

}  // namespace

class WallServer::Impl {
public:
    Impl(Layout layout, WallOptions options, std::shared_ptr<const core::World> world, MomentSource source,
         WallObserver& observer)
        : m_layout(std::move(layout)),
          m_options(std::move(options)),
          m_world(std::move(world)),
          m_source(std::move(source)),
          m_observer(observer),
          m_barrier({}, m_options.rules) {
        for (const LayoutChannel& channel : m_layout.channels) {
            m_barrier.addSlot({channel.view.name, true});
            m_peers.push_back({nullptr, channel.view, {}, 0, false});
        }
        for (QTimer* timer : {&m_due, &m_decision, &m_secondLook, &m_sweep}) {
            timer->setTimerType(Qt::PreciseTimer);
            timer->setSingleShot(true);
        }
        QObject::connect(&m_due, &QTimer::timeout, &m_context, [this] { settle(); });
        QObject::connect(&m_decision, &QTimer::timeout, &m_context,
                         [this] { m_secondLook.start(kSecondLook_ms); });
        QObject::connect(&m_secondLook, &QTimer::timeout, &m_context, [this] {
            m_barrier.pass(link::steadyClock_us());
            settle();
        });
        QObject::connect(&m_sweep, &QTimer::timeout, &m_context, [this] { sweep(); });
        QObject::connect(&m_server, &QTcpServer::newConnection, &m_context, [this] { welcomeGuests(); });
    }

    core::Result<std::uint16_t, std::string> listen() {
        if (m_options.everywhere && m_options.token.size() < link::kShortestToken)
            return "to listen to other PCs a token of " + std::to_string(link::kShortestToken) +
                   " characters or more is needed";
        if (m_world->ships.size() > link::kMostShips ||
            m_world->targets.size() + core::kMostAddedTargets > link::kMostTargets)
            return "a wall shows at most " + std::to_string(link::kMostShips) + " own ships and " +
                   std::to_string(link::kMostTargets - core::kMostAddedTargets) + " targets";
        std::size_t setup_bytes = 4096;
        const core::ExerciseDocuments& d = m_world->documents;
        for (const auto* text : {&d.scenario, &d.area}) setup_bytes += text->text.size();
        for (const core::NamedText& vessel : d.vessels) setup_bytes += vessel.text.size();
        if (setup_bytes > link::mostPayload_bytes(link::Kind::Setup))
            return "the documents of the exercise have " + std::to_string(setup_bytes) + " bytes, at most " +
                   std::to_string(link::mostPayload_bytes(link::Kind::Setup)) + " can be sent";
        m_setup = link::encode(link::Setup{d, m_world->seed});
        m_server.setListenBacklogSize(256);
        const QHostAddress address(m_options.everywhere ? QHostAddress::Any : QHostAddress::LocalHost);
        if (!m_server.listen(address, m_options.port))
            return "cannot listen on port " + std::to_string(m_options.port) + ": " +
                   m_server.errorString().toStdString();
        settle();
        return m_server.serverPort();
    }

    void stop(const std::string& reason) {
        m_stopped = true;
        m_server.close();
        for (QTimer* timer : {&m_due, &m_decision, &m_secondLook}) timer->stop();
        for (Peer& peer : m_peers) {
            if (!peer.connection) continue;
            peer.connection->send(
                link::Bye{reason});  // it closes the connection itself when it has read this
        }
    }

    void askForPictures() { m_picturesAsked = true; }
    void cut(const std::string& channel) {
        for (std::size_t i = 0; i < m_peers.size(); ++i) {
            if (m_barrier.status(i).name == channel && m_peers[i].connection)
                m_peers[i].connection->abort("the connection was cut");
        }
    }

    std::vector<ChannelStatus> status() const {
        std::vector<ChannelStatus> list;
        for (std::size_t i = 0; i < m_barrier.count(); ++i) list.push_back(m_barrier.status(i));
        return list;
    }
    std::uint64_t frame() const { return m_barrier.frame(); }

private:
    // Guests: connected, not known yet.

    void welcomeGuests() {
        while (QTcpSocket* socket = m_server.nextPendingConnection()) {
            socket->setParent(nullptr);
            auto connection =
                std::make_unique<link::Connection>(std::unique_ptr<QTcpSocket>(socket), link::kBeforeHello);
            if (m_guests.size() >= kMostGuests) continue;
            auto guest = std::make_shared<Guest>();
            guest->arrived_us = link::steadyClock_us();
            guest->connection = std::move(connection);
            const link::Greeting greeting = link::greeting();
            guest->nonce = greeting.nonce;
            m_guests.push_back(guest);
            guest->connection->send(greeting);
            listenTo(guest);
        }
        sweep();
    }

    void listenTo(const std::shared_ptr<Guest>& guest) {
        guest->connection->onMessage(
            [this, g = guest.get()](const link::Received& r) { hello(*g, std::get<link::Hello>(r.message)); },
            [this, g = guest.get()] {
                // Ever more rarely: strangers must not fill the log.
                if (const std::uint64_t n = ++m_strangers; (n & (n - 1)) == 0)
                    m_observer.note("a stranger (" + std::to_string(n) +
                                    ") left: " + g->connection->whyClosed());
                bury(std::move(g->connection));
                m_sweep.start(0);
            });
    }

    void hello(Guest& guest, const link::Hello& hello) {
        std::string objection;
        const std::optional<std::size_t> slot = slotFor(hello, guest, objection);
        if (!slot) {
            guest.connection->send(link::Refused{objection, {}});
            guest.connection->close("refused: " + objection);
            return;
        }
        if (hello.build != core::coreBuildId())
            m_observer.note(hello.channel + " is of another build; its sea may differ in the last digits");
        takeIn(*slot, std::move(guest.connection));
        m_sweep.start(0);
    }

    std::optional<std::size_t> slotFor(const link::Hello& hello, const Guest& guest, std::string& objection) {
        if (const auto wrong = link::objectionTo(hello, guest.nonce, m_options.token))
            return objection = *wrong, std::nullopt;
        if (hello.role == link::Role::Observer) return observerSlot(objection);
        for (std::size_t i = 0; i < m_layout.channels.size(); ++i) {
            if (m_barrier.status(i).name != hello.channel) continue;
            if (!m_peers[i].connection) return i;
            return objection = "the channel " + hello.channel + " is taken", std::nullopt;
        }
        return objection = "the wall " + m_layout.id + " has no channel of this name", std::nullopt;
    }

    std::optional<std::size_t> observerSlot(std::string& objection) {
        for (std::size_t i = m_layout.channels.size(); i < m_peers.size(); ++i) {
            if (!m_peers[i].connection) return i;
        }
        const std::size_t observers = m_peers.size() - m_layout.channels.size();
        if (observers >= kMostObservers) return objection = "there are observers enough", std::nullopt;
        link::ChannelView view = m_layout.channels.front().view;
        view.name = "observer-" + std::to_string(observers + 1);
        m_peers.push_back({nullptr, view, {}, 0, false});
        return m_barrier.addSlot({view.name, false});
    }

    // Channels.

    void takeIn(std::size_t index, std::unique_ptr<link::Connection> connection) {
        Peer& peer = m_peers[index];
        peer.clock = {};
        peer.pinged_us = 0;
        peer.pictureAsked = false;
        peer.connection = std::move(connection);
        peer.connection->expect(link::kFromChannel);
        m_barrier.connected(index, link::steadyClock_us());
        m_observer.note(peer.view.name + " has connected from " + peer.connection->peer());
        peer.connection->onMessage(
            [this, index](const link::Received& r) {
                std::visit([&](const auto& m) { hear(index, m, r.at_us); }, r.message);
                settle();
            },
            [this, index] {
                const std::string why = m_peers[index].connection->whyClosed();
                bury(std::move(m_peers[index].connection));
                m_barrier.gone(index, why);
                settle();
            });
        peer.connection->send(link::Welcome{peer.view});
        peer.connection->sendPacket(m_setup);
        settle();
    }

    void hear(std::size_t index, const link::Ready&, std::int64_t at_us) { m_barrier.ready(index, at_us); }
    void hear(std::size_t index, const link::Rendered& m, std::int64_t at_us) {
        m_barrier.rendered(index, m.frame, at_us);
    }
    void hear(std::size_t index, const link::Shown& m, std::int64_t) {
        const std::int64_t at_us = m_peers[index].clock.toOurs_us(m.at_us);
        m_barrier.shown(index, m.frame, at_us);
        m_observer.shown(m_peers[index].view.name, m.frame, at_us);
    }
    void hear(std::size_t index, const link::Pong& m, std::int64_t at_us) {
        m_peers[index].clock.add(m, at_us);
    }
    void hear(std::size_t index, const link::Picture& m, std::int64_t) {
        Peer& peer = m_peers[index];
        peer.connection->expect(link::kFromChannel);
        if (!std::exchange(peer.pictureAsked, false))
            return peer.connection->abort("it sent a picture nobody asked for");
        m_observer.picture(peer.view.name, m);
    }
    void hear(std::size_t index, const link::Bye& m, std::int64_t) {
        m_peers[index].connection->close(m.reason);
    }
    void hear(std::size_t index, const link::Refused& m, std::int64_t) {
        m_peers[index].connection->close("it refused: " + m.reason);
    }
    template <typename Other>
    void hear(std::size_t, const Other&, std::int64_t) {}  // does not get past the connection

    // The barrier's will.

    void settle() {
        if (m_settling || m_stopped) return;  // whoever is in here already goes on until all is done
        m_settling = true;
        do {
            for (auto events = m_barrier.take(); !events.empty(); events = m_barrier.take()) {
                for (const BarrierEvent& event : events) obey(event);
            }
        } while (beginIfDue());
        m_settling = false;
        armTimers();
    }

    void obey(const BarrierEvent& event) {
        const std::string& name = m_barrier.status(event.channel).name;
        switch (event.kind) {
            case BarrierEvent::Kind::Show:
                return show(event.channel, event.frame);
            case BarrierEvent::Kind::InStep:
                return m_observer.inStep(name);
            case BarrierEvent::Kind::Lost:
                return m_observer.lost(name, event.reason);
            case BarrierEvent::Kind::Disconnect:
                if (m_peers[event.channel].connection) m_peers[event.channel].connection->abort(event.reason);
                return m_observer.hangs(name, event.reason);
            case BarrierEvent::Kind::FrameOver:
                return m_observer.frameOver(event.frame, event.spread_us);
        }
    }

    void show(std::size_t index, std::uint64_t frame) {
        Peer& peer = m_peers[index];
        if (!peer.connection) return;
        const std::int64_t now_us = link::steadyClock_us();
        // The channel has just told that it waits: the best moment to ask for its clock.
        if (now_us - peer.pinged_us > kPingEvery_us) {
            peer.pinged_us = now_us;
            peer.connection->send(link::Ping{++m_pings, now_us});
        }
        const bool picture = m_pictureFrame == frame;
        if (picture) {
            peer.pictureAsked = true;
            peer.connection->expect(link::kFromChannelWithPicture);
        }
        peer.connection->send(link::Show{frame, picture});
    }

    bool beginIfDue() {
        const std::int64_t now_us = link::steadyClock_us();
        if (!m_barrier.mayBegin() || now_us < m_due_us) return false;
        const std::int64_t period_us =
            m_options.rate_Hz > 0.0 ? static_cast<std::int64_t>(std::llround(1e6 / m_options.rate_Hz)) : 0;
        // Even beats as long as they can be kept; never a burst to catch up.
        m_due_us = now_us - m_due_us < period_us ? m_due_us + period_us : now_us + period_us;
        const FrameBarrier::Begun begun = m_barrier.begin(now_us);
        if (std::exchange(m_picturesAsked, false)) m_pictureFrame = begun.frame;
        Moment moment = m_source();
        if (begun.recipients.empty()) {
            m_due_us = std::max(m_due_us, now_us + kIdleFrame_us);
            return false;
        }
        const core::Bytes packet =
            link::encode(link::Frame{begun.frame, moment.time, std::move(moment.snapshot)});
        for (const std::size_t index : begun.recipients) {
            if (m_peers[index].connection) m_peers[index].connection->sendPacket(packet);
        }
        return true;
    }

    void armTimers() {
        if (m_stopped) return;
        const std::int64_t now_us = link::steadyClock_us();
        const auto arm = [now_us](QTimer& timer, std::int64_t at_us) {
            timer.start(static_cast<int>(std::clamp<std::int64_t>((at_us - now_us + 999) / 1000, 0, 60'000)));
        };
        if (m_barrier.mayBegin()) {
            arm(m_due, m_due_us);
        } else {
            m_due.stop();
        }
        if (!m_secondLook.isActive())
            arm(m_decision, std::min(m_barrier.nextDecision_us(), now_us + 10'000'000));
    }

    /// Connections that called us are destroyed when they have returned.
    void bury(std::unique_ptr<link::Connection> connection) {
        m_graves.push_back(std::move(connection));
        m_sweep.start(0);
    }
    void sweep() {
        const std::int64_t now_us = link::steadyClock_us();
        for (const auto& guest : std::vector(m_guests)) {
            if (guest->connection && now_us - guest->arrived_us > kHello_us)
                guest->connection->abort("it did not say who it is");
        }
        m_guests.erase(std::remove_if(m_guests.begin(), m_guests.end(),
                                      [](const auto& guest) { return guest->connection == nullptr; }),
                       m_guests.end());
        m_graves.clear();
        if (!m_guests.empty()) m_sweep.start(1000);
    }

    Layout m_layout;
    WallOptions m_options;
    std::shared_ptr<const core::World> m_world;
    MomentSource m_source;
    WallObserver& m_observer;
    FrameBarrier m_barrier;
    std::vector<Peer> m_peers;  ///< by slot of the barrier
    std::vector<std::shared_ptr<Guest>> m_guests;
    std::vector<std::unique_ptr<link::Connection>> m_graves;
    core::Bytes m_setup;  ///< encoded once
    QObject m_context;
    QTcpServer m_server;
    QTimer m_due, m_decision, m_secondLook, m_sweep;
    std::int64_t m_due_us = 0;
    std::uint64_t m_pings = 0;
    std::uint64_t m_strangers = 0;
    std::uint64_t m_pictureFrame = 0;
    bool m_picturesAsked = false;
    bool m_settling = false;
    bool m_stopped = false;
};

WallServer::WallServer(Layout layout, WallOptions options, std::shared_ptr<const core::World> world,
                       MomentSource source, WallObserver& observer)
    : m_impl(std::make_unique<Impl>(std::move(layout), std::move(options), std::move(world),
                                    std::move(source), observer)) {}
WallServer::~WallServer() = default;
core::Result<std::uint16_t, std::string> WallServer::listen() { return m_impl->listen(); }
void WallServer::stop(const std::string& reason) { m_impl->stop(reason); }
void WallServer::askForPictures() { m_impl->askForPictures(); }
void WallServer::cut(const std::string& channel) { m_impl->cut(channel); }
std::vector<ChannelStatus> WallServer::status() const { return m_impl->status(); }
std::uint64_t WallServer::frame() const { return m_impl->frame(); }

}  // namespace sagara::wall
