#pragma once

#include <memory>

#include "core/seakeeping/SeaHulls.h"

namespace sagara::test {

/// Hulls for the worlds of tests. Their tables are kept in the build folder, as a program keeps them in its
/// database, so that not every test makes them anew.
std::shared_ptr<core::SeaHulls> seaHulls();

}  // namespace sagara::test
