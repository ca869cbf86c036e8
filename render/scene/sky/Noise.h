#pragma once

#include <cstdint>
#include <vector>

namespace sagara::render {

/// Square of grey pixels that repeats: five octaves of value noise, spread over 0 to 255. Fixed seed.
std::vector<std::uint32_t> cloudNoise(int size);

}  // namespace sagara::render
