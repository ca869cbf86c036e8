#pragma once

#include "core/identify/StandardTrials.h"
#include "ui/vessels/PlotView.h"

namespace sagara::ui {

/// The plots of standard trials, lengths in ship lengths, with the IMO limits. Empty trials give plots that
/// say what to do.
Plot turningPlot(const core::StandardTrials& trials);
Plot zigzagPlot(const core::Trial& trial, double firstOvershootLimit_deg, double secondOvershootLimit_deg,
                double switch_deg);
Plot stoppingPlot(const core::Trial& trial);
/// Heading and rudder of a turning circle against time.
Plot turningTimePlot(const core::Trial& trial);

}  // namespace sagara::ui
