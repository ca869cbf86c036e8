#include "app/station/StationRun.h"

#include "app/files/BuildScenario.h"
#include "db/PersonRepository.h"

namespace sagara::station {

core::Result<std::unique_ptr<StationRun>, std::string> StationRun::open(run::Store& store,
                                                                        const RunRequest& request) {
    auto world = files::buildScenario(store, request.scenario, request.seed);
    if (!world) return world.error();
    return open(store, request, std::move(world).value());
}

core::Result<std::unique_ptr<StationRun>, std::string> StationRun::open(
    run::Store& store, const RunRequest& request, std::shared_ptr<const core::World> world) {
    std::string trainee;
    if (!request.trainee.empty()) {
        const auto name = db::personName(request.trainee);
        if (!name) return std::string(db::toText(name.error()));
        trainee = name.value();
    }
    core::RecordingHeader header = run::newHeader(*world, request.level, request.type, trainee);
    if (request.pilot) header.planned.push_back({0, 0, core::PilotOrder{true}});
    auto leg = RunLeg::begin(store, std::move(world), std::move(header));
    if (!leg) return leg.error();
    return std::unique_ptr<StationRun>(new StationRun(store, std::move(leg).value()));
}

core::Result<std::unique_ptr<StationRun>, std::string> StationRun::takeUp(
    run::Store& store, const std::filesystem::path& recording) {
    auto leg = RunLeg::takeUp(store, recording);
    if (!leg) return leg.error();
    return std::unique_ptr<StationRun>(new StationRun(store, std::move(leg).value()));
}

StationRun::~StationRun() = default;

ui::ExerciseRun::Picture StationRun::toDraw() {
    wall::Moment moment = live().toDraw(m_clock);
    return {moment.time, std::move(moment.snapshot)};
}

wall::Moment StationRun::momentForWall(wall::FrameClock& clock) const {
    const std::lock_guard lock(m_mutex);
    return live().toDraw(clock);
}

core::Result<StationRun::WayBack, std::string> StationRun::wayBack(std::int64_t second) {
    if (!mayGoBack()) return std::string("an assessment is graded as it was sailed: it cannot go back");
    freeze();
    return WayBack([world = world(), recording = recording(), tick = second * core::kTicksPerSecond] {
        return run::takeUpAt(world, recording, tick);
    });
}

std::optional<std::string> StationRun::goBack(run::SetBack there) {
    freeze();
    auto again = RunLeg::sailAgain(m_store, std::move(there));
    if (!again) return again.error();
    const double rate = live().rate();
    std::unique_ptr<RunLeg> left = std::move(again).value();
    left->live().setRate(rate);
    {
        const std::lock_guard lock(m_mutex);
        m_leg.swap(left);
    }
    left->end();
    return std::nullopt;
}

}  // namespace sagara::station
