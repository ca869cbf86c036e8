// A wall channel without a picture, for tests that kill it:
//   fake-view --draw-ms N --connect HOST:PORT --channel NAME [--offscreen]
// SIGUSR1 makes it 50 ms slower, SIGUSR2 as fast as before.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <QCoreApplication>

#include "render/wall/ChannelClient.h"
#include "render/wall/LocalChannels.h"
#include "tests/render/support/FakeRenderer.h"

namespace {
std::atomic<int>* g_added_ms = nullptr;
}

int main(int argc, char** argv) {
    const QCoreApplication qt(argc, argv);
    sagara::wall::ChannelOptions options;
    int draw_ms = 5;
    for (int i = 1; i + 1 < argc; ++i) {
        const std::string option = argv[i], value = argv[i + 1];
        if (option == "--draw-ms") draw_ms = std::atoi(value.c_str());
        if (option == "--channel") options.who.channel = value;
        if (option == "--connect") {
            options.host = value.substr(0, value.find(':'));
            options.port = static_cast<std::uint16_t>(std::atoi(value.substr(value.find(':') + 1).c_str()));
        }
    }
    if (const char* token = std::getenv(sagara::wall::kTokenVariable)) options.who.token = token;
    sagara::test::FakeRenderer renderer(draw_ms);
    g_added_ms = &renderer.m_added_ms;
    std::signal(SIGUSR1, [](int) { *g_added_ms = 50; });
    std::signal(SIGUSR2, [](int) { *g_added_ms = 0; });
    const auto end = sagara::wall::runChannel(options, renderer, [](const std::string&) {});
    if (end.failed) std::fprintf(stderr, "%s\n", end.reason.c_str());
    return end.failed ? 1 : 0;
}
