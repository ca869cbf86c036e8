#include "render/link/TalkCodec.h"

#include <cstring>

#include "render/link/FrameCodec.h"
#include "render/link/schema/link.pb.h"

namespace sagara::link {
namespace {

constexpr std::size_t kLongestName_bytes = 200, kLongestReason_bytes = 2000;

void assignBytes(std::string& to, std::span<const std::byte> from) {
    to.assign(reinterpret_cast<const char*>(from.data()), from.size());
}
template <std::size_t N>
std::array<std::byte, N> fixedBytes(const std::string& from, Check& check, const char* what) {
    std::array<std::byte, N> to{};
    if (from.size() != N)
        return check.refuse(std::string(what) + " has " + std::to_string(from.size()) + " bytes"), to;
    std::memcpy(to.data(), from.data(), N);
    return to;
}

void write(const core::NamedText& m, wire::Document& w) {
    w.set_name(m.name);
    w.set_text(m.text);
}
core::NamedText read(const wire::Document& w, Check& check) {
    return {check.text(w.name(), kLongestName_bytes, "document name"), w.text()};
}

/// Clocks stay where their differences cannot overflow.
std::int64_t clock(std::int64_t value_us, Check& check) {
    constexpr std::int64_t kLimit_us = std::int64_t{1} << 60;
    if (value_us > -kLimit_us && value_us < kLimit_us) return value_us;
    check.refuse("a clock shows " + std::to_string(value_us) + " us");
    return 0;
}

}  // namespace

Kind write(const Greeting& m, wire::Greeting& w) {
    for (const std::uint32_t version : m.speaks) w.add_speaks(version);
    assignBytes(*w.mutable_nonce(), m.nonce);
    w.set_build(m.build);
    return Kind::Greeting;
}
Greeting read(const wire::Greeting& w, Check& check) {
    Greeting m;
    for (int i = 0; i < check.count(w.speaks_size(), 16, "versions"); ++i) m.speaks.push_back(w.speaks(i));
    m.nonce = fixedBytes<16>(w.nonce(), check, "nonce");
    m.build = check.text(w.build(), kLongestName_bytes, "build");
    return m;
}

Kind write(const Hello& m, wire::Hello& w) {
    w.set_role(static_cast<std::uint32_t>(m.role));
    w.set_channel(m.channel);
    assignBytes(*w.mutable_proof(), m.proof);
    w.set_build(m.build);
    w.set_process(m.process);
    return Kind::Hello;
}
Hello read(const wire::Hello& w, Check& check) {
    return {check.choice(w.role(), Role::Observer, "role"),
            check.text(w.channel(), kLongestName_bytes, "channel"), fixedBytes<32>(w.proof(), check, "proof"),
            check.text(w.build(), kLongestName_bytes, "build"), w.process()};
}

Kind write(const Refused& m, wire::Refused& w) {
    w.set_reason(m.reason.substr(0, kLongestReason_bytes));
    for (const std::uint32_t version : m.speaks) w.add_speaks(version);
    return Kind::Refused;
}
Refused read(const wire::Refused& w, Check& check) {
    Refused m;
    m.reason = check.text(w.reason(), kLongestReason_bytes, "reason");
    for (int i = 0; i < check.count(w.speaks_size(), 16, "versions"); ++i) m.speaks.push_back(w.speaks(i));
    return m;
}

Kind write(const Welcome& m, wire::Welcome& w) {
    wire::View& v = *w.mutable_view();
    v.set_name(m.view.name);
    v.set_ship(m.view.ship);
    v.mutable_eye()->set_forward_m(m.view.eye.forward_m);
    v.mutable_eye()->set_starboard_m(m.view.eye.starboard_m);
    v.mutable_eye()->set_up_m(m.view.eye.up_m);
    v.set_yaw_rad(m.view.yaw_rad);
    v.mutable_frustum()->set_left(m.view.frustum.left);
    v.mutable_frustum()->set_right(m.view.frustum.right);
    v.mutable_frustum()->set_down(m.view.frustum.down);
    v.mutable_frustum()->set_up(m.view.frustum.up);
    v.set_width_px(m.view.width_px);
    v.set_height_px(m.view.height_px);
    v.set_output(static_cast<std::uint32_t>(m.view.output));
    v.set_screen(m.view.screen);
    return Kind::Welcome;
}
Welcome read(const wire::Welcome& w, Check& check) {
    const wire::View& v = w.view();
    ChannelView view;
    view.name = check.text(v.name(), kLongestName_bytes, "name");
    view.ship = check.whole(v.ship(), 0, kMostShips - 1, "ship");
    view.eye = {check.number(v.eye().forward_m(), "eye.forward_m", 1000.0),
                check.number(v.eye().starboard_m(), "eye.starboard_m", 1000.0),
                check.number(v.eye().up_m(), "eye.up_m", 1000.0)};
    view.yaw_rad = check.number(v.yaw_rad(), "yaw_rad", 10.0);
    view.frustum = {check.number(v.frustum().left(), "frustum.left", 20.0),
                    check.number(v.frustum().right(), "frustum.right", 20.0),
                    check.number(v.frustum().down(), "frustum.down", 20.0),
                    check.number(v.frustum().up(), "frustum.up", 20.0)};
    if (view.frustum.left + view.frustum.right < 0.01 || view.frustum.down + view.frustum.up < 0.01)
        check.refuse("the frustum is empty");
    view.width_px = check.whole(v.width_px(), 16, kMostPixelsAcross, "width_px");
    view.height_px = check.whole(v.height_px(), 16, kMostPixelsAcross, "height_px");
    view.output = check.choice(v.output(), Output::Offscreen, "output");
    view.screen = check.whole(v.screen(), 0, kMostScreens - 1, "screen");
    return {view};
}

Kind write(const Setup& m, wire::Setup& w) {
    write(m.documents.scenario, *w.mutable_scenario());
    write(m.documents.area, *w.mutable_area());
    for (const core::NamedText& vessel : m.documents.vessels) write(vessel, *w.add_vessels());
    w.set_seed(m.seed);
    return Kind::Setup;
}
Setup read(const wire::Setup& w, Check& check) {
    Setup m;
    m.documents.scenario = read(w.scenario(), check);
    m.documents.area = read(w.area(), check);
    for (int i = 0; i < check.count(w.vessels_size(), kMostShips, "vessels"); ++i)
        m.documents.vessels.push_back(read(w.vessels(i), check));
    m.seed = w.seed();
    return m;
}

Kind write(const Ready&, wire::Ready&) { return Kind::Ready; }
Ready read(const wire::Ready&, Check&) { return {}; }

Kind write(const Rendered& m, wire::Rendered& w) {
    w.set_frame(m.frame);
    w.set_took_us(m.took_us);
    return Kind::Rendered;
}
Rendered read(const wire::Rendered& w, Check&) { return {w.frame(), w.took_us()}; }

Kind write(const Show& m, wire::Show& w) {
    w.set_frame(m.frame);
    w.set_picture(m.picture);
    return Kind::Show;
}
Show read(const wire::Show& w, Check&) { return {w.frame(), w.picture()}; }

Kind write(const Shown& m, wire::Shown& w) {
    w.set_frame(m.frame);
    w.set_at_us(m.at_us);
    return Kind::Shown;
}

Shown read(const wire::Shown& w, Check& check) { return {w.frame(), clock(w.at_us(), check)}; }

Kind write(const Ping& m, wire::Ping& w) {
    w.set_id(m.id);
    w.set_sent_us(m.sent_us);
    return Kind::Ping;
}
Ping read(const wire::Ping& w, Check& check) { return {w.id(), clock(w.sent_us(), check)}; }

Kind write(const Pong& m, wire::Pong& w) {
    w.set_id(m.id);
    w.set_sent_us(m.sent_us);
    w.set_received_us(m.received_us);
    w.set_answered_us(m.answered_us);
    return Kind::Pong;
}
Pong read(const wire::Pong& w, Check& check) {
    return {w.id(), clock(w.sent_us(), check), clock(w.received_us(), check), clock(w.answered_us(), check)};
}

Kind write(const Picture& m, wire::Picture& w) {
    w.set_frame(m.frame);
    w.set_width_px(m.width_px);
    w.set_height_px(m.height_px);
    assignBytes(*w.mutable_bgra(), m.bgra);
    return Kind::Picture;
}
Picture read(const wire::Picture& w, Check& check) {
    Picture m{w.frame(),
              check.whole(w.width_px(), 1, kMostPixelsAcross, "width_px"),
              check.whole(w.height_px(), 1, kMostPixelsAcross, "height_px"),
              {}};
    if (w.bgra().size() != std::size_t{4} * m.width_px * m.height_px)
        return check.refuse("a picture of " + std::to_string(w.bgra().size()) + " bytes"), m;
    const auto* data = reinterpret_cast<const std::byte*>(w.bgra().data());
    m.bgra.assign(data, data + w.bgra().size());
    return m;
}

Kind write(const Bye& m, wire::Bye& w) {
    w.set_reason(m.reason.substr(0, kLongestReason_bytes));
    return Kind::Bye;
}
Bye read(const wire::Bye& w, Check& check) {
    return {check.text(w.reason(), kLongestReason_bytes, "reason")};
}

}  // namespace sagara::link
