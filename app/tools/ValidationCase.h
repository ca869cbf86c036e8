#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/Config.h"
#include "core/exercise/Documents.h"
#include "ui/report/ValidationReport.h"

namespace sagara::tools {

/// One number of a case against its reference.
struct ValidationRow {
    std::string quantity;
    double measured = 0.0;  ///< NaN: not reached
    double reference = 0.0;
    double tolerance = 0.0;
    bool share = false;   ///< error and tolerance over the reference; else in the unit of the quantity
    bool atMost = false;  ///< the reference is a limit: what is below it is within tolerance

    double error() const { return share ? (measured - reference) / reference : measured - reference; }
    bool ok() const { return error() <= tolerance && (atMost || error() >= -tolerance); }
};

/// What came of a case.
struct ValidationOutcome {
    std::vector<ValidationRow> rows;
    std::vector<report::XyPlot> plots;  ///< where the title is empty: that of the case
    std::vector<report::ValidationSection> sections;
    std::string trouble;  ///< why it could not be run: a vessel that is not there
};

/// Where a case finds ships and published tables.
struct ValidationContext {
    const core::DocumentSource& documents;
    std::filesystem::path folder;  ///< of the cases

    /// A published table or a hull file.
    std::filesystem::path reference(const std::string& name) const { return folder / "reference" / name; }
};

/// A kind of case: reads its members of the document and, when they are sound, runs it. Members that all
/// cases have (see README.md of assets/validation) are read before.
using RunCase = ValidationOutcome (*)(const ValidationContext& context, core::config::Reader& in);

// One line here and one in Validation.cpp for each kind.
ValidationOutcome runDecayCase(const ValidationContext& context, core::config::Reader& in);
ValidationOutcome runHydrostaticsCase(const ValidationContext& context, core::config::Reader& in);
ValidationOutcome runIkedaCase(const ValidationContext& context, core::config::Reader& in);
ValidationOutcome runLongWavesCase(const ValidationContext& context, core::config::Reader& in);
ValidationOutcome runManoeuvreCase(const ValidationContext& context, core::config::Reader& in);
ValidationOutcome runModelsCase(const ValidationContext& context, core::config::Reader& in);
ValidationOutcome runPropulsionCase(const ValidationContext& context, core::config::Reader& in);
ValidationOutcome runRaoCase(const ValidationContext& context, core::config::Reader& in);
ValidationOutcome runRollCase(const ValidationContext& context, core::config::Reader& in);
ValidationOutcome runSpectraCase(const ValidationContext& context, core::config::Reader& in);
ValidationOutcome runSquatCase(const ValidationContext& context, core::config::Reader& in);
ValidationOutcome runTimeDomainCase(const ValidationContext& context, core::config::Reader& in);
ValidationOutcome runTransferCase(const ValidationContext& context, core::config::Reader& in);
ValidationOutcome runWavesCase(const ValidationContext& context, core::config::Reader& in);
ValidationOutcome runWindCase(const ValidationContext& context, core::config::Reader& in);

}  // namespace sagara::tools
