#pragma once

#include <QString>
#include <QVector>

#include "core/exercise/State.h"
#include "ui/demo/DemoCameras.h"
#include "ui/demo/DemoHelm.h"
#include "ui/demo/DemoScore.h"
#include "ui/hints/Hints.h"

namespace sagara::ui {

struct DemoFigure {
    QString name;   ///< "Speed"
    QString value;  ///< "9.6 kn"
};

/// What stands under the picture.
struct DemoCaption {
    QString title;  ///< what is happening
    QVector<DemoFigure> figures;
};

/// What the pilot is doing now: "On the way to Entrance".
QString demoHappening(const core::World& world, const core::State& state, const Hints& hints);
DemoCaption demoCaption(const core::World& world, const core::State& state, const core::Snapshot& now,
                        const Hints& hints);
QString demoCamera(const core::World& world, const DemoCamera& camera);
/// "Starboard 10°", "Midships".
QString demoRudder(double rudder_rad);
/// "Half ahead", "Stop".
QString demoEngine(core::TelegraphStep step);
QString demoVerdict(DemoScore::Verdict verdict);
/// "1.2 sea miles"; under half a mile "220 m".
QString demoDistance(double distance_m);
/// "north-east"
QString demoCompass(double from_rad);

}  // namespace sagara::ui
