#include "core/world/Activity.h"

namespace sagara::core {

const char* activityName(Activity activity) {
    switch (activity) {
        case Activity::UnderWay:
            return "underWay";
        case Activity::Anchored:
            return "anchored";
        case Activity::Fishing:
            return "fishing";
        case Activity::Trawling:
            return "trawling";
        case Activity::Towing:
            return "towing";
        case Activity::NotUnderCommand:
            return "notUnderCommand";
        case Activity::Restricted:
            return "restricted";
        case Activity::Moored:
            return "moored";
        case Activity::Sailing:
            return "sailing";
    }
    return "";
}

}  // namespace sagara::core
