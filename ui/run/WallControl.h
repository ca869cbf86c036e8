#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sagara::ui {

/// How the channels of a wall on this PC stand on its monitors.
enum class WallPlacement { Windows, FullScreen, Hidden };

/// The wall as windows of the station see it. Nothing here waits.
class WallControl {
public:
    virtual ~WallControl() = default;

    struct Layout {
        std::string id;
        std::string name;
        std::size_t channels = 0;
    };
    struct Channel {
        std::string name;
        std::string state;      ///< "in step", "away", ...
        double rate_Hz = 0.0;   ///< frames shown, over the last seconds
        double drawn_ms = 0.0;  ///< from a frame being sent to its being drawn
        double skew_ms = 0.0;   ///< behind the first channel to show the frame
        int timesLost = 0;
        std::string reason;  ///< why it was last lost
        bool local = true;   ///< its program runs on this PC and can be started again from here
    };
    struct Status {
        bool running = false;
        std::string layout;   ///< id
        std::string trouble;  ///< why it does not run
        std::uint16_t port = 0;
        std::vector<Channel> channels;
        std::vector<std::string> notes;  ///< the last things worth a line, newest last
    };

    virtual std::vector<Layout> layouts() const = 0;
    virtual void start(const std::string& layout, WallPlacement placement) = 0;
    virtual void stop() = 0;
    virtual void restart(const std::string& channel) = 0;
    virtual Status status() const = 0;
};

}  // namespace sagara::ui
