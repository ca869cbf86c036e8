#include "tests/support/replay/SampleRecording.h"

#include <cmath>
#include <fstream>
#include <stdexcept>

#include "core/base/Units.h"
#include "core/exercise/BuildId.h"
#include "core/exercise/OrderDocument.h"
#include "core/exercise/Session.h"
#include "tests/support/Assets.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::test {

void recordLesson(const std::filesystem::path& file, std::vector<core::Command> planned, double until_s,
                  const std::function<void(const core::State&)>& after) {
    const auto world = lessonWorld();
    std::ofstream out(file, std::ios::binary);
    core::RecordingWriter writer([&out](std::span<const std::byte> bytes) {
        for (const std::byte b : bytes) out.put(static_cast<char>(b));
    });
    core::RecordingHeader header;
    header.buildId = core::coreBuildId();
    header.seed = world->seed;
    header.level = 3;
    header.runType = "assess";
    header.trainee = "A. Perera";
    header.startedUnix_s = 1'800'000'000;
    header.documents = world->documents;
    core::State state = core::startState(*world, header.level);
    writer.begin(header, *world, state);
    if (after) after(state);
    core::Session session(world, std::move(state), std::move(planned), &writer);
    const auto until = static_cast<std::int64_t>(std::llround(until_s / core::kTick_s));
    while (!session.over() && session.state().tick < until) {
        (void)session.step();
        if (after) after(session.state());
    }
    writer.end(session.state());
}

std::vector<core::Command> livelyCommands() {
    core::WeatherOrder weather;
    weather.windSpeed_mps = 12.0;
    weather.rain = 0.6;
    weather.ramp_s = 20.0;
    const auto at = [](double s) { return static_cast<std::int64_t>(s * core::kTicksPerSecond); };
    return {{0, 0, core::PilotOrder{true}},
            {at(30), 0, weather},
            {at(40), 0, core::NoteOrder{"Late to single up", true}},
            {at(70), 0, core::PilotOrder{false}},
            {at(70) + 5, 0, core::HelmOrder{10.0 * core::kDegree_rad}}};
}

void recordBadRun(const std::filesystem::path& file) {
    const auto world = lessonWorld();
    const auto commands = core::loadCommands("bad-run", readAsset("commands/basic-navigation-bad-run.json"),
                                             core::orderNames(*world));
    if (!commands) throw std::runtime_error(commands.error().text());
    recordLesson(file, *commands, 1500.0);
}

}  // namespace sagara::test
