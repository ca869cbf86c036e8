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
QString happeningText(const core::World& world, const core::State& state, const Hints& hints);
DemoCaption captionOf(const core::World& world, const core::State& state, const core::Snapshot& now,
                      const Hints& hints);
QString cameraText(const core::World& world, const DemoCamera& camera);
/// "Starboard 10°", "Midships".
QString rudderText(double rudder_rad);
/// "Half ahead", "Stop".
QString engineText(core::TelegraphStep step);
QString verdictText(DemoScore::Verdict verdict);
/// "north-east"
QString compassText(double from_rad);

}  // namespace sagara::ui
