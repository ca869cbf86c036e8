#pragma once

#include <cstdint>
#include <deque>
#include <future>
#include <map>
#include <memory>
#include <mutex>

#include "core/seakeeping/SeaHull.h"
#include "core/seakeeping/TableCache.h"

namespace sagara::core {

/// Hulls ready for the sea, each made once and shared by all ships and exercises of a program. A hull takes a
/// second or two the first time, a tenth of that from the cache and nothing while somebody holds it or it is
/// among the last few. From any thread; whoever wants one that is being made waits for it.
class SeaHulls {
public:
    /// Without a cache nothing outlives the program. It may be asked by several threads at once.
    explicit SeaHulls(std::shared_ptr<TableCache> cache = nullptr) : m_cache(std::move(cache)) {}

    /// What making the hull throws reaches everybody who waits for it; the next one tries again.
    std::shared_ptr<const SeaHull> of(const Hull& hull);

private:
    using Made = std::shared_future<std::shared_ptr<const SeaHull>>;
    std::shared_ptr<const SeaHull> held(std::uint64_t hash) const;
    /// The hull under way is made, or null where it could not be.
    void made(std::uint64_t hash, std::shared_ptr<const SeaHull> hull);

    std::shared_ptr<TableCache> m_cache;
    std::mutex m_lock;
    std::map<std::uint64_t, std::weak_ptr<const SeaHull>> m_known;
    std::map<std::uint64_t, Made> m_making;
    std::deque<std::shared_ptr<const SeaHull>> m_last;
};

}  // namespace sagara::core
