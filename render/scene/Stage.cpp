#include "render/scene/Stage.h"

#include <OgreException.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>

#include "render/headless/HeadlessGl.h"
#include "render/scene/RenderThread.h"
#include "render/scene/ogre/Scene.h"
#include "render/scene/ogre/ViewTarget.h"

namespace sagara::render {

/// Everything on the render thread. Members are touched only there, but for those that say otherwise.
class Stage::Work {
public:
    explicit Work(const StageOptions& options) : m_options(options) {}
    ~Work() {
        m_thread.run([this] {
            m_targets.clear();
            m_scene.reset();
            m_host.reset();
        });
    }

    /// Runs it there; an exception of OGRE becomes its words.
    template <typename F>
    std::optional<std::string> attempt(F&& work) {
        std::optional<std::string> trouble;
        m_thread.run([&] { trouble = tried(work); });
        return trouble;
    }

    void open() { m_host = std::make_unique<Host>(); }
    void show(std::shared_ptr<const core::World> world) {
        for (const auto& target : m_targets) target->forget();
        m_scene.reset();
        m_trouble.clear();
        m_scene = std::make_unique<Scene>(*m_host, std::move(world), m_options.assets, m_options.preset,
                                          m_options.ownModels);
    }
    std::vector<std::string> remarks() const {
        return m_scene ? m_scene->remarks() : std::vector<std::string>();
    }
    void showSoon(std::shared_ptr<const core::World> world) {
        {
            const std::lock_guard lock(m_soonMutex);
            m_soon.reset();
            ++m_worlds;  // what waits to be drawn is of the world before
        }
        m_thread.post([this, world = std::move(world)]() mutable {
            m_trouble = tried([&] { show(std::move(world)); }).value_or("");
            for (const auto& target : m_targets) target->state()->setTrouble(m_trouble);
        });
    }
    void add(std::shared_ptr<ViewportState> state) {
        state->setTrouble(m_trouble);
        m_targets.push_back(std::make_unique<ViewTarget>(*m_host, std::move(state), nullptr, true));
    }
    void addSoon(std::shared_ptr<ViewportState> state) {
        m_thread.post([this, state = std::move(state)]() mutable {
            if (const auto trouble = tried([&] { add(state); })) state->setTrouble(*trouble);
        });
    }
    void add(std::shared_ptr<ViewportState> state, const WindowOptions& o) {
        auto* window = m_host->openWindow(o);
        m_targets.push_back(std::make_unique<ViewTarget>(*m_host, std::move(state), window, o.readBack));
    }
    void draw(const Moment& moment) {
        dropUnused();
        if (!m_scene) return;
        m_scene->advance(moment);
        for (const auto& target : m_targets) target->draw(*m_scene);
    }
    void present() {
        for (const auto& target : m_targets) target->present();
    }

    void drawSoon(Moment moment) {
        std::uint64_t worlds = 0;
        {
            const std::lock_guard lock(m_soonMutex);
            const bool waiting = m_soon.has_value();
            m_soon = std::move(moment);
            worlds = m_worlds;
            if (waiting) return;
        }
        m_thread.post([this, worlds] {
            std::optional<Moment> now;
            {
                const std::lock_guard lock(m_soonMutex);
                if (worlds != m_worlds) return;
                now.swap(m_soon);
            }
            try {
                draw(*now);
                present();
            } catch (const Ogre::Exception&) {
                // The picture stays as it was; `draw` would say why.
            }
        });
    }

private:
    /// What went wrong, in words.
    template <typename F>
    static std::optional<std::string> tried(F&& work) {
        try {
            work();
        } catch (const Ogre::Exception& e) {
            return e.getDescription();
        } catch (const std::runtime_error& e) {
            return e.what();
        }
        return std::nullopt;
    }

    /// A viewport nobody holds any more is not drawn.
    void dropUnused() {
        std::erase_if(m_targets, [](const auto& target) { return target->state().use_count() == 1; });
    }

    StageOptions m_options;
    std::unique_ptr<Host> m_host;
    std::unique_ptr<Scene> m_scene;
    std::vector<std::unique_ptr<ViewTarget>> m_targets;
    std::string m_trouble;  ///< with the scene
    std::mutex m_soonMutex;
    std::optional<Moment> m_soon;  ///< under m_soonMutex
    std::uint64_t m_worlds = 0;    ///< under m_soonMutex: counts those shown soon
    RenderThread m_thread;
};

Stage::Stage(std::unique_ptr<Work> work) : m_work(std::move(work)) {}
Stage::~Stage() = default;

core::Result<std::unique_ptr<Stage>, std::string> Stage::open(const StageOptions& options) {
    constexpr const char* kHelp =
        "\nA picture needs OpenGL 3.3. With a graphics card, install its driver; without one, Mesa draws in "
        "software:\n  apt-get install libogre-1.12-dev libgl1-mesa-dri libegl-mesa0 libegl1 libgl1";
    if (options.headless) {
        if (auto trouble = useHeadlessGl()) return *trouble + kHelp;
    } else if (!displayIsSet()) {
        return std::string(
            "There is no X display (DISPLAY is not set): start it in a desktop, or without a window.");
    }
    auto work = std::make_unique<Work>(options);
    if (auto trouble = work->attempt([&] { work->open(); })) {
        const bool noDisplay = trouble->find("X display") != std::string::npos;
        if (options.headless && noDisplay) return std::string("There is no EGL display to draw on.") + kHelp;
        if (noDisplay) return *trouble + ": start it in a desktop, or without a window.";
        return "OGRE does not start: " + *trouble + kHelp;
    }
    return std::unique_ptr<Stage>(new Stage(std::move(work)));
}

std::optional<std::string> Stage::show(std::shared_ptr<const core::World> world) {
    return m_work->attempt([&] { m_work->show(std::move(world)); });
}

void Stage::showSoon(std::shared_ptr<const core::World> world) { m_work->showSoon(std::move(world)); }

std::vector<std::string> Stage::remarks() const {
    std::vector<std::string> remarks;
    (void)m_work->attempt([&] { remarks = m_work->remarks(); });
    return remarks;
}

std::shared_ptr<Viewport> Stage::addViewport(int width, int height) {
    auto state = std::make_shared<ViewportState>(width, height);
    m_work->addSoon(state);
    return state;
}

core::Result<std::shared_ptr<Viewport>, std::string> Stage::addWindow(const WindowOptions& options) {
    auto state = std::make_shared<ViewportState>(options.width, options.height);
    if (auto trouble = m_work->attempt([&] { m_work->add(state, options); })) return *trouble;
    return std::shared_ptr<Viewport>(state);
}

std::optional<std::string> Stage::draw(const Moment& moment) {
    return m_work->attempt([&] { m_work->draw(moment); });
}
void Stage::present() {
    (void)m_work->attempt([&] { m_work->present(); });
}
void Stage::drawSoon(Moment moment) { m_work->drawSoon(std::move(moment)); }

}  // namespace sagara::render
