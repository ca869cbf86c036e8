#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "app/files/ScenarioChanges.h"
#include "core/exercise/World.h"

namespace sagara::files {

/// The documents of a scenario, by id or file name. An error lists all problems.
core::Result<core::ExerciseDocuments, std::string> collectScenario(const core::DocumentSource& source,
                                                                   const std::string& idOrFile,
                                                                   const ScenarioChanges& changes = {});

/// The exercise of a scenario, by id or file name, at another hour or in other weather if wanted. An error
/// lists all problems of its documents.
core::Result<std::shared_ptr<const core::World>, std::string> buildScenario(
    const core::DocumentSource& source, const std::string& idOrFile, std::uint64_t seed = 1,
    const ScenarioChanges& changes = {});

}  // namespace sagara::files
