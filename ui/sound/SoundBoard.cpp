#include "ui/sound/SoundBoard.h"

#include <algorithm>

#include "ui/sound/SoundPlayer.h"

namespace sagara::ui {
namespace {

using namespace std::chrono_literals;

constexpr auto kFadesAfter = 500ms;
constexpr auto kRound = 12ms;
constexpr auto kTest = 1200ms;

}  // namespace

SoundBoard::SoundBoard() : m_thread([this] { run(); }) {}

SoundBoard::~SoundBoard() {
    {
        const std::lock_guard lock(m_mutex);
        m_quit = true;
    }
    m_wake.notify_all();
    m_thread.join();
}

void SoundBoard::play(const SoundScene& scene) {
    const std::lock_guard lock(m_mutex);
    m_scene = scene;
    m_played = Clock::now();
}

void SoundBoard::setVolume(double volume) { m_volume = std::clamp(volume, 0.0, 1.0); }

void SoundBoard::soundTest() {
    const std::lock_guard lock(m_mutex);
    m_testUntil = Clock::now() + kTest;
}

SoundBoard::Status SoundBoard::status() const {
    const std::lock_guard lock(m_mutex);
    return m_status;
}

void SoundBoard::lookAgain() {
    {
        const std::lock_guard lock(m_mutex);
        if (m_status.device != Device::None) return;
        m_again = true;
        m_status.device = Device::Looking;
    }
    m_wake.notify_all();
}

void SoundBoard::setStatus(Device device, std::string name) {
    const std::lock_guard lock(m_mutex);
    m_status = {device, std::move(name)};
}

SoundScene SoundBoard::sceneNow() const {
    const std::lock_guard lock(m_mutex);
    const auto now = Clock::now();
    SoundScene scene = now - m_played < kFadesAfter ? m_scene : SoundScene{};
    scene.horn = scene.horn || now < m_testUntil;
    return scene;
}

void SoundBoard::run() {
    for (;;) {
        SoundPlayer player;
        const bool found = player.open();
        setStatus(found ? Device::Found : Device::None, player.deviceName());
        if (found) playOn(player);
        std::unique_lock lock(m_mutex);
        if (found && !m_quit) m_status = {Device::None, {}};  // it was pulled out
        m_wake.wait(lock, [this] { return m_quit || m_again; });
        if (m_quit) return;
        m_again = false;
    }
}

void SoundBoard::playOn(SoundPlayer& player) {
    for (;;) {
        player.play(sceneNow(), m_muted ? 0.0 : m_volume.load());
        if (!player.connected()) return;
        std::unique_lock lock(m_mutex);
        if (m_wake.wait_for(lock, kRound, [this] { return m_quit; })) return;
    }
}

}  // namespace sagara::ui
