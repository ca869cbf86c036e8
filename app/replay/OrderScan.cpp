#include "app/replay/OrderScan.h"

#include "core/exercise/Replay.h"
#include "core/exercise/Session.h"

namespace sagara::replay {
namespace {

ui::ReplayOrders::Sample ordersOf(const core::State& state) {
    ui::ReplayOrders::Sample sample;
    if (state.ships.empty()) return sample;
    sample.rudder_rad = state.ships[0].steering.order_rad;
    for (std::size_t i = 0; i < core::kMostShafts; ++i)
        sample.shafts_rps[i] = state.ships[0].shafts[i].order_rps;
    return sample;
}

}  // namespace

OrderScan::OrderScan(std::shared_ptr<const Film> film) : m_film(std::move(film)) {
    m_thread = std::thread([this] { run(); });
}

OrderScan::~OrderScan() {
    m_stop = true;
    m_thread.join();
}

void OrderScan::run() {
    auto first = core::readState(*m_film->world, m_film->recording.states.front());
    if (!first) return;
    core::Session session(m_film->world, std::move(first).value(), m_film->recording.commands, nullptr);
    auto found = std::make_shared<ui::ReplayOrders>();
    for (const core::TrackSample& sample : m_film->track) {
        while (session.state().tick < sample.tick && !session.state().stopped) (void)session.step();
        if (m_stop) return;
        found->samples.push_back(ordersOf(session.state()));
    }
    while (session.state().tick < m_film->endTick() && !session.state().stopped) (void)session.step();
    const auto& end = m_film->recording.end;
    found->verified =
        end && end->tick == session.state().tick && end->stateHash == core::stateHash(session.state());
    std::atomic_store(&m_result, std::shared_ptr<const ui::ReplayOrders>(std::move(found)));
}

}  // namespace sagara::replay
