#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/station/Frame.h"
#include "ui/demo/DemoPage.h"
#include "ui/run/WallControl.h"

namespace sagara::station {

struct DemoOptions {
    std::vector<std::string> scenarios{"basic-navigation", "heavy-weather"};
    int level = 3;
    ui::DemoTiming timing;
    bool fullScreen = true;
    std::string wallLayout;  ///< id; empty: no wall
    ui::WallPlacement wallPlacement = ui::WallPlacement::FullScreen;
    std::function<std::optional<ui::StickReading>()> stick;
};

/// Opens the exhibition; the error is for the person who wanted it. PIN and chord are the settings "demo.pin"
/// and "demo.chord" (else 0000 and Ctrl+Shift+Q). With SAGARA_DEMO_LOG=FILE in the
/// environment it writes there how it fares, every SAGARA_DEMO_LOG_EVERY seconds (60).
core::Result<ui::Page*, std::string> openDemo(Frame& frame, DemoOptions options = {});

/// The same; a page that says what is wrong where it cannot be opened.
ui::Page* demoPage(Frame& frame, DemoOptions options = {});

}  // namespace sagara::station
