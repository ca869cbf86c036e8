#include "app/station/BridgeLink.h"

#include <QTimer>

namespace sagara::station {
namespace {

constexpr int kSound_ms = 100;

/// The first thruster at one end of the ship, or -1.
int thrusterAt(const core::Thrusters& thrusters, bool bow) {
    for (std::size_t i = 0; i < thrusters.units.size(); ++i)
        if ((thrusters.units[i].position.x_m > 0.0) == bow) return static_cast<int>(i);
    return -1;
}

}  // namespace

BridgeLink::BridgeLink(ui::BridgeInput& input, ui::SoundBoard& sound, ui::TraineeConsole& console,
                       ui::ExerciseRun& run)
    : QObject(&console), m_input(input), m_sound(sound), m_run(run) {
    const core::Vessel& vessel = run.world()->ships[0]->vessel;
    input.setShip({static_cast<int>(vessel.propulsion.units.size()), vessel.steering.limit_rad});
    input.watchKeys(&console);
    connect(&input, &ui::BridgeInput::helmWanted, &console, &ui::TraineeConsole::setHelm);
    connect(&input, &ui::BridgeInput::telegraphWanted, &console, &ui::TraineeConsole::setTelegraph);
    connect(&input, &ui::BridgeInput::pitchWanted, &console, &ui::TraineeConsole::setPitch);
    connect(&input, &ui::BridgeInput::azimuthWanted, &console, &ui::TraineeConsole::setAzimuth);
    connect(&input, &ui::BridgeInput::pitchShiftWanted, &console, &ui::TraineeConsole::shiftPitch);
    connect(&input, &ui::BridgeInput::azimuthShiftWanted, &console, &ui::TraineeConsole::shiftAzimuth);
    const int bow = thrusterAt(vessel.thrusters, true), stern = thrusterAt(vessel.thrusters, false);
    connect(&input, &ui::BridgeInput::thrusterWanted, &console,
            [&console, bow](double thrust) { console.setThruster(bow, thrust); });
    connect(&input, &ui::BridgeInput::sternThrusterWanted, &console,
            [&console, stern](double thrust) { console.setThruster(stern, thrust); });
    connect(&console, &ui::TraineeConsole::thrusterGiven, &input, [&input, bow, stern](int i, double thrust) {
        if (i == bow) input.followThruster(thrust);
        if (i == stern) input.followSternThruster(thrust);
    });
    connect(&input, &ui::BridgeInput::hornWanted, &console, &ui::TraineeConsole::soundHorn);
    connect(&input, &ui::BridgeInput::lookWanted, &console, &ui::TraineeConsole::look);
    connect(&input, &ui::BridgeInput::acknowledgeWanted, &console, &ui::TraineeConsole::acknowledgeAlarms);
    connect(&console, &ui::TraineeConsole::helmGiven, &input, &ui::BridgeInput::followHelm);
    connect(&console, &ui::TraineeConsole::telegraphGiven, &input, &ui::BridgeInput::followTelegraph);
    connect(&console, &ui::TraineeConsole::horn, this, [this](bool on) { m_heard.horn = on; });
    connect(&console, &ui::TraineeConsole::alarm, this, [this](bool on) { m_heard.alarm = on; });
    connect(&input, &ui::BridgeInput::bookmarkWanted, this, [&run] {
        run.give(0, core::NoteOrder{"Marked by the trainee", true});
    });
    auto* const beat = new QTimer(this);
    connect(beat, &QTimer::timeout, this, &BridgeLink::play);
    beat->start(kSound_ms);
}

BridgeLink::~BridgeLink() { m_input.watchKeys(nullptr); }

void BridgeLink::play() {
    if (!m_run.running()) return;
    const auto now = m_run.latest();
    m_sound.play(ui::soundSceneOf(*m_run.world(), *now, m_heard));
    m_input.nmea().report(*m_run.world(), *now);
}

}  // namespace sagara::station
