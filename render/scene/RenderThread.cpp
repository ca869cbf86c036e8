#include "render/scene/RenderThread.h"

#include <cassert>
#include <future>

namespace sagara::render {

RenderThread::RenderThread() : m_thread([this] { loop(); }) {}

RenderThread::~RenderThread() {
    {
        const std::lock_guard lock(m_mutex);
        m_ending = true;
    }
    m_wake.notify_one();
    m_thread.join();
}

void RenderThread::post(std::function<void()> work) {
    {
        const std::lock_guard lock(m_mutex);
        m_queue.push_back(std::move(work));
    }
    m_wake.notify_one();
}

void RenderThread::run(const std::function<void()>& work) {
    assert(std::this_thread::get_id() != m_thread.get_id());
    std::packaged_task<void()> task(work);
    auto done = task.get_future();
    post([&task] { task(); });
    done.get();
}

std::size_t RenderThread::waiting() const {
    const std::lock_guard lock(m_mutex);
    return m_queue.size();
}

void RenderThread::loop() {
    for (;;) {
        std::function<void()> work;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, [this] { return m_ending || !m_queue.empty(); });
            if (m_queue.empty()) return;
            work = std::move(m_queue.front());
            m_queue.pop_front();
        }
        work();
    }
}

}  // namespace sagara::render
