#pragma once

#include "app/tools/ModelTrials.h"
#include "ui/report/ValidationReport.h"

namespace sagara::tools {

/// A measure of a real ship, or of published equations, that models are held against.
struct TrialMark {
    std::string name;  ///< as in core::Trial
    double value = 0.0;
};
struct TrialMarks {
    std::string from;  ///< "trials of 1977"
    std::vector<TrialMark> marks;

    std::optional<double> at(std::string_view name) const;
};

// The tables of the founding paper, filled in from what the models did.
report::SectionTable tableOfFreedoms(const std::vector<ModelTrials>& models);
report::SectionTable tableOfFeatures(const std::vector<ModelTrials>& models);
report::SectionTable tableOfResults(const std::vector<ModelTrials>& models, const TrialMarks& marks);

// Its figures.
report::XyPlot turnFigure(const std::vector<ModelTrials>& models, core::Trial ModelTrials::*turn,
                          const TrialMarks& marks);
report::XyPlot zigzagFigure(const std::vector<ModelTrials>& models);
report::XyPlot speedFigure(const std::vector<ModelTrials>& models);
/// Of heave and pitch in head waves, of roll in beam waves. `strip`: the same hull by strip theory.
report::XyPlot responseFigure(const std::vector<ModelTrials>& models, double WaveAnswer::*motion, bool beam,
                              const report::XyPlot::Series& strip);

}  // namespace sagara::tools
