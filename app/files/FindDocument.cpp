#include "app/files/FindDocument.h"

#include <filesystem>

#include "app/files/Files.h"
#include "core/base/Config.h"

namespace sagara::files {

core::Result<core::NamedText, std::string> findDocument(const core::DocumentSource& source,
                                                        core::DocumentKind kind,
                                                        const std::string& idOrFile) {
    if (core::config::isId(idOrFile)) {
        if (auto text = source.find(kind, idOrFile)) return core::NamedText{idOrFile, std::move(*text)};
    }
    std::error_code ignored;
    if (std::filesystem::exists(idOrFile, ignored)) {
        auto text = readTextFile(idOrFile);
        if (!text) return text.error().message;
        return core::NamedText{idOrFile, std::move(text).value()};
    }
    const std::string name = core::documentKindName(kind);
    return "there is no " + name + " \"" + idOrFile + "\" and no file of that name; see `sagara-sim list " +
           name + "s`";
}

}  // namespace sagara::files
