#pragma once

#include <memory>

#include "render/wall/WallServer.h"
#include "ui/run/WallControl.h"

namespace sagara::station {

/// The wall of a running exercise: server and channel programs in a thread of their own, so that nothing the
/// windows do holds a frame up, nor the other way round.
class StationWall final : public ui::WallControl {
public:
    /// `source` is called in the thread of the wall and must work until this is destroyed.
    StationWall(std::shared_ptr<const core::World> world, wall::MomentSource source);
    ~StationWall() override;  ///< stops the wall and waits for its programs, two seconds at most

    std::vector<Layout> layouts() const override;
    void start(const std::string& layout, ui::WallPlacement placement) override;
    void stop() override;
    void restart(const std::string& channel) override;
    Status status() const override;

private:
    class Works;
    struct Shared;
    std::shared_ptr<Shared> m_shared;
    std::unique_ptr<Works> m_works;
};

}  // namespace sagara::station
