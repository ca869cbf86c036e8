#include "app/run/RunWall.h"

#include <fmt/format.h>

#include <QEventLoop>
#include <QTimer>
#include <algorithm>
#include <csignal>
#include <cstdlib>

#include "app/files/BuildScenario.h"
#include "app/live/LiveRun.h"
#include "app/live/SteppedRun.h"
#include "app/run/CommandDelay.h"
#include "app/run/Console.h"
#include "app/run/RunOptions.h"
#include "app/run/WallLayouts.h"
#include "app/run/WallPictures.h"
#include "app/run/WallStatistics.h"
#include "core/base/Units.h"
#include "core/exercise/Session.h"
#include "render/link/SteadyClock.h"
#include "render/wall/LocalChannels.h"

namespace sagara::run {
namespace {

namespace fs = std::filesystem;

constexpr double kAssemble_s = 20.0;  ///< channels that are not there by then join later

std::optional<wall::Layout> findLayout(const WallRunOptions& options) {
    auto found = findWallLayout(options.layout);
    if (!found) return tell(found.error()), std::nullopt;
    wall::Layout layout = std::move(found).value();
    if (options.size_px) layout = wall::resized(layout, options.size_px->first, options.size_px->second);
    if (options.fullScreen) layout = wall::fullScreen(layout);
    if (options.offscreen) layout = wall::offscreen(layout);
    return layout;
}

fs::path viewProgram(const WallRunOptions& options) {
    return options.view ? fs::absolute(*options.view) : run::viewProgram();
}

std::string tokenOfEnvironment() {
    const char* token = std::getenv(wall::kTokenVariable);
    return token ? token : "";
}

/// One run of a wall: server, programs, exercise and what is told of them.
class WallRun final : public wall::WallObserver {
public:
    WallRun(const WallRunOptions& options, wall::Layout layout, std::shared_ptr<const core::World> world)
        : m_options(options),
          m_layout(std::move(layout)),
          m_world(std::move(world)),
          m_start(startOf(m_world, options)),
          m_live(m_world, m_start, planned(options)),
          m_stepped(m_world, m_start, planned(options), 1.0 / options.rate_Hz),
          m_server(
              m_layout, serverOptions(options), m_world, [this] { return moment(); }, *this) {
        std::vector<std::string> names;
        for (const wall::LayoutChannel& channel : m_layout.channels) names.push_back(channel.view.name);
        if (options.shots) m_pictures.emplace(*options.shots, names);
    }

    int run() {
        const auto port = m_server.listen();
        if (!port) return tell(port.error()), kBadRequest;
        m_channels.emplace(m_layout,
                           wall::LocalChannels::Program{viewProgram(m_options), m_options.viewArguments},
                           *port, tokenOfEnvironment(), [](const std::string& message) { tell(message); });
        tellOfOthers(*port);
        m_channels->start();
        QTimer beat;
        QObject::connect(&beat, &QTimer::timeout, &beat, [this] { watch(); });
        beat.start(10);
        m_begun_s = wallClock_s();
        m_loop.exec();
        m_live.stop();
        const auto status = m_server.status();
        m_server.stop("the run is over");
        m_channels->stop(2000);
        return report(status);
    }

    // WallObserver
    void inStep(const std::string& channel) override { tell(channel + " is in step"); }
    void lost(const std::string& channel, const std::string& reason) override {
        tell(fmt::format("{} is lost: {}", channel, reason));
    }
    void hangs(const std::string& channel, const std::string& reason) override {
        tell(fmt::format("{} hangs and is started again: {}", channel, reason));
        m_channels->restart(channel);
    }
    void shown(const std::string& channel, std::uint64_t frame, std::int64_t at_us) override {
        if (m_started) m_statistics.shown(channel, frame, at_us);
        m_delay.shown(frame, at_us);
    }
    void frameOver(std::uint64_t frame, std::int64_t spread_us) override {
        if (m_started) m_statistics.frameOver(spread_us);
        m_delay.frameOver(frame);
    }
    void picture(const std::string& channel, const link::Picture& picture) override {
        if (m_pictures) m_pictures->add(channel, picture);
    }
    void note(const std::string& message) override { tell(message); }

private:
    static core::State startOf(const std::shared_ptr<const core::World>& world,
                               const WallRunOptions& options) {
        const core::SimTime at{static_cast<std::int64_t>(1e6 * options.at_s)};
        return core::sailedByPilot(world, options.level, at);
    }
    static std::vector<core::Command> planned(const WallRunOptions& options) {
        if (options.at_s > 0.0) return {{0, 0, core::PilotOrder{options.pilot}}};
        if (!options.pilot) return {};
        return {{0, 0, core::PilotOrder{true}}};
    }
    static wall::WallOptions serverOptions(const WallRunOptions& options) {
        wall::WallOptions server;
        server.everywhere = options.listen;
        server.port = options.port;
        server.token = tokenOfEnvironment();
        server.rate_Hz = options.fast ? 0.0 : options.rate_Hz;
        return server;
    }

    wall::Moment moment() {
        wall::Moment moment = m_options.fast ? m_stepped.next() : m_live.toDraw(m_clock);
        m_time = moment.time;
        if (const auto at = m_live.carriedOut()) m_delay.carriedOut(*at);
        m_delay.sent(m_server.frame(), moment.time);
        return moment;
    }
    bool over() const { return m_options.fast ? m_stepped.over() : m_live.over(); }

