#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/run/Store.h"

namespace sagara::sim {

/// The subcommands of sagara-sim. Each is added by a function of a file of its own: it declares the options,
/// which fill a struct of the room that does the work, and says which function of that room is called.
class Commands {
public:
    explicit Commands(CLI::App& app) : m_app(app) {}

    /// `work` returns the exit code; it is called after all options are read.
    CLI::App* add(const std::string& name, const std::string& what, std::function<int()> work);
    /// The same with the data folder; a database that fails ends it with a message.
    CLI::App* add(const std::string& name, const std::string& what, std::function<int(run::Store&)> work);

    /// What was asked for. Needs a QGuiApplication: fonts and PDF do.
    int carryOut() const;

private:
    struct Command {
        CLI::App* app;
        std::function<int()> work;
    };
    CLI::App& m_app;
    std::vector<Command> m_commands;
    std::optional<std::filesystem::path> m_data;
};

// One line here and one in main.cpp for each.
void addRun(Commands& commands);
void addReplay(Commands& commands);
void addWall(Commands& commands);
void addValidateDocument(Commands& commands);
void addList(Commands& commands);
void addBackup(Commands& commands);
void addManoeuvre(Commands& commands);
void addDecay(Commands& commands);
void addForces(Commands& commands);
void addPilotCard(Commands& commands);
void addValidate(Commands& commands);
void addSea(Commands& commands);
void addWindLoad(Commands& commands);
void addSquat(Commands& commands);
void addRao(Commands& commands);
void addHydrostatics(Commands& commands);
void addIdentify(Commands& commands);

}  // namespace sagara::sim
