#pragma once

#include <string>
#include <vector>

namespace sagara::test {

/// Text of a file under assets/.
std::string readAsset(const std::string& pathUnderAssets);
/// Names of the .json files of a folder of assets/, without the ending, sorted.
std::vector<std::string> assetIds(const std::string& folderUnderAssets);
/// Text of any file; throws when it cannot be read.
std::string readFile(const std::string& path);

}  // namespace sagara::test
