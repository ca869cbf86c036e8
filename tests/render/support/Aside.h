#pragma once

#include <atomic>
#include <functional>
#include <thread>

namespace sagara::test {

/// Work in a thread of its own, waited for at the end of its life. Not a QThread: ThreadSanitizer cannot see
/// that one has waited for it.
class Aside {
public:
    explicit Aside(std::function<void()> work)
        : m_thread([this, work = std::move(work)] {
              work();
              m_finished = true;
          }) {}
    ~Aside() { wait(); }
    Aside(const Aside&) = delete;
    Aside& operator=(const Aside&) = delete;

    bool finished() const { return m_finished; }
    void wait() {
        if (m_thread.joinable()) m_thread.join();
    }

private:
    std::atomic<bool> m_finished{false};
    std::thread m_thread;
};

}  // namespace sagara::test
