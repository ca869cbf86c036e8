#pragma once

#include <vector>

#include "render/link/Messages.h"

namespace sagara::test {

/// A snapshot with something in every field that travels.
core::Snapshot busySnapshot(std::int64_t tick = 500);

/// One message of every kind, with something in every field.
std::vector<link::Message> oneOfEach();

}  // namespace sagara::test
