#pragma once

#include <filesystem>

#include "app/station/Frame.h"
#include "core/base/Result.h"
#include "ui/debrief/DebriefPorts.h"
#include "ui/theme/Page.h"

namespace sagara::station {

/// The debriefing of a recording: it opens aside and says what is wrong with it on the page. Fails at once
/// for a file that cannot be read or is no recording. `openResult`, where given, opens the run's result.
/// `from_s`: what is shown first.
core::Result<ui::Page*, std::string> debriefPage(Frame& frame, const std::filesystem::path& recording,
                                                 std::function<void()> openResult = nullptr,
                                                 double from_s = 0.0);

/// The recordings of this installation, newest first. They are opened with Frame::openDebrief.
ui::Page* recordingsPage(Frame& frame);

/// What the page of a recording asks, without a window: for tests. `store` and the stage outlive it.
ui::DebriefPorts debriefPorts(run::Store& store, const std::filesystem::path& recording);

}  // namespace sagara::station
