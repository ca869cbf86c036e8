#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace sagara::render {

/// A thread that carries out closures in the order they were given. What is left when it is destroyed is
/// still done.
class RenderThread final {
public:
    RenderThread();
    ~RenderThread();
    RenderThread(const RenderThread&) = delete;
    RenderThread& operator=(const RenderThread&) = delete;

    void post(std::function<void()> work);
    /// Waits until it is done; what it throws is thrown here. Not from the thread itself.
    void run(const std::function<void()>& work);
    std::size_t waiting() const;

private:
    void loop();

    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    std::deque<std::function<void()>> m_queue;
    bool m_ending = false;
    std::thread m_thread;  ///< last: it uses the others
};

}  // namespace sagara::render
