#include "render/wall/ChannelClient.h"

#include <algorithm>
#include <thread>

#include "render/link/SteadyClock.h"

namespace sagara::wall {
namespace {

constexpr int kIdle_ms = 10, kHandshake_ms = 5'000, kRetry_ms = 200;

/// What a channel keeps from one connection to the next, so that it is back fast.
class Channel {
public:
    Channel(FrameRenderer& renderer, const std::function<void(const std::string&)>& tell)
        : m_renderer(renderer), m_tell(tell) {}

    /// Until the connection is closed (nothing) or there is no going on.
    std::optional<ChannelEnd> serve(link::Connection& station, const link::ChannelView& view) {
        m_view = view;
        m_ready = false;
        m_drawn.reset();
        while (station.isOpen()) {
            if (!m_renderer.idle()) {
                station.send(link::Bye{"the window was closed"});
                station.close("the window was closed");
                return ChannelEnd{false, "the window was closed"};
            }
            auto received = station.wait(kIdle_ms);
            if (!received) continue;
            auto end =
                std::visit([&](auto& m) { return hear(station, m, received->at_us); }, received->message);
            if (end) return end;
        }
        m_tell(station.whyClosed());
        return std::nullopt;
    }

private:
    using End = std::optional<ChannelEnd>;

    End fail(link::Connection& station, std::string reason) {
        station.send(link::Bye{reason});
        station.close(reason);
        return ChannelEnd{true, std::move(reason)};
    }

    End hear(link::Connection& station, link::Setup& setup, std::int64_t) {
        if (!sameExercise(setup)) {
            auto world = core::buildWorld(setup.documents, setup.seed, core::WorldUse::Look);
            if (!world) return fail(station, "the exercise cannot be built here: " + world.error().text());
            m_world = std::move(world).value();
            m_viewSetUp.reset();
        }
        if (m_view.ship >= m_world->ships.size())
            return fail(station, "the wall looks from ship " + std::to_string(m_view.ship + 1) +
                                     ", the exercise has " + std::to_string(m_world->ships.size()));
        if (m_viewSetUp != m_view) {
            if (auto trouble = m_renderer.setup(m_world, m_view)) return fail(station, *trouble);
            m_viewSetUp = m_view;
        }
        m_ready = true;
        station.send(link::Ready{});
        return std::nullopt;
    }

    End hear(link::Connection& station, link::Frame& frame, std::int64_t) {
        if (!m_ready || !fits(frame.snapshot, *m_world)) {
            station.send(link::Refused{"the frame does not fit the exercise", {}});
            station.close("the station sent a frame that does not fit the exercise");
            return std::nullopt;
        }
        const std::int64_t begin_us = link::steadyClock_us();
        raise(frame.snapshot.sea);
        m_renderer.render(frame);
        m_drawn = frame.number;
        station.send(
            link::Rendered{frame.number, static_cast<std::uint32_t>(link::steadyClock_us() - begin_us)});
        return std::nullopt;
    }

    End hear(link::Connection& station, const link::Show& show, std::int64_t) {
        if (m_drawn != show.frame) return std::nullopt;
        m_renderer.show();
        station.send(link::Shown{show.frame, link::steadyClock_us()});
        if (!show.picture) return std::nullopt;
        if (auto picture = m_renderer.picture()) {
            picture->frame = show.frame;
            station.send(std::move(*picture));
        }
        return std::nullopt;
    }

    End hear(link::Connection& station, const link::Ping& ping, std::int64_t at_us) {
        station.send(link::Pong{ping.id, ping.sent_us, at_us, link::steadyClock_us()});
        return std::nullopt;
    }
    End hear(link::Connection& station, const link::Bye& bye, std::int64_t) {
        station.close(bye.reason);
        return ChannelEnd{false, bye.reason};
    }
    End hear(link::Connection& station, const link::Refused& refused, std::int64_t) {
        station.close("the station refuses: " + refused.reason);
        return std::nullopt;
    }
    /// Nothing else gets past the connection in this phase.
    template <typename Other>
    End hear(link::Connection&, const Other&, std::int64_t) {
        return std::nullopt;
    }

    bool sameExercise(const link::Setup& setup) const {
        const auto same = [](const core::NamedText& a, const core::NamedText& b) { return a.text == b.text; };
        if (!m_world || m_world->seed != setup.seed) return false;
        const core::ExerciseDocuments &a = m_world->documents, &b = setup.documents;
        return same(a.scenario, b.scenario) && same(a.area, b.area) &&
               std::equal(a.vessels.begin(), a.vessels.end(), b.vessels.begin(), b.vessels.end(), same);
    }

    /// The same components as the station's; worked out when the weather has changed, once a second at most.
    void raise(core::SeaState& sea) {
        if (sea.systems != m_sea.systems || !m_seaWorld || m_seaWorld != m_world) {
            m_sea.systems = sea.systems;
            core::raiseSea(m_world->waves, m_sea);
            m_seaWorld = m_world;
        }
        sea = m_sea;
    }

    FrameRenderer& m_renderer;
    const std::function<void(const std::string&)>& m_tell;
    std::shared_ptr<const core::World> m_world;
    link::ChannelView m_view;
    std::optional<link::ChannelView> m_viewSetUp;
    bool m_ready = false;
    std::optional<std::uint64_t> m_drawn;
    core::SeaState m_sea;
    std::shared_ptr<const core::World> m_seaWorld;
};

}  // namespace

bool fits(const core::Snapshot& snapshot, const core::World& world) {
    if (snapshot.ships.size() != world.ships.size()) return false;
    for (std::size_t i = 0; i < snapshot.ships.size(); ++i) {
        const core::OwnShipView& seen = snapshot.ships[i];
        const core::OwnShip& ship = *world.ships[i];
        if (seen.shafts_rps.size() != ship.shaftCount() || seen.lines.size() != ship.lines.size() ||
            seen.anchors.size() != ship.anchorCount())
            return false;
    }
    return std::all_of(snapshot.targets.begin(), snapshot.targets.end(), [&](const core::TargetView& t) {
        return t.index < world.targets.size() + snapshot.added.size();
    });
}

ChannelEnd runChannel(const ChannelOptions& options, FrameRenderer& renderer,
                      const std::function<void(const std::string&)>& tell) {
    Channel channel(renderer, tell);
    const auto patience_us = static_cast<std::int64_t>(1e6 * options.patience_s);
    for (std::int64_t lastHeard_us = link::steadyClock_us();;) {
        std::string trouble;
        auto station = link::Connection::to(options.host, options.port, kHandshake_ms, link::kBeforeGreeting);
        if (station) {
            const auto view = link::introduce(**station, options.who, kHandshake_ms);
            if (view) {
                if (auto end = channel.serve(**station, *view)) return *end;
                lastHeard_us = link::steadyClock_us();
                trouble = (*station)->whyClosed();
            } else {
                trouble = view.error();
            }
        } else {
            trouble = station.error();
        }
        if (link::steadyClock_us() - lastHeard_us >= patience_us) return {true, trouble};
        if (!renderer.idle()) return {false, "the window was closed"};
        std::this_thread::sleep_for(std::chrono::milliseconds(kRetry_ms));
    }
}

}  // namespace sagara::wall
