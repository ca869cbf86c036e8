#include "render/wall/Layout.h"

#include <cmath>
#include <set>

#include "core/base/Config.h"
#include "core/base/Units.h"

namespace sagara::wall {
namespace {

using core::config::Node;
using core::config::Reader;
using link::Frustum;

double tangent(double angle_deg) { return std::tan(angle_deg * core::kDegree_rad); }

/// Symmetrical about the axis, with square pixels and the horizon at that part of the height.
Frustum frustumOf(double width, double aspect, double horizonAt) {
    const double height = width / aspect;
    return {0.5 * width, 0.5 * width, horizonAt * height, (1.0 - horizonAt) * height};
}

Frustum readEdges(Node node, double aspect) {
    Reader in(node);
    const core::config::Range range{-80.0, 80.0, "deg"};
    const Frustum f{tangent(in.number("left", range)), tangent(in.number("right", range)),
                    tangent(in.number("down", range)), tangent(in.number("up", range))};
    in.rejectUnknownKeys();
    const double width = f.left + f.right, height = f.down + f.up;
    if (!in.sound()) return {};
    if (width < 0.05 || height < 0.05) {
        node.problem("leaves nothing to see", "left + right and down + up of 3 deg or more");
    } else if (std::abs(width / height / aspect - 1.0) > 0.05) {
        node.problem("gives pixels " +
                         core::config::formatNumber(std::round(100.0 * width / height / aspect) / 100.0) +
                         " times as wide as high",
                     "square ones, within 5 %");
    }
    return f;
}

Frustum readFrustum(Reader& in, double aspect) {
    if (in.has("edges_deg")) {
        if (in.has("fieldOfView_deg"))
            in.problem("fieldOfView_deg", "stands beside edges_deg", "one of them");
        (void)in.numberOr("fieldOfView_deg", 60.0, {5.0, 150.0, "deg"});
        return readEdges(in.child("edges_deg"), aspect);
    }
    const double fieldOfView_deg = in.number("fieldOfView_deg", {5.0, 150.0, "deg"});
    return frustumOf(2.0 * tangent(0.5 * fieldOfView_deg), aspect, in.numberOr("horizonAt", 0.5, {0.0, 1.0}));
}

link::EyePoint readEye(Node node) {
    Reader in(node);
    const core::config::Range range{-100.0, 100.0, "m"};
    const link::EyePoint eye{in.numberOr("forward_m", 0.0, range), in.numberOr("starboard_m", 0.0, range),
                             in.numberOr("up_m", 0.0, range)};
    in.rejectUnknownKeys();
    return eye;
}

LayoutChannel readChannel(Node node) {
    Reader in(node);
    LayoutChannel channel;
    link::ChannelView& view = channel.view;
    view.name = in.id("name");
    view.ship = static_cast<std::uint32_t>(in.integerOr("ship", 0, 0, 15));
    if (in.has("eye")) view.eye = readEye(in.child("eye"));
    view.yaw_rad = core::kDegree_rad * in.number("yaw_deg", {-180.0, 180.0, "deg"});
    const auto size_px = in.numbers("size_px", 2, {64.0, double{link::kMostPixelsAcross}, "pixels"});
    double aspect = 1.0;
    if (size_px.size() == 2) {
        view.width_px = static_cast<std::uint32_t>(size_px[0]);
        view.height_px = static_cast<std::uint32_t>(size_px[1]);
        aspect = size_px[0] / size_px[1];
    }
    view.frustum = readFrustum(in, aspect);
    channel.host = in.textOr("host", "local");
    view.output = in.has("output")
                      ? in.choice<link::Output>("output", {{"window", link::Output::Window},
                                                           {"fullscreen", link::Output::Fullscreen},
                                                           {"offscreen", link::Output::Offscreen}})
                      : link::Output::Window;
    view.screen = static_cast<std::uint32_t>(in.integerOr("screen", 0, 0, int{link::kMostScreens} - 1));
    in.rejectUnknownKeys();
    return channel;
}

}  // namespace

core::Result<Layout, core::config::Problems> loadLayout(const std::string& name, std::string_view text) {
    core::config::Document document(name, text);
    Layout layout;
    if (!document.isKind("wall", kWallDocumentVersion)) return document.finish(layout);
    Reader in(document.root());
    (void)in.text("document");
    (void)in.integer("version", 1, kWallDocumentVersion);
    layout.id = in.id("id");
    layout.name = in.text("name");
    const auto channels = in.list("channels");
    if (in.has("channels") && (channels.empty() || channels.size() > kMostChannels))
        in.problem("channels", "has " + std::to_string(channels.size()),
                   "1 to " + std::to_string(kMostChannels));
    std::set<std::string> names;
    for (const Node& node : channels) {
        layout.channels.push_back(readChannel(node));
        const std::string& channel = layout.channels.back().view.name;
        if (!channel.empty() && !names.insert(channel).second)
            node.problem("has the name \"" + channel + "\" of another", "a name of its own");
    }
    in.rejectUnknownKeys();
    return document.finish(layout);
}

Layout resized(Layout layout, std::uint32_t width_px, std::uint32_t height_px) {
    for (LayoutChannel& channel : layout.channels) {
        Frustum& f = channel.view.frustum;
        const double height = (f.left + f.right) * height_px / width_px, scale = height / (f.down + f.up);
        f.down *= scale;
        f.up *= scale;
        channel.view.width_px = width_px;
        channel.view.height_px = height_px;
    }
    return layout;
}

Layout fullScreen(Layout layout) {
    std::uint32_t screen = 0;
    for (LayoutChannel& channel : layout.channels) {
        channel.view.output = link::Output::Fullscreen;
        channel.view.screen = channel.local() ? screen++ : 0;
    }
    return layout;
}

Layout offscreen(Layout layout) {
    for (LayoutChannel& channel : layout.channels) channel.view.output = link::Output::Offscreen;
    return layout;
}

}  // namespace sagara::wall
