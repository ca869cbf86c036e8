#include "tests/support/Assets.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace sagara::test {

std::string readFile(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot open " + path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string readAsset(const std::string& pathUnderAssets) {
    return readFile(std::string(SAGARA_ASSETS) + "/" + pathUnderAssets);
}

std::vector<std::string> assetIds(const std::string& folderUnderAssets) {
    std::vector<std::string> ids;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(SAGARA_ASSETS) + "/" + folderUnderAssets))
        if (entry.path().extension() == ".json") ids.push_back(entry.path().stem().string());
    std::sort(ids.begin(), ids.end());
    return ids;
}

}  // namespace sagara::test
