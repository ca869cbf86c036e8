#pragma once

#include <string>

#include "core/base/Result.h"
#include "core/exercise/Documents.h"

namespace sagara::files {

/// A document by id, or by the name of a file. Problems of the file are its reader's; here only whether there
/// is a text. The error is for the person who named it.
core::Result<core::NamedText, std::string> findDocument(const core::DocumentSource& source,
                                                        core::DocumentKind kind, const std::string& idOrFile);

}  // namespace sagara::files
