#pragma once

#include <memory>
#include <string>

#include "app/run/Store.h"
#include "app/station/RunRequest.h"
#include "render/scene/Stage.h"
#include "ui/theme/Page.h"

namespace sagara::station {

/// What the window gives to its pages, and what they may ask of it.
class Frame {
public:
    virtual ~Frame() = default;

    virtual run::Store& store() = 0;
    /// The one 3D scene, showing this world from now on; null where there is no OpenGL 3.3. It is the current
    /// page's: who shows another world takes it away from the page behind, which asks again when it is back.
    virtual render::Stage* stageFor(const std::shared_ptr<const core::World>& world) = 0;
    virtual ui::PaletteName colours() const = 0;

    /// Shows a page over the present one; the window owns it and deletes it when it is left.
    virtual void openPage(ui::Page* page) = 0;
    /// The same in place of the present one, which is not asked and goes when control is back in the event
    /// loop.
    virtual void replacePage(ui::Page* page) = 0;
    /// Opens the trainer's desk of a run. The error is for the person who chose.
    virtual std::optional<std::string> openRun(const RunRequest& request) = 0;
    /// Opens the debriefing of a recording.
    virtual std::optional<std::string> openDebrief(const std::filesystem::path& recording) = 0;
};

}  // namespace sagara::station
