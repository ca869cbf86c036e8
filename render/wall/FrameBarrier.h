#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sagara::wall {

/// How long the wall waits. Times in microseconds of the station's steady clock.
struct BarrierRules {
    std::int64_t deadline_us = 250'000;    ///< for a channel in step to draw a frame
    std::int64_t grace_us = 1'000'000;     ///< after a missed deadline, before it is taken for frozen
    std::int64_t joining_us = 5'000'000;   ///< for a joining channel to draw one: shaders are compiled then
    std::int64_t loading_us = 15'000'000;  ///< to build the world
};

enum class ChannelState : std::uint8_t {
    Away,     ///< not connected
    Loading,  ///< builds the world
    Joining,  ///< draws, and nobody waits for it until it has drawn a frame within the deadline
    InStep,   ///< the wall waits for it
    Late      ///< missed the deadline; what it still answers decides
};
const char* channelStateName(ChannelState state);

/// One channel as the station shows it to people.
struct ChannelStatus {
    std::string name;
    bool waitedFor = true;  ///< false: an observer, never in step
    ChannelState state = ChannelState::Away;
    std::uint64_t frame = 0;      ///< last shown
    std::int64_t shownAt_us = 0;  ///< by the station's clock
    std::int64_t skew_us = 0;     ///< behind the first channel to show that frame
    std::int64_t took_us = 0;     ///< from the frame being sent to its being drawn, last time
    std::uint64_t framesShown = 0;
    std::uint64_t framesMissed = 0;  ///< shown by others since it was first in step
    /// Told to show and not heard of again before the next frame was complete: by rights only when it is
    /// lost.
    std::uint64_t framesUntold = 0;
    int timesLost = 0;
    std::string reason;  ///< why it was last lost; empty when never
};

/// What the barrier wants done or made known, in this order.
struct BarrierEvent {
    enum class Kind : std::uint8_t {
        Show,        ///< tell `channel` to show `frame`
        InStep,      ///< `channel` is taken (back) in
        Lost,        ///< `channel` fell out of step: `reason`
        Disconnect,  ///< close its connection, restart it if it is ours: `reason`
        FrameOver    ///< all shows of `frame` are known, or the next is due; `spread_us` first to last
    };
    Kind kind = Kind::Show;
    std::size_t channel = 0;
    std::uint64_t frame = 0;
    std::int64_t spread_us = 0;
    std::string reason;
};

/// The rule of design.md, section 5: a frame is shown by all channels in step or by none; one that misses its
/// deadline falls out and comes back on probation, and the others go on. No sockets and no clock in here:
/// time comes in, events go out.
class FrameBarrier {
public:
    struct Slot {
        std::string name;
        bool waitedFor = true;
    };
    FrameBarrier(const std::vector<Slot>& slots, const BarrierRules& rules);
    std::size_t addSlot(const Slot& slot);

    void connected(std::size_t channel, std::int64_t now_us);
    void ready(std::size_t channel, std::int64_t now_us);
    void rendered(std::size_t channel, std::uint64_t frame, std::int64_t now_us);
    /// `at_us`: by the station's clock.
    void shown(std::size_t channel, std::uint64_t frame, std::int64_t at_us);
    void gone(std::size_t channel, const std::string& reason);
    /// What time alone decides. Call it at nextDecision_us, after all messages that came until then.
    void pass(std::int64_t now_us);
    std::int64_t nextDecision_us() const;

    /// Whether the next frame may be sent: the one before is shown.
    bool mayBegin() const { return !m_underWay; }
    struct Begun {
        std::uint64_t frame = 0;
        std::vector<std::size_t> recipients;
    };
    Begun begin(std::int64_t now_us);

    std::vector<BarrierEvent> take();

    std::size_t count() const { return m_channels.size(); }
    const ChannelStatus& status(std::size_t channel) const { return m_channels[channel].status; }
    std::size_t inStep() const;
    std::uint64_t frame() const { return m_frame; }  ///< last begun

private:
    struct Channel {
        ChannelStatus status;
        bool everInStep = false;  ///< frames it is missing from count from now on
        bool member = false;      ///< of the frame under way, or of the last
        bool shows = false;       ///< the last frame that was complete
        bool answered = false;    ///< a member has drawn it
        std::uint64_t asked = 0;  ///< frame it was last sent; 0: none is open
        std::int64_t askedAt_us = 0;
        std::int64_t since_us = 0;      ///< of the state
        std::int64_t heldUntil_us = 0;  ///< not let in before
        int quickMisses = 0;
        std::int64_t shownAt_us = 0;  ///< of the last frame; 0: not told yet
    };
    void enter(Channel& channel, ChannelState state, std::int64_t now_us);
    void fallOut(std::size_t index, ChannelState to, const std::string& reason, std::int64_t now_us);
    void disconnect(std::size_t index, const std::string& reason, std::int64_t now_us);
    void showIfComplete();
    void settleShows();
    std::int64_t limit_us(const Channel& channel) const;

    BarrierRules m_rules;
    std::vector<Channel> m_channels;
    std::vector<BarrierEvent> m_events;
    std::uint64_t m_frame = 0;       ///< last begun
    std::uint64_t m_shownFrame = 0;  ///< last complete: its shows are told of while the next is drawn
    bool m_underWay = false;
    bool m_showsOpen = false;
};

}  // namespace sagara::wall
