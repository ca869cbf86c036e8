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

}  // namespace sagara::tools
