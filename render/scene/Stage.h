#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/Result.h"
#include "core/exercise/World.h"
#include "render/scene/Camera.h"
#include "render/scene/Moment.h"
#include "render/scene/Picture.h"
#include "render/scene/Preset.h"

namespace sagara::render {

struct StageOptions {
    std::filesystem::path assets;  ///< the folder assets/, for shaders
    Preset preset = Preset::Medium;
    bool headless = false;                 ///< no X server: GL through render/headless
    std::filesystem::path ownModels = {};  ///< a second folder of 3D models: those the school has attached
};

/// What the last picture of a viewport cost.
struct DrawFigures {
    std::size_t triangles = 0;
    std::size_t drawCalls = 0;
};

/// One picture of the scene: size, camera, latest image. Made by a Stage; every call may come from any
/// thread, also after the Stage has gone.
class Viewport {
public:
    virtual ~Viewport() = default;
    virtual void resize(int width, int height) = 0;  ///< from the next frame on
    virtual void setCamera(const Camera& camera) = 0;
    /// The last picture finished, or null. Windows have none unless asked for.
    virtual std::shared_ptr<const Picture> latest() const = 0;
    struct Size {
        int width = 0;
        int height = 0;
    };
    virtual Size size() const = 0;  ///< of the last picture; of a window, as people have made it
    virtual DrawFigures figures() const = 0;
    virtual bool closed() const = 0;  ///< a person has closed the window
    virtual std::string trouble()
        const = 0;  ///< why there is no picture of the present exercise; empty: none
};

struct WindowOptions {
    std::string title = "Sagara";
    int width = 1280;
    int height = 720;
    bool fullScreen = false;  ///< over the whole of its screen
    int screen = 0;           ///< monitor it opens on: 0 is the leftmost
    bool readBack = false;    ///< keep each picture in `latest` as well
    double aside = 0.0;       ///< to the right of the middle of the screen, in widths of it
};

/// The one OGRE scene of a process on its own render thread. Any number of viewports show it. Use a second
/// one only after the first has gone.
class Stage final {
public:
    /// An error tells a person what is missing.
    static core::Result<std::unique_ptr<Stage>, std::string> open(const StageOptions& options);
    ~Stage();

    /// From now on the pictures are of this exercise. Returns why that failed.
    std::optional<std::string> show(std::shared_ptr<const core::World> world);
    /// The same without waiting for the scene, which takes some tenths of a second to build; the viewports
    /// tell what went wrong.
    void showSoon(std::shared_ptr<const core::World> world);
    /// What is drawn otherwise than this exercise's documents ask, a line each: models that cannot be read.
    std::vector<std::string> remarks() const;
    std::shared_ptr<Viewport> addViewport(int width, int height);  ///< does not wait
    core::Result<std::shared_ptr<Viewport>, std::string> addWindow(const WindowOptions& options);

    /// Draws the moment in every viewport and waits until the pictures are finished; windows show them only
    /// at `present`. Returns what went wrong.
    std::optional<std::string> draw(const Moment& moment);
    void present();
    /// The same without waiting; a moment not begun gives way to a later one.
    void drawSoon(Moment moment);

private:
    class Work;
    explicit Stage(std::unique_ptr<Work> work);
    std::unique_ptr<Work> m_work;
};

}  // namespace sagara::render
