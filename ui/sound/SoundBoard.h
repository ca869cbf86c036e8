#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "ui/sound/SoundScene.h"

namespace sagara::ui {

class SoundPlayer;

/// Makes scenes sound, by OpenAL, on a thread of its own. Where there is no sound device it is silent and
/// says so in `status`. One in a program: OpenAL's current context is the process's. All calls from any
/// thread; none waits.
class SoundBoard final {
public:
    SoundBoard();
    ~SoundBoard();
    SoundBoard(const SoundBoard&) = delete;
    SoundBoard& operator=(const SoundBoard&) = delete;

    /// What is to be heard from now on. It fades half a second after the last call, so a run that ends or
    /// freezes falls silent by itself: call it at least five times a second.
    void play(const SoundScene& scene);
    void setMuted(bool muted) { m_muted = muted; }
    bool muted() const { return m_muted; }
    /// 0 to 1.
    void setVolume(double volume);
    double volume() const { return m_volume; }
    /// A short horn, to hear whether anything is heard.
    void soundTest();

    enum class Device { Looking, None, Found };
    struct Status {
        Device device = Device::Looking;
        std::string name;  ///< of the device
    };
    Status status() const;
    /// Somebody plugged in loudspeakers.
    void lookAgain();

private:
    using Clock = std::chrono::steady_clock;
    void run();
    void playOn(SoundPlayer& player);
    SoundScene sceneNow() const;
    void setStatus(Device device, std::string name);

    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    SoundScene m_scene;          ///< under m_mutex, as all down to m_quit
    Clock::time_point m_played;  ///< when the scene came
    Clock::time_point m_testUntil;
    Status m_status;
    bool m_again = false;
    bool m_quit = false;
    std::atomic<bool> m_muted = false;
    std::atomic<double> m_volume = 0.7;
    std::thread m_thread;  ///< last: begins when all else is there
};

}  // namespace sagara::ui
