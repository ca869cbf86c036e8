#include "tests/support/Assets.h"

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

}  // namespace sagara::test
