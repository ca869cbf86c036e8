#pragma once

#include <cstdint>
#include <string>

namespace sagara::station {

/// What is to be sailed, by whom and as what.
struct RunRequest {
    std::string scenario;  ///< id or file
    int level = 3;
    std::uint64_t seed = 1;
    std::string type = "train";  ///< as db::RunType
    std::string trainee;         ///< empty: nobody named
    bool pilot = false;          ///< the scripted pilot has the ship at the start
};

}  // namespace sagara::station
