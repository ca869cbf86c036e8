#include "render/wall/FrameBarrier.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <utility>

namespace sagara::wall {
namespace {

/// A channel lost again so soon after it came back costs the others a deadline each time; it waits a while.
constexpr std::int64_t kSteady_us = 10'000'000, kFirstHold_us = 500'000, kLongestHold_us = 3'000'000;
constexpr std::int64_t kNever_us = std::numeric_limits<std::int64_t>::max();

std::string milliseconds(std::int64_t us) { return std::to_string(us / 1000) + " ms"; }

}  // namespace

const char* channelStateName(ChannelState state) {
    constexpr std::array names{"away", "loading", "joining", "in step", "late"};
    return names[static_cast<std::size_t>(state)];
}

FrameBarrier::FrameBarrier(const std::vector<Slot>& slots, const BarrierRules& rules) : m_rules(rules) {
    for (const Slot& slot : slots) addSlot(slot);
}

std::size_t FrameBarrier::addSlot(const Slot& slot) {
    Channel channel;
    channel.status.name = slot.name;
    channel.status.waitedFor = slot.waitedFor;
    m_channels.push_back(std::move(channel));
    return m_channels.size() - 1;
}

void FrameBarrier::enter(Channel& channel, ChannelState state, std::int64_t now_us) {
    channel.status.state = state;
    channel.since_us = now_us;
}

void FrameBarrier::connected(std::size_t index, std::int64_t now_us) {
    Channel& channel = m_channels[index];
    assert(channel.status.state == ChannelState::Away);
    channel.asked = 0;
    enter(channel, ChannelState::Loading, now_us);
}

void FrameBarrier::ready(std::size_t index, std::int64_t now_us) {
    if (m_channels[index].status.state == ChannelState::Loading)
        enter(m_channels[index], ChannelState::Joining, now_us);
}

FrameBarrier::Begun FrameBarrier::begin(std::int64_t now_us) {
    assert(mayBegin());
    Begun begun{++m_frame, {}};
    for (std::size_t i = 0; i < m_channels.size(); ++i) {
        Channel& channel = m_channels[i];
        channel.member = channel.status.state == ChannelState::InStep;
        channel.everInStep = channel.everInStep || channel.member;
        const bool guest = channel.status.state == ChannelState::Joining && channel.asked == 0 &&
                           now_us >= channel.heldUntil_us;
        if (!channel.member && !guest) continue;
        channel.asked = m_frame;
        channel.askedAt_us = now_us;
        channel.answered = false;
        begun.recipients.push_back(i);
    }
    m_underWay = true;
    showIfComplete();
    return begun;
}

void FrameBarrier::rendered(std::size_t index, std::uint64_t frame, std::int64_t now_us) {
    Channel& channel = m_channels[index];
    if (frame == 0 || frame != channel.asked) return;  // not asked of this one, or answered already
    channel.asked = 0;
    channel.status.took_us = now_us - channel.askedAt_us;
    const bool inTime = channel.status.took_us <= m_rules.deadline_us;
    switch (channel.status.state) {
        case ChannelState::InStep:
            channel.answered = true;
            showIfComplete();
            break;
        case ChannelState::Joining:
            if (!channel.status.waitedFor) {
                // An observer shows what it has drawn whenever that is.
                ++channel.status.framesShown;
                channel.status.frame = frame;
                m_events.push_back({BarrierEvent::Kind::Show, index, frame, 0, {}});
                break;
            }
            if (!inTime) break;
            enter(channel, ChannelState::InStep, now_us);
            m_events.push_back({BarrierEvent::Kind::InStep, index, frame, 0, {}});
            break;
        case ChannelState::Late:
            enter(channel, ChannelState::Joining, now_us);
            break;
        case ChannelState::Away:
        case ChannelState::Loading:
            break;
    }
}

void FrameBarrier::showIfComplete() {
    if (!m_underWay) return;
    for (const Channel& channel : m_channels) {
        if (channel.member && !channel.answered) return;
    }
    m_underWay = false;
    settleShows();  // who has not told of the frame before by now is not waited for
    m_shownFrame = m_frame;
    for (std::size_t i = 0; i < m_channels.size(); ++i) {
        Channel& channel = m_channels[i];
        channel.shownAt_us = 0;
        channel.shows = channel.member;
        if (channel.shows) {
            m_showsOpen = true;
            ++channel.status.framesShown;
            channel.status.frame = m_frame;
            m_events.push_back({BarrierEvent::Kind::Show, i, m_frame, 0, {}});
        } else if (channel.everInStep) {
            ++channel.status.framesMissed;
        }
    }
    // A frame that nobody was there to see was missed by nobody.
    if (!m_showsOpen) {
        for (Channel& channel : m_channels) {
            if (channel.everInStep) --channel.status.framesMissed;
        }
    }
}

void FrameBarrier::shown(std::size_t index, std::uint64_t frame, std::int64_t at_us) {
    Channel& channel = m_channels[index];
    if (!m_showsOpen || !channel.shows || frame != m_shownFrame || channel.shownAt_us != 0) return;
    channel.shownAt_us = at_us;
    channel.status.shownAt_us = at_us;
    const bool all = std::all_of(m_channels.begin(), m_channels.end(),
                                 [](const Channel& c) { return !c.shows || c.shownAt_us != 0; });
    if (all) settleShows();
}

void FrameBarrier::settleShows() {
    if (!m_showsOpen) return;
    m_showsOpen = false;
    std::int64_t first_us = kNever_us, last_us = 0;
    for (const Channel& channel : m_channels) {
        if (!channel.shows || channel.shownAt_us == 0) continue;
        first_us = std::min(first_us, channel.shownAt_us);
        last_us = std::max(last_us, channel.shownAt_us);
    }
    for (Channel& channel : m_channels) {
        if (!channel.shows) continue;
        if (channel.shownAt_us == 0)
            ++channel.status.framesUntold;
        else
            channel.status.skew_us = channel.shownAt_us - first_us;
    }
    const std::int64_t spread_us = first_us == kNever_us ? 0 : last_us - first_us;
    m_events.push_back({BarrierEvent::Kind::FrameOver, 0, m_shownFrame, spread_us, {}});
}

void FrameBarrier::fallOut(std::size_t index, ChannelState to, const std::string& reason,
                           std::int64_t now_us) {
    Channel& channel = m_channels[index];
    const bool wasInStep = channel.status.state == ChannelState::InStep;
    const bool soon = wasInStep && to == ChannelState::Late && now_us - channel.since_us < kSteady_us;
    enter(channel, to, now_us);
    if (!wasInStep) return;
    channel.quickMisses = soon ? std::min(channel.quickMisses + 1, 8) : 0;
    channel.heldUntil_us =
        soon ? now_us + std::min(kLongestHold_us, kFirstHold_us << (channel.quickMisses - 1)) : 0;
    channel.member = channel.member && !m_underWay;  // of a frame already shown it stays a member
    ++channel.status.timesLost;
    channel.status.reason = reason;
    m_events.push_back({BarrierEvent::Kind::Lost, index, m_frame, 0, reason});
    showIfComplete();
}

void FrameBarrier::gone(std::size_t index, const std::string& reason) {
    if (m_channels[index].status.state == ChannelState::Away) return;
    fallOut(index, ChannelState::Away, reason, m_channels[index].since_us);
}

void FrameBarrier::disconnect(std::size_t index, const std::string& reason, std::int64_t now_us) {
    m_events.push_back({BarrierEvent::Kind::Disconnect, index, m_frame, 0, reason});
    enter(m_channels[index], ChannelState::Away, now_us);
}

std::int64_t FrameBarrier::limit_us(const Channel& channel) const {
    switch (channel.status.state) {
        case ChannelState::Away:
            return kNever_us;
        case ChannelState::Loading:
            return channel.since_us + m_rules.loading_us;
        case ChannelState::Joining:
            return channel.asked == 0 ? kNever_us : channel.askedAt_us + m_rules.joining_us;
        case ChannelState::InStep:
            return channel.asked == 0 ? kNever_us : channel.askedAt_us + m_rules.deadline_us;
        case ChannelState::Late:
            return channel.since_us + m_rules.grace_us;
    }
    return kNever_us;
}

std::int64_t FrameBarrier::nextDecision_us() const {
    std::int64_t next_us = kNever_us;
    for (const Channel& channel : m_channels) next_us = std::min(next_us, limit_us(channel));
    return next_us;
}

void FrameBarrier::pass(std::int64_t now_us) {
    for (std::size_t i = 0; i < m_channels.size(); ++i) {
        const Channel& channel = m_channels[i];
        if (now_us < limit_us(channel)) continue;
        switch (channel.status.state) {
            case ChannelState::InStep:
                fallOut(i, ChannelState::Late, "drew no picture within " + milliseconds(m_rules.deadline_us),
                        now_us);
                break;
            case ChannelState::Late:
                disconnect(i, "did not answer for " + milliseconds(m_rules.deadline_us + m_rules.grace_us),
                           now_us);
                break;
            case ChannelState::Joining:
                disconnect(i, "drew no picture within " + milliseconds(m_rules.joining_us), now_us);
                break;
            case ChannelState::Loading:
                disconnect(i, "was not ready within " + milliseconds(m_rules.loading_us), now_us);
                break;
            case ChannelState::Away:
                break;
        }
    }
}

std::size_t FrameBarrier::inStep() const {
    return static_cast<std::size_t>(std::count_if(m_channels.begin(), m_channels.end(), [](const Channel& c) {
        return c.status.state == ChannelState::InStep;
    }));
}

std::vector<BarrierEvent> FrameBarrier::take() { return std::exchange(m_events, {}); }

}  // namespace sagara::wall
