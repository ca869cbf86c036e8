#include "app/import/TextFile.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace sagara::importer {
namespace {

using core::config::Problems;

bool refuse(const std::filesystem::path& file, const char* what, const std::string& why, Problems& problems) {
    Problems own(file.filename().string());
    own.add({"", std::string(what) + " (" + why + ")", "a file at " + file.string()});
    problems.append(own);
    return false;
}

}  // namespace

std::optional<std::string> readTextFile(const std::filesystem::path& file, Problems& problems) {
    std::ostringstream text;
    std::ifstream in(file, std::ios::binary);
    if (in && std::filesystem::is_regular_file(file) && text << in.rdbuf()) return text.str();
    refuse(file, "cannot be read", std::filesystem::exists(file) ? "not a readable file" : "no such file",
           problems);
    return std::nullopt;
}

bool writeWholeFile(const std::filesystem::path& file, std::string_view text, Problems& problems) {
    const std::filesystem::path part = file.string() + ".part";
    std::error_code error;
    std::ofstream out(part, std::ios::binary | std::ios::trunc);
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    out.close();
    if (!out) {
        const std::string why = std::strerror(errno);
        std::filesystem::remove(part, error);
        return refuse(file, "cannot be written", why, problems);
    }
    std::filesystem::rename(part, file, error);
    if (!error) return true;
    const std::string why = error.message();
    std::filesystem::remove(part, error);
    return refuse(file, "cannot be written", why, problems);
}

}  // namespace sagara::importer
