#pragma once

#include <QString>
#include <vector>

#include "ui/debrief/DebriefPorts.h"

namespace sagara::ui {

enum class MarkKind { Task, Deduction, Failure, Event, Weather, Note };

/// A moment of a run worth going to.
struct DebriefMark {
    core::SimTime time;
    MarkKind kind = MarkKind::Event;
    QString text;
    double points = 0.0;    ///< lost, of a deduction
    core::NorthEast place;  ///< of the graded ship then
};

/// What happened, in the order of time: of the run itself, of the trainer's orders, and what was noted.
std::vector<DebriefMark> marksOf(const Replay& replay, const std::vector<DebriefNote>& notes);

/// The track sample at or last before a time; null for an empty track.
const core::TrackSample* sampleAt(const std::vector<core::TrackSample>& track, core::SimTime time);

/// "Weather ordered: wind 25 kn from 240°, visibility 1.0 M, over 60 s".
QString weatherOrderText(const core::WeatherOrder& order);

}  // namespace sagara::ui
