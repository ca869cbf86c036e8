#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Hash.h"
#include "core/base/Problems.h"
#include "core/base/Result.h"

namespace sagara::core {

class SeaHulls;

/// Pictures are only looked up: their model files lie in assets/ of every PC that draws, and so do they.
enum class DocumentKind : std::uint8_t { Vessel, Area, Scenario, Picture };
const char* documentKindName(DocumentKind kind);

/// A document as text. Its content hash names it in recordings.
struct NamedText {
    std::string name;  ///< for messages: id or file name
    std::string text;

    std::uint64_t hash() const { return hashOf(std::string_view(text)); }
    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.name, self.text);
    }
};

/// The texts one exercise is made of. A recording carries them, so that it replays anywhere.
struct ExerciseDocuments {
    NamedText scenario;
    NamedText area;
    std::vector<NamedText> vessels;
    std::shared_ptr<SeaHulls>
        hulls;  ///< of the source; not part of the texts, null where they came in a file

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.scenario, self.area, self.vessels);
    }
};

/// Where documents are looked up by id: the database, or a folder; and where what is worked out of them is
/// kept.
class DocumentSource {
public:
    virtual ~DocumentSource() = default;
    virtual std::shared_ptr<SeaHulls> hulls() const { return nullptr; }
    virtual std::optional<std::string> find(DocumentKind kind, const std::string& id) const = 0;
};

/// The scenario with the area and the vessels it names; that the pictures it names are there is checked. What
/// is not to be found is a problem at its path.
Result<ExerciseDocuments, config::Problems> collectDocuments(NamedText scenario,
                                                             const DocumentSource& source);

}  // namespace sagara::core
