#include "tests/support/hulls/Tables.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/base/Archive.h"

namespace sagara::test {
namespace {

namespace fs = std::filesystem;

class FolderCache final : public core::TableCache {
public:
    std::optional<core::SeakeepingTables> find(std::uint64_t inputHash) override {
        std::ifstream file(pathOf(inputHash), std::ios::binary);
        if (!file) return std::nullopt;
        const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
        return core::fromBytes<core::SeakeepingTables>(std::as_bytes(std::span(bytes)));
    }
    /// Tests run side by side: whole or not at all.
    void keep(const core::SeakeepingTables& tables) override {
        fs::create_directories(SAGARA_TEST_TABLES);
        const fs::path path = pathOf(tables.inputHash), half = path.string() + "." + std::to_string(getpid());
        const core::Bytes bytes = core::toBytes(tables);
        std::ofstream(half, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        fs::rename(half, path);
    }

private:
    static fs::path pathOf(std::uint64_t hash) { return fs::path(SAGARA_TEST_TABLES) / std::to_string(hash); }
};

}  // namespace

std::shared_ptr<core::SeaHulls> seaHulls() {
    static const auto hulls = std::make_shared<core::SeaHulls>(std::make_shared<FolderCache>());
    return hulls;
}

}  // namespace sagara::test
