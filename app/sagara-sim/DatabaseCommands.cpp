#include "Commands.h"
#include "app/run/Lists.h"
#include "app/run/ValidateDocument.h"

namespace sagara::sim {

void addValidateDocument(Commands& commands) {
    auto file = std::make_shared<std::filesystem::path>();
    commands
        .add("validate-document", "check a vessel, area, scenario, wall, command or rubric file",
             [file](run::Store& store) { return run::validateDocument(store, *file); })
        ->add_option("file", *file)
        ->required();
}

void addList(Commands& commands) {
    auto what = std::make_shared<std::string>();
    commands
        .add("list", "show what the database holds",
             [what](run::Store& store) { return run::listDatabase(store, *what); })
        ->add_option("what", *what, "vessels, areas, scenarios or runs")
        ->required()
        ->check(CLI::IsMember({"vessels", "areas", "scenarios", "runs"}));
}

void addBackup(Commands& commands) {
    auto file = std::make_shared<std::filesystem::path>();
    commands
        .add("backup", "copy the database while it is in use",
             [file](run::Store& store) { return run::backupDatabase(store, *file); })
        ->add_option("file", *file)
        ->required();
}

}  // namespace sagara::sim
