#include "core/exercise/Event.h"

#include "core/exercise/InstructorOrders.h"

namespace sagara::core {

const char* eventKindName(EventKind kind) {
    switch (kind) {
        case EventKind::LineLetGo:
            return "lineLetGo";
        case EventKind::LineIn:
            return "lineIn";
        case EventKind::LineParted:
            return "lineParted";
        case EventKind::AnchorLetGo:
            return "anchorLetGo";
        case EventKind::AnchorOnBottom:
            return "anchorOnBottom";
        case EventKind::AnchorDragging:
            return "anchorDragging";
        case EventKind::AnchorHome:
            return "anchorHome";
        case EventKind::CableParted:
            return "cableParted";
        case EventKind::Contact:
            return "contact";
        case EventKind::Grounding:
            return "grounding";
        case EventKind::Afloat:
            return "afloat";
        case EventKind::TaskDone:
            return "taskDone";
        case EventKind::Deduction:
            return "deduction";
        case EventKind::MissionFailed:
            return "missionFailed";
        case EventKind::Finished:
            return "finished";
        case EventKind::ScenarioEvent:
            return "scenarioEvent";
        case EventKind::FaultCame:
            return "faultCame";
        case EventKind::FaultMended:
            return "faultMended";
        case EventKind::TargetAppeared:
            return "targetAppeared";
        case EventKind::TargetGone:
            return "targetGone";
        case EventKind::LevelChanged:
            return "levelChanged";
        case EventKind::Stopped:
            return "stopped";
        case EventKind::NoteMade:
            return "noteMade";
        case EventKind::Reported:
            return "reported";
        case EventKind::TargetMoved:
            return "targetMoved";
        case EventKind::MotionsFreed:
            return "motionsFreed";
        case EventKind::GreenWater:
            return "greenWater";
        case EventKind::Slam:
            return "slam";
    }
    return "";
}

const char* reportKindName(ReportKind kind) {
    switch (kind) {
        case ReportKind::PortControl:
            return "portControl";
        case ReportKind::Anchored:
            return "anchored";
        case ReportKind::ManOverboard:
            return "manOverboard";
    }
    return "";
}

const char* componentName(std::int32_t index) {
    constexpr const char* kNames[] = {"position", "heave", "roll",  "pitch", "heading",
                                      "surge",    "sway",  "rates", "target"};
    return index >= 0 && index < 9 ? kNames[index] : "";
}

}  // namespace sagara::core
