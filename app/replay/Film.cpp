#include "app/replay/Film.h"

#include <fmt/format.h>

#include "app/files/Files.h"
#include "core/exercise/Replay.h"

namespace sagara::replay {
namespace {

std::string clockOf(std::int64_t tick) {
    const std::int64_t s = tick / core::kTicksPerSecond;
    return fmt::format("{:02}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

std::string remarkOn(const Film& film) {
    std::string text;
    if (!film.recording.damage.empty())
        text = fmt::format("This recording is not whole ({}). It is shown up to {}, as far as it is.",
                           film.recording.damage, clockOf(film.endTick()));
    if (!film.exact) {
        if (!text.empty()) text += " ";
        text +=
            "It was made by another build of Sagara: its recorded track is shown, five samples a second, and "
            "nothing can be sailed from it.";
    }
    return text;
}

}  // namespace

core::Result<std::shared_ptr<const Film>, std::string> openFilm(const std::filesystem::path& file,
                                                                const KeepOn& keepOn,
                                                                std::shared_ptr<core::SeaHulls> hulls) {
    const std::string calledOff;
    auto film = std::make_shared<Film>();
    film->file = file;
    {
        const auto bytes = files::readBinaryFile(file);
        if (!bytes) return bytes.error().message;
        if (!keepOn(0.1)) return calledOff;
        auto recording = core::readRecording(*bytes);
        if (!recording) return file.filename().string() + ": " + recording.error();
        film->recording = std::move(recording).value();
    }
    if (!keepOn(0.3)) return calledOff;
    auto world = core::worldOf(film->recording, std::move(hulls));
    if (!world) return file.filename().string() + ": its exercise cannot be built\n" + world.error().text();
    film->world = std::move(world).value();
    film->exact = film->recording.sameBuild();
    if (!keepOn(0.5)) return calledOff;
    film->track = film->recording.track(film->world->ships.size(), film->world->targets.size());
    if (!keepOn(0.8)) return calledOff;
    film->remark = remarkOn(*film);
    return std::shared_ptr<const Film>(std::move(film));
}

}  // namespace sagara::replay
