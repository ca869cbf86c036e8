#include "app/files/FindScenario.h"

#include <filesystem>

#include "app/files/Files.h"
#include "core/base/Config.h"

namespace sagara::files {

core::Result<core::NamedText, std::string> findScenario(const core::DocumentSource& source,
                                                        const std::string& idOrFile) {
    if (core::config::isId(idOrFile)) {
        if (auto text = source.find(core::DocumentKind::Scenario, idOrFile))
            return core::NamedText{idOrFile, std::move(*text)};
    }
    std::error_code ignored;
    if (std::filesystem::exists(idOrFile, ignored)) {
        auto text = readTextFile(idOrFile);
        if (!text) return text.error().message;
        return core::NamedText{idOrFile, std::move(text).value()};
    }
    return "there is no scenario \"" + idOrFile +
           "\" and no file of that name; see `sagara-sim list scenarios`";
}

}  // namespace sagara::files
