#include "Commands.h"

#include "app/run/Console.h"
#include "app/run/RunOptions.h"
#include "db/DbError.h"

namespace sagara::sim {

CLI::App* Commands::add(const std::string& name, const std::string& what, std::function<int()> work) {
    CLI::App* command = m_app.add_subcommand(name, what);
    command->add_option("--data", m_data, "data folder (else the XDG one)");
    m_commands.push_back({command, std::move(work)});
    return command;
}

CLI::App* Commands::add(const std::string& name, const std::string& what,
                        std::function<int(run::Store&)> work) {
    return add(name, what, [this, work = std::move(work)] {
        auto store = run::Store::open(m_data);
        if (!store) return run::tell(store.error()), run::kBadRequest;
        try {
            return work(**store);
        } catch (const db::DbError& e) {
            return run::tell(e.what()), run::kMachineFailed;
        }
    });
}

int Commands::carryOut() const {
    for (const Command& command : m_commands)
        if (command.app->parsed()) return command.work();
    return run::kBadRequest;
}

}  // namespace sagara::sim
