#pragma once

#include "render/wall/ChannelProcess.h"
#include "render/wall/Layout.h"

namespace sagara::wall {

/// Environment variable by which a channel learns the shared token; a command line could be read by others.
inline constexpr const char* kTokenVariable = "SAGARA_TOKEN";

/// The programs of all channels of a layout that run on this PC.
class LocalChannels {
public:
    struct Program {
        std::string path;                    ///< sagara-view, or a double in tests
        std::vector<std::string> arguments;  ///< besides --connect, --channel and --offscreen
    };
    LocalChannels(const Layout& layout, const Program& program, std::uint16_t port, const std::string& token,
                  const std::function<void(const std::string&)>& tell);

    void start();
    /// For channels that hang. Nothing when the channel is not on this PC.
    void restart(const std::string& channel);
    void stop(int patience_ms);

    ChannelProcess* find(const std::string& channel);

private:
    struct Entry {
        std::string name;
        std::unique_ptr<ChannelProcess> process;
    };
    std::vector<Entry> m_entries;
};

}  // namespace sagara::wall
