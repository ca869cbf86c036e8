#pragma once

#include <string>

#include "core/base/Result.h"
#include "core/exercise/Documents.h"

namespace sagara::files {

/// A scenario by id, or by the name of a file. Problems of the file are its reader's; here only whether there
/// is a text.
core::Result<core::NamedText, std::string> findScenario(const core::DocumentSource& source,
                                                        const std::string& idOrFile);

}  // namespace sagara::files
