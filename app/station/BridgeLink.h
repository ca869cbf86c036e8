#pragma once

#include <QObject>

#include "ui/input/BridgeInput.h"
#include "ui/run/ExerciseRun.h"
#include "ui/sound/SoundBoard.h"
#include "ui/trainee/TraineeConsole.h"

namespace sagara::station {

/// Joystick, keys, NMEA and sound for one console. The console owns it.
class BridgeLink final : public QObject {
    Q_OBJECT

public:
    BridgeLink(ui::BridgeInput& input, ui::SoundBoard& sound, ui::TraineeConsole& console,
               ui::ExerciseRun& run);
    ~BridgeLink() override;

private:
    void play();

    ui::BridgeInput& m_input;
    ui::SoundBoard& m_sound;
    ui::ExerciseRun& m_run;
    ui::BridgeSounds m_heard;
};

}  // namespace sagara::station
