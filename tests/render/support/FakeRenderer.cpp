#include "tests/render/support/FakeRenderer.h"

#include <chrono>
#include <cstring>
#include <thread>

#include "core/base/Hash.h"

namespace sagara::test {

std::optional<std::string> FakeRenderer::setup(std::shared_ptr<const core::World> world,
                                               const link::ChannelView& view) {
    m_world = std::move(world);
    m_view = view;
    ++m_setups;
    return std::nullopt;
}

void FakeRenderer::render(const link::Frame& frame) {
    std::this_thread::sleep_for(std::chrono::milliseconds(m_draw_ms + m_added_ms));
    m_drawn = frame.number;
    m_hash = hashOfFrame(*m_world, frame);
}

std::optional<link::Picture> FakeRenderer::picture() {
    link::Picture picture{0, m_view.width_px, m_view.height_px, {}};
    picture.bgra.resize(std::size_t{4} * m_view.width_px * m_view.height_px);
    std::memcpy(picture.bgra.data(), &m_hash, sizeof m_hash);
    return picture;
}

std::uint64_t hashOfFrame(const core::World& world, const link::Frame& frame) {
    core::Hash64 hash;
    const auto add = [&](const auto& value) { hash.add(std::as_bytes(std::span(&value, 1))); };
    const auto addAll = [&](const auto& list) { hash.add(std::as_bytes(std::span(list))); };
    add(world.seed);
    add(frame.number);
    add(frame.time.us);
    for (const core::OwnShipView& ship : frame.snapshot.ships) add(ship.motion);
    for (const core::TargetView& target : frame.snapshot.targets) add(target.position);
    addAll(frame.snapshot.sea.active);
    addAll(frame.snapshot.sea.amplitude_m);
    for (const core::WaveComponent& wave : world.waves.components()) add(wave.phase_rad);
    return hash.value();
}

}  // namespace sagara::test
