#include "core/seakeeping/SeaHulls.h"

namespace sagara::core {
namespace {

constexpr std::size_t kLast = 4;

}  // namespace

std::shared_ptr<const SeaHull> SeaHulls::held(std::uint64_t hash) const {
    const auto known = m_known.find(hash);
    return known == m_known.end() ? nullptr : known->second.lock();
}

void SeaHulls::made(std::uint64_t hash, std::shared_ptr<const SeaHull> hull) {
    const std::scoped_lock lock(m_lock);
    m_making.erase(hash);
    if (!hull) return;
    m_known[hash] = hull;
    m_last.push_back(std::move(hull));
    if (m_last.size() > kLast) m_last.pop_front();
}

std::shared_ptr<const SeaHull> SeaHulls::of(const Hull& hull) {
    const HullForm form = hullFormOf(hull);
    const TableOptions options;
    const std::uint64_t hash = tablesHash(form, options);
    std::promise<std::shared_ptr<const SeaHull>> promise;
    Made other;
    {
        const std::scoped_lock lock(m_lock);
        if (auto known = held(hash)) return known;
        if (const auto making = m_making.find(hash); making != m_making.end()) other = making->second;
        if (!other.valid()) m_making[hash] = promise.get_future().share();
    }
    if (other.valid()) return other.get();
    try {
        auto ready = std::make_shared<const SeaHull>(form, tablesFor(form, options, m_cache.get()),
                                                     options.transomTerms);
        made(hash, ready);
        promise.set_value(ready);
        return ready;
    } catch (...) {
        made(hash, nullptr);
        promise.set_exception(std::current_exception());
        throw;
    }
}

}  // namespace sagara::core
