#pragma once

#include <string>
#include <vector>

#include "app/view/ScenarioWorld.h"
#include "render/scene/Stage.h"

namespace sagara::view {

struct BenchOptions {
    std::string scene;  ///< one of benchScenes()
    int width = 1280;
    int height = 720;
    int frames = 200;
    int channels = 1;  ///< side by side, 60 deg apart, drawn one after the other
    bool window = false;
    bool fullScreen = false;
    int screen = 0;              ///< monitor the window opens on
    std::filesystem::path dump;  ///< folder for every frame as PNG; empty: none
};

/// Names for --bench.
std::vector<std::string> benchScenes();

/// Draws a moving scene as fast as it goes and prints frames/s, percentiles, triangles, draw calls and
/// memory. Returns a program's exit status.
int bench(const ScenarioRequest& request, const render::StageOptions& stage, const BenchOptions& options);

}  // namespace sagara::view
