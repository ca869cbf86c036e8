#include "core/assess/Task.h"

#include "core/assess/AnchorTask.h"
#include "core/assess/BerthTasks.h"
#include "core/assess/PassageTasks.h"

namespace sagara::core {
namespace {

using Make = std::unique_ptr<const Task> (*)(std::string id, std::string title, config::Reader& in,
                                             const MissionContext& context);

}  // namespace

std::unique_ptr<const Task> readTask(const config::Node& node, const MissionContext& context) {
    config::Reader in(node);
    std::string id = in.id("id");
    std::string title = in.text("title");
    // A new kind of task: its pair of files and one line here.
    const auto make = in.choiceIfKnown<Make>("kind", {{"spring-off", makeSpringOffTask},
                                                      {"clear-of-berth", makeClearOfBerthTask},
                                                      {"gate", makeGateTask},
                                                      {"transit", makeTransitTask},
                                                      {"anchor", makeAnchorTask}});
    if (!make) return nullptr;
    auto task = (*make)(std::move(id), std::move(title), in, context);
    in.rejectUnknownKeys();
    return task;
}

}  // namespace sagara::core
