#pragma once

#include <string>

namespace sagara::test {

/// Text of a file under assets/.
std::string readAsset(const std::string& pathUnderAssets);
/// Text of any file; throws when it cannot be read.
std::string readFile(const std::string& path);

}  // namespace sagara::test
