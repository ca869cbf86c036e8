#include "tests/ui/report/PdfReader.h"

#include <unistd.h>

#include <cstdlib>

#include "tests/support/Assets.h"

namespace sagara::report::test {
namespace {

namespace fs = std::filesystem;

class ScratchFolder {
public:
    ScratchFolder() : m_path(fs::temp_directory_path() / ("sagara-report-" + std::to_string(::getpid()))) {
        fs::create_directories(m_path);
    }
    ~ScratchFolder() {
        std::error_code ignored;
        fs::remove_all(m_path, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    const fs::path& path() const { return m_path; }

private:
    fs::path m_path;
};

}  // namespace

fs::path outFolder() {
    if (const char* kept = std::getenv("SAGARA_REPORT_OUT")) {
        fs::create_directories(kept);
        return kept;
    }
    static const ScratchFolder scratch;
    return scratch.path();
}

fs::path written(const RunReport& report, const std::string& name) {
    const fs::path path = outFolder() / (name + ".pdf");
    writeReport(report, path.string());
    return path;
}

bool canReadPdf() { return std::system("pdftotext -v >/dev/null 2>&1") == 0; }

std::vector<std::string> pagesOf(const fs::path& pdf) {
    const fs::path text = outFolder() / (pdf.stem().string() + ".txt");
    const std::string command = "pdftotext -layout '" + pdf.string() + "' '" + text.string() + "'";
    if (std::system(command.c_str()) != 0) return {};
    const std::string all = sagara::test::readFile(text.string());
    std::vector<std::string> pages;
    for (std::size_t from = 0, to; (to = all.find('\f', from)) != std::string::npos; from = to + 1) {
        pages.push_back(all.substr(from, to - from));
    }
    return pages;
}

std::size_t countedPages(const fs::path& pdf) {
    const std::string all = sagara::test::readFile(pdf.string());
    const std::string page = "/Type /Page";
    std::size_t count = 0;
    for (std::size_t at = all.find(page); at != std::string::npos; at = all.find(page, at + 1)) {
        if (all[at + page.size()] != 's') ++count;  // "/Type /Pages" is the tree of them
    }
    return count;
}

}  // namespace sagara::report::test
