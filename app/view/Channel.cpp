#include "app/view/Channel.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace sagara::view {
namespace {

void tell(const std::string& text) { std::fprintf(stderr, "sagara-view: %s\n", text.c_str()); }

/// In a window of other proportions than the layout's the width stays and pixels stay square.
link::Frustum fitted(const link::ChannelView& view, render::Viewport::Size size) {
    link::Frustum f = view.frustum;
    if (size.width <= 0 || size.height <= 0) return f;
    const double scale =
        static_cast<double>(view.width_px) * size.height / (static_cast<double>(view.height_px) * size.width);
    f.down *= scale;
    f.up *= scale;
    return f;
}

render::Camera cameraOf(const link::ChannelView& view, const core::World& world, const render::Moment& moment,
                        render::Viewport::Size size) {
    const link::Frustum f = fitted(view, size);
    const std::size_t ship = std::min<std::size_t>(view.ship, moment.ships.size() - 1);
    render::Camera camera =
        bridgeCamera(world, moment, ship, view.yaw_rad, {-f.left, f.right, -f.down, f.up});
    if (view.eye == link::EyePoint{}) return camera;
    const core::Vessel& v = world.ships[ship]->vessel;
    const render::PlaceUp eye =
        pointOnShip(moment.ships[ship], v.bridgeEye.x_m + view.eye.forward_m,
                    v.bridgeEye.y_m + view.eye.starboard_m, v.bridgeEyeHeight_m + view.eye.up_m);
    camera.position = eye.position;
    camera.up_m = eye.up_m;
    return camera;
}

/// Draws a channel with the scene: a window, or a picture that is only sent back.
class SceneRenderer final : public wall::FrameRenderer {
public:
    SceneRenderer(render::StageOptions options, const ChannelRequest& request)
        : m_options(std::move(options)), m_request(request) {}

    std::optional<std::string> setup(std::shared_ptr<const core::World> world,
                                     const link::ChannelView& view) override {
        if (world->ships.empty()) return "the exercise has no own ship to look from";
        m_world = std::move(world);
        m_view = view;
        if (!m_stage) {
            if (auto trouble = openStage()) return trouble;
        } else if (!isWindow()) {
            m_viewport->resize(width(), height());
        }
        auto trouble = m_stage->show(m_world);
        for (const std::string& remark : m_stage->remarks()) tell(remark);
        return trouble;
    }

    void render(const link::Frame& frame) override {
        render::Moment moment = render::momentOf(frame.snapshot);
        moment.time = frame.time;
        if (moment.ships.empty()) return;
        m_viewport->setCamera(cameraOf(m_view, *m_world, moment, m_viewport->size()));
        if (const auto trouble = m_stage->draw(moment)) tell(*trouble);
    }
    void show() override { m_stage->present(); }

    std::optional<link::Picture> picture() override {
        const auto latest = m_viewport->latest();
        if (!latest) return std::nullopt;
        link::Picture picture;
        picture.width_px = static_cast<std::uint32_t>(latest->width);
        picture.height_px = static_cast<std::uint32_t>(latest->height);
        picture.bgra.resize(latest->bgra.size());
        std::memcpy(picture.bgra.data(), latest->bgra.data(), latest->bgra.size());
        return picture;
    }
    bool idle() override { return !m_viewport || !m_viewport->closed(); }

private:
    bool isWindow() const { return !m_options.headless && m_view.output != link::Output::Offscreen; }
    int width() const { return m_request.width > 0 ? m_request.width : static_cast<int>(m_view.width_px); }
    int height() const {
        return m_request.height > 0 ? m_request.height : static_cast<int>(m_view.height_px);
    }

    std::optional<std::string> openStage() {
        auto stage = render::Stage::open(m_options);
        if (!stage) return stage.error();
        m_stage = std::move(stage).value();
        if (!isWindow()) {
            m_viewport = m_stage->addViewport(width(), height());
            return std::nullopt;
        }
        const bool fullScreen = m_request.fullScreen || m_view.output == link::Output::Fullscreen;
        // Beside each other, as their pictures are.
        const double across_rad = std::atan(m_view.frustum.left) + std::atan(m_view.frustum.right);
        const int screen = m_request.screen.value_or(static_cast<int>(m_view.screen));
        auto window = m_stage->addWindow({"Sagara " + m_view.name, width(), height(), fullScreen, screen,
                                          true, m_view.yaw_rad / across_rad});
        if (!window) return window.error();
        m_viewport = std::move(window).value();
        return std::nullopt;
    }

    render::StageOptions m_options;
    ChannelRequest m_request;
    link::ChannelView m_view;
    std::shared_ptr<const core::World> m_world;
    std::unique_ptr<render::Stage> m_stage;
    std::shared_ptr<render::Viewport> m_viewport;  ///< goes before the stage
};

}  // namespace

bool parseStation(const std::string& text, wall::ChannelOptions& station) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos || colon == 0) return false;
    station.host = text.substr(0, colon);
    if (station.host.front() == '[' && station.host.back() == ']')
        station.host = station.host.substr(1, station.host.size() - 2);
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + colon + 1, end, station.port);
    return error == std::errc() && stop == end && station.port != 0 && !station.host.empty();
}

int runChannel(const render::StageOptions& stage, const ChannelRequest& request) {
    SceneRenderer renderer(stage, request);
    const wall::ChannelEnd end = wall::runChannel(request.station, renderer, tell);
    if (end.failed) tell(end.reason);
    return end.failed ? 1 : 0;
}

}  // namespace sagara::view
