#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace sagara::wall {

/// A channel's program on this PC: started, started again when it ends by itself, and killed with the
/// station. One that ends at once is tried again more and more slowly. Belongs to a thread with a Qt event
/// loop.
class ChannelProcess {
public:
    struct Command {
        std::string program;
        std::vector<std::string> arguments;
        std::vector<std::pair<std::string, std::string>> environment;  ///< besides what the station has
    };
    /// `tell` gets messages for people: why it ended, with the last line it wrote to standard error.
    ChannelProcess(std::string name, const Command& command, std::function<void(const std::string&)> tell);
    ~ChannelProcess();  ///< kills it

    void start();
    /// Kills it if it still runs, frozen or not, and starts it again.
    void restart();
    /// It may end now; waits no longer than this, then kills it.
    void stop(int patience_ms);

    std::int64_t processId() const;  ///< 0 while it does not run
    int starts() const;

private:
    class Impl;
    std::unique_ptr<Impl> m_impl;
};

}  // namespace sagara::wall
