#include "tests/support/ShippedVessels.h"

#include <algorithm>
#include <filesystem>

namespace sagara::test {

std::vector<std::string> shippedVessels() {
    std::vector<std::string> ids;
    for (const auto& entry : std::filesystem::directory_iterator(std::string(SAGARA_ASSETS) + "/vessels"))
        ids.push_back(entry.path().stem().string());
    std::sort(ids.begin(), ids.end());
    return ids;
}

std::string testName(std::string vessel) {
    std::replace(vessel.begin(), vessel.end(), '-', '_');
    return vessel;
}

}  // namespace sagara::test
