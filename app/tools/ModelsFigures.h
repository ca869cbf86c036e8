#pragma once

#include "app/tools/ModelsTables.h"

namespace sagara::tools {

// The figures of the founding paper. Lines that lie on each other are one, under all their names.
report::XyPlot turnFigure(const std::vector<ModelTrials>& models, core::Trial ModelTrials::*turn,
                          const TrialMarks& marks);
report::XyPlot zigzagFigure(const std::vector<ModelTrials>& models);
report::XyPlot speedFigure(const std::vector<ModelTrials>& models);
/// Of heave and pitch in head waves, of roll in beam waves. `strip`: the same hull by strip theory.
report::XyPlot responseFigure(const std::vector<ModelTrials>& models, double WaveAnswer::*motion, bool beam,
                              const report::XyPlot::Series& strip);

}  // namespace sagara::tools
