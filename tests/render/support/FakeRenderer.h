#pragma once

#include <atomic>
#include <vector>

#include "render/wall/FrameRenderer.h"

namespace sagara::test {

/// Draws nothing, slowly. Its picture holds a hash of all it was given to draw, so that two channels that
/// show the same frame of the same world have equal pictures.
class FakeRenderer final : public wall::FrameRenderer {
public:
    explicit FakeRenderer(int draw_ms) : m_draw_ms(draw_ms) {}

    std::optional<std::string> setup(std::shared_ptr<const core::World> world,
                                     const link::ChannelView& view) override;
    void render(const link::Frame& frame) override;
    void show() override { m_shown.push_back(m_drawn); }
    std::optional<link::Picture> picture() override;
    bool idle() override { return !m_closed; }

    std::atomic<int> m_added_ms{0};
    std::atomic<bool> m_closed{false};
    std::vector<std::uint64_t> m_shown;  ///< frame numbers
    int m_setups = 0;

private:
    int m_draw_ms;
    std::shared_ptr<const core::World> m_world;
    link::ChannelView m_view;
    std::uint64_t m_drawn = 0;
    std::uint64_t m_hash = 0;
};

/// Of everything that must be equal between channels.
std::uint64_t hashOfFrame(const core::World& world, const link::Frame& frame);

}  // namespace sagara::test
