#pragma once

#include "core/identify/SeaTrial.h"

namespace sagara::core {

/// What a trial of its kind would still need, in the words of its file.
std::vector<const char*> lackingIn(const SeaTrial& trial);

/// Headings go on over north; rudder, shaft and wave, which have to be known all the time, run straight
/// across rows without a number.
void tidy(SeaTrial& trial);

}  // namespace sagara::core
