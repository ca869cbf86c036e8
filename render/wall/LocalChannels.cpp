#include "render/wall/LocalChannels.h"

namespace sagara::wall {

LocalChannels::LocalChannels(const Layout& layout, const Program& program, std::uint16_t port,
                             const std::string& token, const std::function<void(const std::string&)>& tell) {
    for (const LayoutChannel& channel : layout.channels) {
        if (!channel.local()) continue;
        ChannelProcess::Command command{program.path, program.arguments, {}};
        auto& arguments = command.arguments;
        arguments.insert(arguments.end(), {"--connect", "127.0.0.1:" + std::to_string(port)});
        arguments.insert(arguments.end(), {"--channel", channel.view.name});
        if (channel.view.output == link::Output::Offscreen) arguments.push_back("--offscreen");
        if (!token.empty()) command.environment.emplace_back(kTokenVariable, token);
        m_entries.push_back(
            {channel.view.name, std::make_unique<ChannelProcess>(channel.view.name, command, tell)});
    }
}

void LocalChannels::start() {
    for (Entry& entry : m_entries) entry.process->start();
}
void LocalChannels::restart(const std::string& channel) {
    if (ChannelProcess* process = find(channel)) process->restart();
}
void LocalChannels::stop(int patience_ms) {
    for (Entry& entry : m_entries) entry.process->stop(patience_ms);
}
ChannelProcess* LocalChannels::find(const std::string& channel) {
    for (Entry& entry : m_entries) {
        if (entry.name == channel) return entry.process.get();
    }
    return nullptr;
}

}  // namespace sagara::wall
