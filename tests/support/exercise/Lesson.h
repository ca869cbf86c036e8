#pragma once

#include <memory>
#include <string>

#include "core/exercise/Documents.h"
#include "core/exercise/World.h"
#include "tests/support/hulls/Tables.h"

namespace sagara::test {

/// Documents of the source tree's assets/, with others put over them by id.
class TreeSource final : public core::DocumentSource {
public:
    std::shared_ptr<core::SeaHulls> hulls() const override { return seaHulls(); }
    std::optional<std::string> find(core::DocumentKind kind, const std::string& id) const override;
};

/// Text of the shipped lesson.
std::string lessonText();
/// The lesson with a part replaced: JSON pointer and new value as JSON, for example ("/level", "3"). An empty
/// value removes the part.
std::string lessonWith(const std::string& pointer, const std::string& json);
std::string with(const std::string& text, const std::string& pointer, const std::string& json);

core::ExerciseDocuments documentsOf(const std::string& scenarioText);
/// Throws with the problems when it cannot be built.
std::shared_ptr<const core::World> worldOf(const std::string& scenarioText, std::uint64_t seed = 1);
std::shared_ptr<const core::World> lessonWorld(std::uint64_t seed = 1);
/// Problems of a scenario text, one a line; empty when it builds.
std::string problemsOf(const std::string& scenarioText);

/// An exercise in open water with so many own ships and targets, no mission, Beaufort 5.
std::string openWaterScenario(int ownShips, int targets);

}  // namespace sagara::test
