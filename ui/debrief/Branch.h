#pragma once

#include <string>
#include <vector>

#include "core/exercise/Track.h"
#include "ui/run/ExerciseRun.h"

namespace sagara::ui {

/// A run that leaves a recorded one at some second and is sailed anew from there. It has a recording of its
/// own.
class Branch : public ExerciseRun {
public:
    virtual core::SimTime from() const = 0;
    /// The kinematic track since then, as far as it is recorded.
    virtual std::vector<core::TrackSample> track() const = 0;
    /// Ends it and files it: what became of it. The same after that.
    virtual const std::string& finish() = 0;
    virtual bool finished() const = 0;
    virtual std::string recordingName() const = 0;
};

}  // namespace sagara::ui
