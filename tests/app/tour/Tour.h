#pragma once

#include "tests/app/tour/Screens.h"

namespace sagara::tour {

/// Every screen of the station as its users come to it: teach, train, practise, vessels, settings, demo. Some
/// minutes; or one of those parts (teach, author, train, practise, vessels, settings, demo).
void walk(Screens& screens, const std::string& only = {});

}  // namespace sagara::tour
