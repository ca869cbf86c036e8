#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/assess/MissionContext.h"
#include "core/assess/Observation.h"
#include "core/assess/TaskZone.h"
#include "core/base/Config.h"

namespace sagara::core {

/// Progress of one task. The notes (a time, a heading, a place) are the task's own; their meaning is in its
/// file.
struct TaskMemory {
    bool done = false;
    SimTime doneAt;
    bool begun = false;
    double noteA = 0.0;
    double noteB = 0.0;
    NorthEast notedPlace;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.done, self.doneAt.us, self.begun, self.noteA, self.noteB, self.notedPlace);
    }
};

/// One thing to be done, judged from observations. Immutable; progress is in TaskMemory.
class Task {
public:
    Task(std::string id, std::string title) : m_id(std::move(id)), m_title(std::move(title)) {}
    virtual ~Task() = default;
    const std::string& id() const { return m_id; }
    const std::string& title() const { return m_title; }

    /// Called for the current task at every observation until it returns true.
    virtual bool step(const Observation& now, TaskMemory& memory) const = 0;
    /// Where it is to be done, if the task says so.
    virtual std::optional<TaskZone> zone() const { return std::nullopt; }

private:
    std::string m_id;
    std::string m_title;
};

/// Reads one task by its "kind": see the registry in Task.cpp.
std::unique_ptr<const Task> readTask(const config::Node& node, const MissionContext& context);

}  // namespace sagara::core
