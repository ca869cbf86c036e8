#pragma once

namespace sagara::core {

/// Newest version of the scenario document that is read here.
inline constexpr int kScenarioDocumentVersion = 1;

}  // namespace sagara::core
