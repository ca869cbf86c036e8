#include "app/station/StationWall.h"

#include <QObject>
#include <QThread>
#include <QTimer>
#include <cstdlib>
#include <map>
#include <mutex>

#include "app/run/WallLayouts.h"
#include "render/link/SteadyClock.h"
#include "render/wall/LocalChannels.h"

namespace sagara::station {
namespace {

constexpr int kBeat_ms = 500, kPatience_ms = 2000;
constexpr std::size_t kNotes = 50;

wall::Layout placed(wall::Layout layout, ui::WallPlacement placement) {
    if (placement == ui::WallPlacement::FullScreen) return wall::fullScreen(layout);
    if (placement == ui::WallPlacement::Hidden) return wall::offscreen(layout);
    return layout;
}

std::string token() {
    const char* const token = std::getenv(wall::kTokenVariable);
    return token ? token : "";
}

}  // namespace

/// What both threads know.
struct StationWall::Shared {
    std::mutex mutex;
    Status status;
};

/// One wall that runs. Of the thread of the wall.
class StationWall::Works final : public wall::WallObserver {
public:
    Works(std::shared_ptr<const core::World> world, wall::MomentSource source, std::shared_ptr<Shared> shared)
        : m_world(std::move(world)), m_source(std::move(source)), m_shared(std::move(shared)) {
        m_post.moveToThread(&m_thread);
        m_thread.setObjectName(QStringLiteral("wall"));
        m_thread.start();
    }
    ~Works() override {
        QMetaObject::invokeMethod(
            &m_post, [this] { close(); }, Qt::BlockingQueuedConnection);
        m_thread.quit();
        m_thread.wait();
    }
    /// Does it in the thread of the wall.
    template <typename Do>
    void post(Do&& act) {
        QMetaObject::invokeMethod(&m_post, std::forward<Do>(act), Qt::QueuedConnection);
    }

    void open(const std::string& id, ui::WallPlacement placement) {
        close();
        auto layout = run::findWallLayout(id);
        if (!layout) return fail(layout.error());
        m_layout = placed(std::move(layout).value(), placement);
        const auto program = run::viewProgram();
        if (!std::filesystem::exists(program)) return fail("there is no " + program.string());
        wall::WallOptions options;
        options.token = token();
        m_server = std::make_unique<wall::WallServer>(m_layout, options, m_world, m_source, *this);
        const auto port = m_server->listen();
        if (!port) {
            m_server.reset();
            return fail(port.error());
        }
        m_channels = std::make_unique<wall::LocalChannels>(
            m_layout, wall::LocalChannels::Program{program, {}}, *port, options.token,
            [this](const std::string& message) { note(message); });
        m_channels->start();
        m_port = *port;
        m_beat = std::make_unique<QTimer>();
        QObject::connect(m_beat.get(), &QTimer::timeout, m_beat.get(), [this] { publish(); });
        m_beat->start(kBeat_ms);
        publish();
    }
    void close() {
        m_beat.reset();
        if (m_server) m_server->stop("the wall was stopped");
        if (m_channels) m_channels->stop(kPatience_ms);
        m_channels.reset();
        m_server.reset();
        m_before.clear();
        const std::lock_guard lock(m_shared->mutex);
        m_shared->status.running = false;
        m_shared->status.channels.clear();
    }
    void restart(const std::string& channel) {
        if (m_channels) m_channels->restart(channel);
    }

    // WallObserver
    void inStep(const std::string& channel) override { note(channel + " is in step"); }
    void lost(const std::string& channel, const std::string& reason) override {
        note(channel + " is lost: " + reason);
    }
    void hangs(const std::string& channel, const std::string& reason) override {
        note(channel + " hangs and is started again: " + reason);
        m_channels->restart(channel);
    }
    void note(const std::string& message) override {
        const std::lock_guard lock(m_shared->mutex);
        auto& notes = m_shared->status.notes;
        notes.push_back(message);
        if (notes.size() > kNotes) notes.erase(notes.begin());
    }

private:
    void fail(const std::string& why) {
        const std::lock_guard lock(m_shared->mutex);
        m_shared->status.running = false;
        m_shared->status.trouble = why;
    }

    void publish() {
        const std::int64_t now_us = link::steadyClock_us();
        std::vector<Channel> channels;
        for (const wall::ChannelStatus& s : m_server->status()) {
            Channel channel{s.name,
                            wall::channelStateName(s.state),
                            rateOf(s, now_us),
                            1e-3 * static_cast<double>(s.took_us),
                            1e-3 * static_cast<double>(s.skew_us),
                            s.timesLost,
                            s.reason,
                            m_channels->find(s.name) != nullptr};
            channels.push_back(std::move(channel));
        }
        const std::lock_guard lock(m_shared->mutex);
        Status& status = m_shared->status;
        status.running = true;
        status.layout = m_layout.id;
        status.trouble.clear();
        status.port = m_port;
        status.channels = std::move(channels);
    }

    /// Over the last four beats, so that the figure does not jump.
    double rateOf(const wall::ChannelStatus& s, std::int64_t now_us) {
        auto& before = m_before[s.name];
        before.emplace_back(now_us, s.framesShown);
        if (before.size() > 5) before.erase(before.begin());
        const double span_s = 1e-6 * static_cast<double>(now_us - before.front().first);
        if (span_s <= 0.0 || s.framesShown < before.front().second) return 0.0;
        return static_cast<double>(s.framesShown - before.front().second) / span_s;
    }

    const std::shared_ptr<const core::World> m_world;
    const wall::MomentSource m_source;
    const std::shared_ptr<Shared> m_shared;
    QThread m_thread;
    QObject m_post;  ///< receives what is posted; lives in m_thread
    wall::Layout m_layout;
    std::unique_ptr<wall::WallServer> m_server;
    std::unique_ptr<wall::LocalChannels> m_channels;
    std::unique_ptr<QTimer> m_beat;
    std::uint16_t m_port = 0;
    std::map<std::string, std::vector<std::pair<std::int64_t, std::uint64_t>>> m_before;
};

StationWall::StationWall(std::shared_ptr<const core::World> world, wall::MomentSource source)
    : m_shared(std::make_shared<Shared>()),
      m_works(std::make_unique<Works>(std::move(world), std::move(source), m_shared)) {}

StationWall::~StationWall() = default;

std::vector<ui::WallControl::Layout> StationWall::layouts() const {
    std::vector<Layout> entries;
    for (const wall::Layout& layout : run::wallLayouts())
        entries.push_back({layout.id, layout.name, layout.channels.size()});
    return entries;
}

void StationWall::start(const std::string& layout, ui::WallPlacement placement) {
    m_works->post([works = m_works.get(), layout, placement] { works->open(layout, placement); });
}

void StationWall::stop() {
    m_works->post([works = m_works.get()] { works->close(); });
}

void StationWall::restart(const std::string& channel) {
    m_works->post([works = m_works.get(), channel] { works->restart(channel); });
}

ui::WallControl::Status StationWall::status() const {
    const std::lock_guard lock(m_shared->mutex);
    return m_shared->status;
}

}  // namespace sagara::station
