#pragma once

#include "tests/app/tour/Screens.h"

namespace sagara::tour {

/// Every screen of the station as its users come to it: teach, train, practise, vessels, settings, demo. Some
/// minutes.
void walk(Screens& screens);

}  // namespace sagara::tour
