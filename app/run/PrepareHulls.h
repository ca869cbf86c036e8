#pragma once

#include <thread>

#include "app/run/Store.h"

namespace sagara::run {

/// Makes the seakeeping tables of all vessels of the installation that have none in the database yet, one
/// after the other while the machine has nothing better to do, so that nobody waits for them when an exercise
/// begins. Its end waits for the hull at hand, a second or two at most.
class PrepareHulls final {
public:
    explicit PrepareHulls(const Store& store);

private:
    std::jthread m_worker;
};

}  // namespace sagara::run
