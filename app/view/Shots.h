#pragma once

#include <filesystem>

#include "app/view/ScenarioWorld.h"
#include "render/scene/Stage.h"

namespace sagara::view {

struct ShotOptions {
    double at_s = 0.0;
    int width = 1280;
    int height = 720;
    std::filesystem::path folder;
    std::string only;  ///< name of one shot; empty: all
};

/// Pictures of one moment of an exercise from every camera. Returns a program's exit status.
int takeShots(const ScenarioRequest& request, const render::StageOptions& stage, const ShotOptions& options);

}  // namespace sagara::view
