#pragma once

#include <QString>
#include <atomic>
#include <functional>

#include "core/base/Result.h"
#include "render/scene/Stage.h"
#include "ui/debrief/Branch.h"
#include "ui/debrief/Replay.h"

namespace sagara::ui {

/// How far the opening of a recording is; a person may call it off.
struct OpenProgress {
    std::atomic<int> permille{0};
    std::atomic<bool> cancelled{false};
};

/// Something a person noted about a moment of a run.
struct DebriefNote {
    core::SimTime time;
    std::string text;
};

/// What the page asks of the station.
struct DebriefPorts {
    /// Opens the recording; called once, from another thread. The error is for the person who chose it.
    std::function<core::Result<std::unique_ptr<Replay>, std::string>(OpenProgress&)> open;
    /// The 3D scene showing this world from now on; null where there is none.
    std::function<render::Stage*(const std::shared_ptr<const core::World>&)> stage;
    /// A run that goes on from this state, which is at a whole second, and is not started yet.
    std::function<core::Result<std::unique_ptr<Branch>, std::string>(const Replay&, core::State)> branch;
    /// Notes kept beside the recording. `add` says what went wrong.
    std::function<std::vector<DebriefNote>()> notes;
    std::function<std::optional<std::string>(const DebriefNote&)> addNote;
    /// Opens the result of this run, report and sign-off; empty where there is none.
    std::function<void()> openResult;
};

}  // namespace sagara::ui
