#include "core/seakeeping/SeaHulls.h"

namespace sagara::core {
namespace {

constexpr std::size_t kLast = 4;

}  // namespace

std::shared_ptr<const SeaHull> SeaHulls::held(std::uint64_t hash) const {
    const auto known = m_known.find(hash);
    return known == m_known.end() ? nullptr : known->second.lock();
}

void SeaHulls::keep(std::uint64_t hash, const std::shared_ptr<const SeaHull>& hull) {
    const std::scoped_lock lock(m_lock);
    m_known[hash] = hull;
    m_making.erase(hash);
    m_last.push_back(hull);
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
    auto made =
        std::make_shared<const SeaHull>(form, tablesFor(form, options, m_cache), options.transomTerms);
    keep(hash, made);
    promise.set_value(made);
    return made;
}

}  // namespace sagara::core