    void tellOfOthers(std::uint16_t port) const {
        for (const wall::LayoutChannel& channel : m_layout.channels) {
            if (channel.local()) continue;
            tell(fmt::format("waiting for {}: start on {}: sagara-view --connect THIS-PC:{} --channel {}",
                             channel.view.name, channel.host, port, channel.view.name));
        }
    }

    std::size_t inStepNow() const {
        const auto status = m_server.status();
        return static_cast<std::size_t>(std::count_if(status.begin(), status.end(), [](const auto& s) {
            return s.state == wall::ChannelState::InStep;
        }));
    }

    void watch() {
        const double now_s = wallClock_s();
        if (!m_started) {
            const bool complete = inStepNow() == m_layout.channels.size();
            if (!complete && now_s - m_begun_s < kAssemble_s) return;
            if (!complete && inStepNow() == 0) return m_loop.quit();
            tell(fmt::format("{} of {} channels in step after {:.2f} s", inStepNow(),
                             m_layout.channels.size(), now_s - m_begun_s));
            m_started = true;
            m_first = m_time;
            m_lastKill_s = now_s;
            m_live.start();
            m_stepped.start();
        }
        const double sailed_s = m_time.seconds() - m_first.seconds();
        takeShots(sailed_s);
        if (m_options.killEvery_s && now_s - m_lastKill_s >= *m_options.killEvery_s) killOne(now_s);
        if (m_options.orderEvery_s && now_s - m_lastOrder_s >= *m_options.orderEvery_s) giveOrder(now_s);
        if (sailed_s >= m_options.duration_s || over()) m_loop.quit();
        if (m_progress.due()) m_progress.show(m_statistics.text());
    }

    void takeShots(double sailed_s) {
        if (!m_pictures || sailed_s < m_nextShot_s) return;
        writeShot();
        m_server.askForPictures();
        m_nextShot_s = sailed_s + m_options.shotEvery_s;
    }
    void writeShot() {
        if (const auto trouble = m_pictures->write()) tell(*trouble), m_sound = false;
    }

    void killOne(double now_s) {
        m_lastKill_s = now_s;
        const std::string& name = m_layout.channels[m_kills++ % m_layout.channels.size()].view.name;
        wall::ChannelProcess* process = m_channels->find(name);
        if (!process || process->processId() == 0) return;
        tell(fmt::format("trial: {} is killed", name));
        ::kill(static_cast<pid_t>(process->processId()), SIGKILL);
    }

    /// Port and starboard five in turn: seen in the rudder, harmless to the ship.
    void giveOrder(double now_s) {
        if (m_delay.waiting()) return;
        m_lastOrder_s = now_s;
        m_portFive = !m_portFive;
        m_delay.given(link::steadyClock_us());
        m_live.give(0, core::HelmOrder{(m_portFive ? -5.0 : 5.0) * core::kDegree_rad});
    }

    int report(const std::vector<wall::ChannelStatus>& status) {
        if (m_pictures) writeShot();
        if (!m_started) return tell("no channel came into step"), kMachineFailed;
        std::string text = fmt::format("wall {}: {}\n", m_layout.id, m_statistics.text());
        for (const wall::ChannelStatus& channel : status) text += "  " + m_statistics.textOf(channel) + "\n";
        if (m_options.orderEvery_s) text += "  " + m_delay.text() + "\n";
        if (m_live.lagged_s() > 0.0)
            text += fmt::format("  the simulation fell back by {:.1f} s: this machine is too slow for it\n",
                                m_live.lagged_s());
        if (m_pictures)
            text += fmt::format("  {} pictures in {}\n", m_pictures->written(), m_options.shots->string());
        print(text);
        return m_sound ? kDone : kMachineFailed;
    }

    const WallRunOptions& m_options;
    wall::Layout m_layout;
    std::shared_ptr<const core::World> m_world;
    core::State m_start;
    live::LiveRun m_live;
    live::SteppedRun m_stepped;
    std::optional<WallPictures> m_pictures;
    WallStatistics m_statistics;
    Progress m_progress;
    std::optional<wall::LocalChannels> m_channels;
    wall::WallServer m_server;
    QEventLoop m_loop;
    wall::FrameClock m_clock;
    core::SimTime m_time, m_first;
    CommandDelay m_delay;
    double m_begun_s = 0.0, m_nextShot_s = 0.0, m_lastKill_s = 0.0, m_lastOrder_s = 0.0;
    bool m_portFive = false;
    std::size_t m_kills = 0;
    bool m_started = false;
    bool m_sound = true;
};

}  // namespace

int runWall(Store& store, const WallRunOptions& options) {
    if (!store.trouble().empty()) tell(store.trouble());
    auto layout = findLayout(options);
    if (!layout) return kBadRequest;
    auto world = files::buildScenario(store, options.scenario, options.seed, options.changes);
    if (!world) return tell(world.error()), kBadRequest;
    if (const fs::path view = viewProgram(options); !fs::exists(view))
        return tell("there is no " + view.string() + "; name the channel program with --view"), kBadRequest;
    if (options.shots) {
        std::error_code error;
        fs::create_directories(*options.shots, error);
        if (error)
            return tell("cannot make " + options.shots->string() + ": " + error.message()), kMachineFailed;
    }
    WallRun run(options, std::move(*layout), std::move(world).value());
    return run.run();
}

}  // namespace sagara::run
