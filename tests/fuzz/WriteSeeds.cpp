// Writes one true message of every kind into a folder, for a fuzzer to begin with: write-seeds FOLDER
#include <filesystem>
#include <fstream>

#include "render/link/Codec.h"
#include "tests/render/support/Samples.h"

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    char kind = 0;
    for (const auto& message : sagara::test::oneOfEach()) {
        const sagara::core::Bytes packet = sagara::link::encode(message);
        const auto* bytes = reinterpret_cast<const char*>(packet.data());
        const std::string name = sagara::link::kindName(static_cast<sagara::link::Kind>(++kind));
        // As a stream, and as a payload.
        std::ofstream(folder / (name + ".stream"), std::ios::binary)
            << '\0' << std::string_view(bytes, packet.size());
        std::ofstream(folder / (name + ".payload"), std::ios::binary)
            << kind << std::string_view(bytes + 12, packet.size() - 12);
    }
    return 0;
}
