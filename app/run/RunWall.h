#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/files/ScenarioChanges.h"
#include "app/run/Store.h"

namespace sagara::run {

/// What `sagara-sim wall` was asked to do.
struct WallRunOptions {
    std::string scenario;              ///< id or file
    std::string layout = "desk-3x60";  ///< id under assets/walls, or file
    bool pilot = false;
    int level = 3;
    std::uint64_t seed = 1;
    files::ScenarioChanges changes;
    double at_s = 0.0;  ///< the wall opens after the pilot has sailed so long
    bool offscreen = false;
    bool fullScreen = false;  ///< each channel over a screen of its own
    std::optional<std::pair<std::uint32_t, std::uint32_t>> size_px;  ///< of every channel
    double rate_Hz = 60.0;                                           ///< at most
    bool fast = false;         ///< every frame 1/rate_Hz after the one before, as fast as the channels draw
    double duration_s = 10.0;  ///< of simulation, once all channels are there
    std::optional<std::filesystem::path> shots;
    double shotEvery_s = 2.0;
    std::optional<std::filesystem::path> view;  ///< the channel program, when not the one beside this
    std::vector<std::string> viewArguments;
    bool listen = false;  ///< to other PCs; the token is in SAGARA_TOKEN
    std::uint16_t port = 0;
    std::optional<double> killEvery_s;   ///< for trials: kills a local channel, one after the other
    std::optional<double> orderEvery_s;  ///< for trials: helm orders, to see how soon they show
};

/// Runs an exercise with its wall and without a station. Figures on standard output, what happens on standard
/// error. Nothing is recorded. Returns the exit code. Needs a Qt application.
int runWall(Store& store, const WallRunOptions& options);

}  // namespace sagara::run
